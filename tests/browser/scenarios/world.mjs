// SPDX-License-Identifier: MIT
// Changes of a figure's world, by number and by hand. Each scenario opens its own pages.
import assert from 'node:assert/strict';
import { Fingers } from '../pointers.mjs';
import { ONE_BROWSER, PageDriver } from '../page_driver.mjs';

/** @typedef {import('./all.mjs').Visit} Visit */

/** @param {PageDriver} page */
const pushes = (page) => page.call('pushes', () => window.gaitsmith.document().pushes ?? []);
/** @param {PageDriver} page @param {string} id */
const widget = async (page, id) => (await page.widgets()).find((candidate) => candidate.id === id);

/** Turns the wheel over the World card. @param {PageDriver} page @param {number} deltaY */
async function scroll(page, deltaY) {
  const button = (await widget(page, 'world/open'))?.rect ?? { x: 0, y: 0, height: 0 };
  await page.page.mouse.move(button.x, button.y + button.height + 100);
  await page.page.mouse.wheel({ deltaY });
  await page.frames();
}

/** @param {Visit} visit */
async function byNumber({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  const calm = await page.hash();
  await page.click('world/open');
  await page.click('world/push');
  assert.equal((await pushes(page)).length, 1);
  assert.match(await page.status(), /^Pushed with 5\.0 N s at \d\.\d\d s\.$/);
  const pushed = await page.hash();
  assert.notEqual(pushed, calm);
  const link = await page.link();
  const other = await PageDriver.open(browser, link);
  assert.equal(await other.hash(), pushed, 'a link carries the push');
  assert.equal((await pushes(other)).length, 1);
  await other.close();
  await page.click('world/remove/0');
  assert.equal(await page.hash(), calm, 'without the push, the motion it was');

  await page.page.mouse.move(10, 300); // away from the panel
  await page.click('world/slope'); // the middle of its track is level
  for (let k = 0; k < 4; k++) {
    await page.page.keyboard.press('ArrowRight', { delay: 60 });
    await page.frames();
  }
  const slope = await page.call('slope', () => window.gaitsmith.document().environment?.slope_rad ?? 0);
  assert.ok(slope > 0, `the ground rises by ${slope}`);
  assert.notEqual(await page.hash(), calm);
  const level = await page.hash();
  await page.click('world/sway');
  assert.notEqual(await page.hash(), level, 'ground that rocks');
  assert.ok(await widget(page, 'world/sway-period'), 'how fast it rocks can be set');
  await scroll(page, 2000);
  await page.click('world/reset');
  assert.equal(await page.hash(), calm, 'reset');
  assert.equal((await widget(page, 'world/reset'))?.state.disabled, true);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** Joints that give way: the same rules, another motion, which a link carries. @param {Visit} visit */
async function limitedJoints({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  const unlimited = await page.hash();
  await page.click('world/open');
  await scroll(page, 400);
  await page.click('world/joints/1');
  assert.equal(await page.call('model', () => window.gaitsmith.document().model), 2);
  const limited = await page.hash();
  assert.notEqual(limited, unlimited);
  const other = await PageDriver.open(browser, await page.link());
  assert.equal(await other.hash(), limited, 'a link carries the joints');
  await other.close();
  const strength = await widget(page, 'world/joint-strength');
  assert.equal(strength?.value, '2.0 like an animal');
  await page.click('world/joint-strength');
  await page.press('ArrowLeft');
  const changed = (await widget(page, 'world/joint-strength'))?.value ?? '';
  assert.match(changed, /^3\.\d like an animal$/, 'about the middle of the slider');
  assert.notEqual(await page.hash(), limited);
  await page.click('world/joints/0');
  assert.equal(await page.hash(), unlimited, 'strong enough again');
  await page.click('world/joints/1');
  await scroll(page, 2000);
  await page.click('world/reset');
  assert.equal(await page.hash(), unlimited, 'reset');
  assert.equal(await page.call('strength', () => JSON.stringify(window.gaitsmith.document()).includes('strength')), false);
  // Rods that are too unequal for limited joints.
  await page.call('open', () => window.gaitsmith.open({ figure: { rods: [{ mass_kg: 40 }, { parent: 0, mass_kg: 0.05 }] } }));
  const warns = () => /The heaviest rod weighs 800 times as much as the lightest/.test(document.querySelector('#mirror')?.textContent ?? '');
  await page.until('no warning of strong joints', () => /They always reach the pose/.test(document.querySelector('#mirror')?.textContent ?? ''));
  assert.equal(await page.call('warning', warns), false);
  await page.click('world/joints/1');
  await page.until('a warning', warns);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {PageDriver} page @returns {Promise<{x_m?: number, y_m?: number}[]>} */
const corners = (page) => page.call('ground', () => window.gaitsmith.document().environment?.ground ?? []);

/** Scrolls the World card until a control is in sight. @param {PageDriver} page @param {string} id */
async function reveal(page, id) {
  for (const way of [150, -150]) {
    for (let turn = 0; turn < 12; turn++) {
      const found = await widget(page, id);
      const card = await widget(page, 'stage');
      if (found && card && found.rect.height >= 17 && found.rect.y + found.rect.height < card.rect.y + card.rect.height - 20) return;
      await scroll(page, way);
    }
  }
  assert.fail(`${id} is not on the World card`);
}

/** Clicks a control of the World card. @param {PageDriver} page @param {string} id */
async function press(page, id) {
  await reveal(page, id);
  await page.click(id);
}

/** Chooses an entry of the list of grounds. @param {PageDriver} page @param {number} which */
async function chooseGround(page, which) {
  await press(page, 'world/ground');
  await page.click(`world/ground/${which}`);
}

/** Draws a line with the mouse, through shares of the stage's size. @param {PageDriver} page @param {[number, number][]} line */
async function drawLine(page, [first, ...rest]) {
  const stage = await page.placeOf('stage');
  const at = (/** @type {[number, number]} */ [x, y]) => /** @type {[number, number]} */ ([stage.x + x * stage.width, stage.y + y * stage.height]);
  await page.page.mouse.move(...at(first));
  await page.frames();
  await page.page.mouse.down();
  await page.frames();
  for (const point of rest) {
    await page.page.mouse.move(...at(point), { steps: 6 });
    await page.frames();
  }
  await page.page.mouse.up();
  await page.frames(4);
}

/** Ground that is chosen: limited joints, which stay locked, and a link that carries it. @param {Visit} visit */
async function groundByName({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  const level = await page.hash();
  await page.click('world/open');
  await chooseGround(page, 2);
  assert.equal((await widget(page, 'world/ground'))?.value, 'Stairs');
  assert.equal((await corners(page)).length, 56);
  assert.equal(await page.call('model', () => window.gaitsmith.document().model), 2);
  assert.match(await page.status(), /joints of limited strength, so they are limited now/);
  const stairs = await page.hash();
  assert.notEqual(stairs, level);
  const other = await PageDriver.open(browser, await page.link());
  assert.equal(await other.hash(), stairs, 'a link carries the ground');
  assert.equal((await corners(other)).length, 56);
  await other.close();
  await chooseGround(page, 6);
  const first = await corners(page);
  await press(page, 'world/rubble/more');
  assert.notDeepEqual(await corners(page), first, 'another rubble');
  await press(page, 'world/rubble/less');
  assert.deepEqual(await corners(page), first, 'the same rubble again');
  await reveal(page, 'world/joints/0');
  assert.equal((await widget(page, 'world/joints/0'))?.state.disabled, true, 'drawn ground needs limited joints');
  await press(page, 'world/joints/0');
  assert.equal(await page.call('model', () => window.gaitsmith.document().model), 2);
  await chooseGround(page, 0);
  assert.equal((await corners(page)).length, 0);
  await press(page, 'world/joints/0');
  assert.equal(await page.hash(), level, 'level, with joints as strong as needed');
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function groundByHand({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  const level = await page.hash();
  await page.click('world/open');
  await press(page, 'world/ground-draw');
  await page.until('the tools', () => window.gaitsmith.widgets().some(({ id }) => id === 'stage/ground-done'));
  // A block with steep sides, which become vertical.
  await drawLine(page, [[0.32, 0.66], [0.325, 0.5], [0.45, 0.5], [0.455, 0.66]]);
  const block = await corners(page);
  assert.equal(block.length, 4, JSON.stringify(block));
  assert.ok(block[0].x_m === block[1].x_m && block[2].x_m === block[3].x_m && (block[1].y_m ?? 0) > 0.3, JSON.stringify(block));
  assert.equal((await widget(page, 'world/ground'))?.value, 'Hand-drawn');
  const drawn = await page.hash();
  // A line over a part of it replaces that part, and Undo brings it back.
  await drawLine(page, [[0.36, 0.5], [0.38, 0.8], [0.42, 0.8], [0.43, 0.5]]);
  assert.ok((await corners(page)).length > 4);
  await page.press('Control+z');
  assert.deepEqual(await corners(page), block);
  assert.equal(await page.hash(), drawn);
  // A corner that is dragged, chosen and deleted.
  await drawLine(page, [[0.325, 0.5], [0.36, 0.4]]);
  const moved = await corners(page);
  assert.equal(moved.length, 4);
  assert.ok((moved[1].x_m ?? 0) > (block[1].x_m ?? 0) && (moved[1].y_m ?? 0) > (block[1].y_m ?? 0), JSON.stringify(moved));
  const stage = await page.placeOf('stage');
  // The drag has chosen it. A press lets it go, another one chooses it again.
  for (const disabled of [true, false]) {
    await page.clickAt(stage.x + 0.36 * stage.width, stage.y + 0.4 * stage.height);
    assert.equal((await widget(page, 'stage/corner-remove'))?.state.disabled, disabled);
  }
  await page.press('Delete');
  assert.equal((await corners(page)).length, 3);
  await page.press('Escape');
  assert.equal(await widget(page, 'stage/ground-done'), undefined, 'Escape ends drawing');
  assert.equal((await corners(page)).length, 3, 'what was drawn stays');
  // With the keyboard: corners are numbers.
  await press(page, 'world/corners');
  await press(page, 'world/corner/more');
  await reveal(page, 'world/corner');
  assert.equal((await widget(page, 'world/corner'))?.value, '2');
  const [, second] = await corners(page);
  await press(page, 'world/corner-height');
  await page.press('ArrowRight');
  assert.notEqual((await corners(page))[1].y_m, second.y_m);
  await press(page, 'world/corner-add');
  assert.equal((await corners(page)).length, 4);
  await press(page, 'world/corner-remove');
  assert.equal((await corners(page)).length, 3);
  await press(page, 'world/reset');
  assert.equal(await page.hash(), level, 'reset');
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** A controller that sees a step before it: chosen, searched for, shown in its rules, told how far to look. @param {Visit} visit */
async function sight({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  await page.click('world/open');
  await chooseGround(page, 1);
  await page.page.evaluate(() => window.gaitsmith.run('panel/Controller'));
  await page.click('controller/senses/2');
  await page.click('controller/facing/1');
  assert.equal(await page.call('facing', () => /** @type {any} */ (window.gaitsmith.document()).senses.facing), 'left');
  await page.click('controller/facing/0');
  await page.call('a search', () => window.gaitsmith.synthesize({ evaluations: 400, seed: 1, algorithm: 'pose-cycle' }).then(() => true));
  const found = await page.call('controller', () => /** @type {any} */ (window.gaitsmith.document()).controllers.at(-1).senses);
  assert.equal(found.kind, 'sight');
  const [hash, link] = [await page.hash(), await page.link()];
  await page.page.evaluate(() => window.gaitsmith.run('panel/Controller'));
  await page.click('controller/sight');
  const seen = await page.call('sight', () => /** @type {any} */ (window.gaitsmith.document()).controllers.at(-1).senses.sight_rods);
  assert.ok(seen > 2, `the controller on the stage sees ${seen} rods`);
  await page.press('Control+z');
  assert.equal(await page.hash(), hash);
  const other = await PageDriver.open(browser, link);
  assert.equal(await other.hash(), hash, 'a link carries the sight');
  await other.close();
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** On a phone: a finger draws, another drag goes on, and two fingers zoom instead. @param {Visit} visit */
async function groundByFinger({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  await page.becomePhone();
  await page.frames(10);
  const pointer = new Fingers(page);
  await pointer.press('world/open');
  await pointer.press('world/ground-draw');
  const stage = await page.placeOf('stage');
  const at = (/** @type {number} */ x, /** @type {number} */ y) => ({ x: stage.x + x * stage.width, y: stage.y + y * stage.height });
  await pointer.drag(at(0.5, 0.66), at(0.7, 0.5));
  const ramp = await corners(page);
  assert.equal(ramp.length, 2, JSON.stringify(ramp));
  assert.ok((ramp[1].y_m ?? 0) > 0.3, JSON.stringify(ramp));
  await pointer.pinch([at(0.3, 0.4), at(0.5, 0.4)], [at(0.2, 0.4), at(0.6, 0.4)]);
  assert.deepEqual(await corners(page), ramp, 'two fingers zoom and draw nothing');
  await page.click('stage/follow');
  await pointer.tap(at(0.7, 0.5));
  await pointer.press('stage/corner-remove');
  assert.ok((await corners(page)).length < 2, 'a corner that is tapped can be removed');
  await pointer.press('stage/ground-done');
  assert.equal(await widget(page, 'stage/ground-done'), undefined);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function byHand({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  await page.click('transport/scrub'); // the middle
  await page.click('transport/step'); // pauses
  const calm = await page.hash();
  const stage = (await widget(page, 'stage'))?.rect ?? { x: 0, y: 0, width: 0, height: 0 };
  const ground = stage.y + stage.height - Math.min(130, Math.max(62, 0.178 * stage.height));
  // The figure came from the left, so a foot is on the ground in the right half. A drag that misses it only moves the
  // picture and is reverted.
  for (let x = stage.x + 0.5 * stage.width; x < stage.x + 0.9 * stage.width; x += 30) {
    await page.page.mouse.move(x, ground - 6);
    await page.frames();
    await page.page.mouse.down();
    await page.frames();
    await page.page.mouse.move(x + 30, ground - 40, { steps: 4 });
    await page.frames();
    await page.page.mouse.move(x + 60, ground - 80, { steps: 4 });
    await page.frames();
    await page.page.mouse.up();
    await page.frames();
    if ((await pushes(page)).length > 0) break;
    await page.click('stage/follow');
  }
  const [push] = await pushes(page);
  assert.ok(push, 'no joint could be pulled at');
  assert.ok(push.endpoint >= 0 && push.impulse_x_ns > 0 && push.impulse_y_ns > 0, JSON.stringify(push));
  assert.notEqual(await page.hash(), calm);
  await page.clickElement('#undo');
  await page.frames();
  assert.equal((await pushes(page)).length, 0);
  assert.equal(await page.hash(), calm);
  // A click without movement plays, and the wheel zooms in.
  await page.page.mouse.move(stage.x + 200, stage.y + 120);
  await page.page.mouse.wheel({ deltaY: -300 });
  await page.frames();
  assert.ok(await widget(page, 'stage/follow'), 'a zoomed stage offers to follow again');
  await page.click('stage/follow');
  assert.equal(await widget(page, 'stage/follow'), undefined);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function style({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  const before = await page.hash();
  await page.click('panels/2');
  const stage = (await widget(page, 'stage'))?.rect ?? { x: 0, y: 0, width: 0, height: 0 };
  await page.page.mouse.move(stage.x + stage.width + 100, stage.y + 200);
  await page.page.mouse.wheel({ deltaY: 3000 });
  const search = () => page.call('search', () => window.gaitsmith.document().search);
  const own = await search();
  await page.click('style/try');
  await page.until('the trial to end', () => /^Search done/.test(document.querySelector('#status')?.textContent ?? ''));
  assert.deepEqual(await search(), own, 'a trial changed the settings of the real search');
  await page.click('world/open');
  await scroll(page, 2000);
  assert.equal((await widget(page, 'world/ghost'))?.value, 'Before the last search');
  if (await page.hash() !== before) await page.clickElement('#undo');
  await page.frames();
  assert.equal(await page.hash(), before);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function sideBySide({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  await page.call('open', () => {
    const document = window.gaitsmith.document();
    window.gaitsmith.open({ ...document, search: { ...document.search, evaluations: 400 } });
  });
  await page.click('panels/1');
  await page.frames();
  const before = await page.hash();
  await page.click('transport/step'); // the description is up to date while paused
  const described = () => page.text('#description');
  await page.click('controller/compare');
  await page.until('a timer beside the senses', () =>
    window.gaitsmith.widgets().some(({ id, label }) => id === 'controller/compare' && label === 'Stop comparing'));
  await page.until('the description follows', () => /Beside it, timer/.test(document.querySelector('#description')?.textContent ?? ''));
  assert.equal(await page.hash(), before, 'the shown motion is as it was');
  await page.click('world/open');
  await scroll(page, 2000);
  assert.match((await widget(page, 'world/ghost'))?.value ?? '', /timer/);
  await scroll(page, -2000);
  const at = async (/** @type {string} */ end) => {
    await page.call('go', `window.gaitsmith.run('motion/${end}')`);
    await page.until('it is told', `/[Aa]fter ${end === 'end' ? '10.00' : '0.00'} s/.test(document.querySelector('#description').textContent)`);
    return (await described()).match(/Beside it, .*/)?.[0];
  };
  const calm = await at('end');
  await at('start');
  await page.click('world/push');
  assert.notEqual(await page.hash(), before);
  assert.notEqual(await at('end'), calm, 'the other was pushed too');
  await page.click('controller/compare');
  assert.equal((await widget(page, 'controller/compare'))?.label, 'Compare with a timer');
  await page.until('the description has one motion again', () => !/Beside it/.test(document.querySelector('#description')?.textContent ?? ''));
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @type {import('./all.mjs').Scenario[]} */
export const WORLD_SCENARIOS = [
  ['the world by number: a push and a slope change the motion, a link carries them, reset takes them back', byNumber],
  ['joints that give way change the motion, a link carries them, reset takes them back', limitedJoints],
  ['ground that is chosen: stairs and rubble, with limited joints, which a link carries and level ground frees', groundByName],
  ['ground that is drawn: with the mouse, over a part of it, corner by corner, and by numbers; Undo and reset take it back', groundByHand],
  ['a controller that sees the step before it is chosen, searched for, told how far to look, and carried by a link', sight],
  ['ground that is drawn with a finger on a phone: a corner is tapped and removed, two fingers zoom', groundByFinger, ONE_BROWSER],
  ['the world by hand: a foot pulled on the stage is pushed, Undo takes it back; zoom and follow', byHand],
  ['a style tried from the shown motion leaves the search as it was, shows what was before as a ghost, and can be undone', style, ONE_BROWSER],
  ['timer and senses side by side: a search finds the other, and a push meets both', sideBySide, ONE_BROWSER],
];
