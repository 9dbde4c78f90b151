// SPDX-License-Identifier: MIT
// Motions chained by hand: by mouse, and only by keyboard and assistive tools. Each scenario opens its own page.
import assert from 'node:assert/strict';
import { activate, setValue, settle } from '../assistive.mjs';
import { Mouse } from '../pointers.mjs';
import { nativeHash } from '../native.mjs';
import { ONE_BROWSER, PageDriver } from '../page_driver.mjs';
import { stateOf } from './history.mjs';

/** @typedef {import('./all.mjs').Visit} Visit */

/** The starts of the clips, in steps, and the end. @param {PageDriver} page @returns {Promise<number[]>} */
const borders = (page) => page.call('borders', () => {
  const { timeline, duration_steps: end } = /** @type {any} */ (window.gaitsmith.document());
  return [...timeline.map((/** @type {any} */ clip) => clip.start_step ?? 0), end];
});
/** The controllers of the clips. @param {PageDriver} page @returns {Promise<number[]>} */
const order = (page) => page.call('order', () =>
  /** @type {any} */ (window.gaitsmith.document()).timeline.map((/** @type {any} */ clip) => clip.controller ?? 0));

/** Undoes all changes and compares the state. @param {PageDriver} page @param {string} before @param {number} maxSteps */
async function backTo(page, before, maxSteps) {
  for (let step = 0; step < maxSteps && await page.call('undo', () => window.gaitsmith.commands().some(({ id, whyNot }) =>
    id === 'document/undo' && !whyNot)); step++) {
    await page.press('Control+z');
  }
  assert.equal(await stateOf(page), before);
}

/** The shown motion is the same in the command line. @param {PageDriver} page */
async function sameNatively(page) {
  const text = await page.call('document', () => JSON.stringify(window.gaitsmith.document()));
  const native = await nativeHash(text);
  if (native) assert.equal(await page.call('hash', () => window.gaitsmith.hash()), native);
}

/** @param {Visit} visit */
async function byMouse({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  const pointer = new Mouse(page);
  const before = await stateOf(page);
  const [, length] = await borders(page);

  await page.click('timeline/add');
  await page.click('timeline/mirror');
  assert.deepEqual([await borders(page), await order(page)], [[0, length, 2 * length], [0, 1]]);

  // Drag the border between the clips halfway to the left. It snaps to a half second.
  const border = await pointer.centre('timeline/switch/1');
  const first = await pointer.centre('timeline/clip/0');
  await pointer.drag(border, { x: first.x, y: border.y });
  const [, moved, end] = await borders(page);
  assert.ok(moved > 0.4 * length && moved < 0.6 * length, `the border went to ${moved}`);
  assert.equal(end, 2 * length);

  // Drag the second clip before the first. Each keeps its length.
  const shortened = await pointer.centre('timeline/clip/0');
  await pointer.drag(await pointer.centre('timeline/clip/1'), { x: shortened.x - 30, y: shortened.y });
  assert.deepEqual([await borders(page), await order(page)], [[0, end - moved, end], [1, 0]]);

  // Drag the end of the motion there and back.
  const edge = await pointer.centre('timeline/end');
  await pointer.drag(edge, { x: edge.x - 60, y: edge.y });
  const shorter = (await borders(page))[2];
  assert.ok(shorter < end - 20, `from ${end} to ${shorter}`);

  // Split the first clip in its middle.
  const scrub = (await page.widgets()).find(({ id }) => id === 'transport/scrub')?.rect ?? assert.fail('no scrub bar');
  await page.clickAt(scrub.x + 0.3 * scrub.width, scrub.y + scrub.height / 2);
  await page.click('timeline/split');
  assert.equal((await order(page)).length, 3);
  await page.click('timeline/duplicate');
  await page.click('timeline/remove');
  assert.equal((await order(page)).length, 3);
  await sameNatively(page);
  await backTo(page, before, 20);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function byKeys({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  const before = await stateOf(page);
  const [, length] = await borders(page);
  await page.press('Home');
  await page.press('d');
  await page.press('m');
  await page.press('[');
  await page.press(']');
  assert.deepEqual([await borders(page), await order(page)], [[0, length, 2 * length], [0, 1]]);
  // Like a user of a screen reader: the border is a slider of the page.
  await setValue(page, 'slider', 'Border 1 of 1: clip 2 takes over', '2.5');
  assert.deepEqual(await borders(page), [0, 250, 2 * length]);
  const shuffle = (await page.widgets()).find(({ label }) => /^Clip [12] of 2: Shuffle$/.test(label));
  assert.ok(shuffle, 'clips say which they are');
  await activate(page, 'option', shuffle.label);
  await setValue(page, 'slider', 'Time', '1');
  await page.press('b');
  await settle(page);
  assert.deepEqual(await borders(page), [0, 100, 250, 2 * length]);
  await activate(page, 'button', 'Remove the selected clip');
  assert.equal((await order(page)).length, 2);
  await sameNatively(page);
  await backTo(page, before, 20);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function withResults({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  const pointer = new Mouse(page);
  await page.call('a short search', () => window.gaitsmith.synthesize({ algorithm: 'sphc', evaluations: 400, sense: 'timer', seed: 4 }));
  await page.call('back', () => window.gaitsmith.run('document/undo'));
  await page.click('panels/3');
  const id = (await page.call('results', () => window.gaitsmith.results()))[0].id;
  await page.call('time', () => { window.gaitsmith.run('motion/end'); });
  await pointer.press(`found/${id}/insert`);
  const [, length, end] = await borders(page);
  assert.ok(end > length);
  assert.deepEqual(await order(page), [0, 1]);
  // Repair the clip: search from the state at its takeover.
  const spoiled = await page.call('hash', () => window.gaitsmith.hash());
  await page.click('timeline/repair');
  await page.until('the end of the repair', () => /^Search (done|stopped)/.test(document.querySelector('#status')?.textContent ?? ''));
  assert.deepEqual(await borders(page), [0, length, end]);
  assert.notEqual(await page.call('hash', () => window.gaitsmith.hash()), spoiled);
  await sameNatively(page);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** Waits until the clip's transition map is complete. @param {PageDriver} page */
const mapped = (page) => page.until('the transition map', () => window.gaitsmith.widgets().some(({ id, value }) =>
  id === 'timeline/transitions' && value.startsWith('best at')));

/** @param {Visit} visit */
async function snapsToBest({ browser, address, name, figures }) {
  const page = await PageDriver.open(browser, address);
  const [, length] = await borders(page);
  const strip = async () => (await page.widgets()).find(({ id }) => id === 'timeline/transitions');
  assert.equal(await strip(), undefined);
  const start = Date.now();
  await page.click('timeline/add');
  await page.click('timeline/mirror'); // the image begins badly where the original ends
  await mapped(page);
  figures['transition map of 10 s, from the press on (ms)'] = Date.now() - start;
  const map = await strip();
  assert.equal(map?.role, 'img');
  await page.click('timeline/snap-to-best');
  // The status line says where the switch went, and the strip and the clip agree about it.
  const status = await page.call('status', () => document.querySelector('#status')?.textContent ?? '');
  const good = 100 * Number(/^Switch moved to ([0-9.]+) s, the nearest good moment\.$/.exec(status)?.[1]);
  assert.deepEqual(await borders(page), [0, Math.round(good), 2 * length], status);
  const [, percent] = /now (\d+) % \(good\)$/.exec((await strip())?.value ?? '') ?? [];
  const hint = `clip 2 takes over: good, ${percent} % of its usual score`;
  const mirrored = () => page.call('texts', () => document.body.textContent ?? '');
  for (let tries = 0; tries < 50 && !(await mirrored()).includes(hint); tries++) await page.frames(4);
  assert.ok((await mirrored()).includes(hint), hint);
  assert.equal(await page.call('again', () => window.gaitsmith.run('timeline/snap-to-best')), false);
  await page.press('Control+z');
  assert.deepEqual(await borders(page), [0, length, 2 * length]);
  await activate(page, 'button', 'Snap to best: move the switch to the nearest good moment');
  assert.deepEqual(await borders(page), [0, Math.round(good), 2 * length]);
  // Once the canvas shows a button as possible, assistive tools can press it, even before the mirror's next update.
  await page.call('undo, and at once again', async () => {
    const id = 'timeline/snap-to-best';
    window.gaitsmith.run('document/undo');
    while (window.gaitsmith.widgets().find((widget) => widget.id === id)?.state.disabled) await new Promise(requestAnimationFrame);
    /** @type {HTMLElement | null} */ (document.querySelector(`button[data-id="${id}"]`))?.click();
  });
  await settle(page);
  assert.deepEqual(await borders(page), [0, Math.round(good), 2 * length]);
  await sameNatively(page);
  // An earlier change restarts the map. Without a clip that takes over there is no map.
  await page.call('world', () => { window.gaitsmith.run('document/undo'); });
  await page.click('timeline/clip/0');
  await page.until('the end of the strip', () => !window.gaitsmith.widgets().some(({ id }) => id === 'timeline/transitions'));
  assert.deepEqual(page.complaints, [], name);
  await page.close();
}

/** @param {Visit} visit */
async function oneRuler({ browser, address }) {
  for (const phone of [false, true]) {
    const page = await PageDriver.open(browser, address);
    if (phone) await page.becomePhone();
    const rectOf = async (/** @type {string} */ id) => (await page.widgets()).find((widget) => widget.id === id)?.rect ?? assert.fail(`no ${id}`);
    if (phone) await page.call('timeline', () => window.gaitsmith.run('panel/Timeline'));
    await page.click('timeline/add');
    const scrub = await rectOf('transport/scrub');
    const [first, border, end] = [await rectOf('timeline/clip/0'), await rectOf('timeline/switch/1'), await rectOf('timeline/end')];
    const middle = ({ x = 0, width = 0 }) => x + width / 2;
    assert.ok(Math.abs(first.x - scrub.x) < 1, `clips begin at ${first.x}, the scrubber at ${scrub.x}`);
    assert.ok(Math.abs(middle(end) + 2 - (scrub.x + scrub.width)) < 1.5, `clips end at ${middle(end)}, the scrubber at ${scrub.x + scrub.width}`);
    // The border's moment is at the same x on the scrubber.
    const [, start, last] = await borders(page);
    await page.clickAt(middle(border) + 2, scrub.y + scrub.height / 2);
    const seconds = Number.parseFloat((await page.widgets()).find(({ id }) => id === 'transport/scrub')?.value ?? '');
    assert.ok(Math.abs(100 * seconds - start) < 1 + last / scrub.width, `${seconds} s at the border of step ${start}`);
    assert.deepEqual(page.complaints, []);
    await page.close();
  }
}

/** @param {PageDriver} page @returns {Promise<any>} */
const documentOf = (page) => page.call('document', () => window.gaitsmith.document());
/** Waits until the plan is carried out. @param {PageDriver} page */
const planned = (page) => page.until('a planned motion', () => (/** @type {any} */ (window.gaitsmith.document()).plan?.solved?.unknowns?.length ?? 0) > 0);

/** A jump between keyframes: planned in its own worker, changed by mouse and keys, refused where it cannot be, undone. @param {Visit} visit */
async function keyframes({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  const pointer = new Mouse(page);
  const before = await page.hash();
  await page.call('keyframes', () => window.gaitsmith.run('timeline/keyframes'));
  await planned(page);
  const jump = await documentOf(page);
  assert.equal(jump.controllers.at(-1).kind, 'trajectory');
  assert.equal(jump.plan.stances.length, 4);
  assert.match(await page.text('#status'), /^Planned/);
  const hash = await page.hash();
  assert.notEqual(hash, before);
  await sameNatively(page);

  // The end of a bar, by mouse: the figure lands later.
  await pointer.scrollTo('keyframes/stance/1/from', 20);
  const end = await pointer.centre('keyframes/stance/1/from');
  await pointer.drag(end, { x: end.x + 12, y: end.y });
  const later = await documentOf(page);
  assert.ok(later.plan.stances[1].first_step > jump.plan.stances[1].first_step);
  await planned(page);

  // A mark, by keys: farther.
  await page.page.focus('canvas');
  await setValue(page, 'slider', 'Along the ground', '0.9');
  await page.frames(20);
  await planned(page);
  assert.equal((await documentOf(page)).plan.keyframes[0].marks[0].x_m, 0.9);

  // The ring on the stage, by mouse: farther still. It is there with its panel only.
  await page.play(false);
  await page.frames(4);
  const ring = await pointer.centre('stage/mark/0/0');
  await pointer.drag(ring, { x: ring.x + 30, y: ring.y - 20 });
  await page.frames(6);
  await planned(page);
  const dragged = (await documentOf(page)).plan.keyframes[0].marks[0].x_m;
  assert.ok(dragged > 1, `the mark is at ${dragged} m`);

  // A curve of a joint, by keys: the keyframe asks for another angle.
  await page.call('a moment without a keyframe', () => {
    window.gaitsmith.run('motion/start');
    for (let frame = 0; frame < 60; frame++) window.gaitsmith.run('motion/forward');
  });
  await pointer.press('keyframes/add');
  await page.frames(6);
  assert.equal((await documentOf(page)).plan.keyframes.length, 2);
  await planned(page);
  await pointer.press('keyframes/view/1');
  await pointer.scrollTo('keyframes/curves', 40);
  const angleOf = async () => (await documentOf(page)).plan.keyframes.find((/** @type {any} */ { pose }) => pose?.length)?.pose[0].angle_rad ?? 0;
  const bent = await angleOf();
  await setValue(page, 'slider', 'Angle 1 of keyframe 1', '20');
  await page.frames(6);
  assert.ok(Math.abs(await angleOf() - bent) > 0.01, 'the joint is bent');
  await page.press('Control+z');
  await page.press('Control+z');
  await planned(page);

  // Nobody jumps ten metres off the ground from standing with both feet down.
  await page.call('a mark far up', () => window.gaitsmith.open(JSON.stringify({ ...window.gaitsmith.document(),
    plan: { ...(/** @type {any} */ (window.gaitsmith.document())).plan, solved: undefined,
      keyframes: [{ step: 30, marks: [{ endpoint: -1, axes: 'up', y_m: 10 }] }] } })));
  await page.until('a refusal', () => /cannot be so high at 0\.30 s: [\d.]+ m are missing/.test(document.querySelector('#status')?.textContent ?? ''));
  await page.press('Control+z');
  await page.frames();
  assert.equal((await documentOf(page)).plan.keyframes[0].marks[0].x_m, dragged, 'the plan is back');

  // Rules that track it: a search begins, and what it finds is driven by rules.
  await page.call('track', () => window.gaitsmith.run('timeline/track'));
  await page.until('a search', () => /** @type {any} */ (window.gaitsmith.document()).controllers.at(-1).kind === undefined || /** @type {any} */ (window.gaitsmith.document()).controllers.at(-1).kind === 'rules');
  assert.ok((await documentOf(page)).task.shown.way.length > 2);
  await page.call('stop', () => window.gaitsmith.stop?.());
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @type {[string, (visit: Visit) => Promise<void>, string?][]} */
export const TIMELINE_SCENARIOS = [
  ['a jump is planned between keyframes, changed by mouse and keys, refused and undone', keyframes],
  ['clips are chained by mouse, and undone', byMouse],
  ['clips are chained by keys and assistive tools alone', byKeys],
  ['the clips and the scrubber share one ruler', oneRuler, ONE_BROWSER],
  ['a clip snaps to the nearest good moment of its transition map', snapsToBest, ONE_BROWSER],
  ['a result is chained, and repaired from where it takes over', withResults, ONE_BROWSER],
];
