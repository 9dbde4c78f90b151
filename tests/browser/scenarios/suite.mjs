// SPDX-License-Identifier: MIT
// A suite of motions, and the paper's Figure 12 made from one: by mouse, and only by keys and assistive tools. Each
// scenario opens its own page.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { activate, setValue } from '../assistive.mjs';
import { ROOT } from '../browsers.mjs';
import { Mouse } from '../pointers.mjs';
import { ONE_BROWSER, PageDriver } from '../page_driver.mjs';

/** @typedef {import('./all.mjs').Visit} Visit */
/** @typedef {import('../../../web/app/app.js').FoundMotion} FoundMotion */

/** @param {PageDriver} page @returns {Promise<FoundMotion[]>} */
const results = (page) => page.call('results', () => window.gaitsmith.results());
/** @param {PageDriver} page @param {number} count */
const untilResults = (page, count) => page.until(`${count} results`, `window.gaitsmith.results().length >= ${count}`, 120000);
/** The results' ids, in the order of their cards. @param {PageDriver} page */
const cards = async (page) => (await page.widgets()).filter(({ id }) => /^found\/[0-9a-f]{16}$/.test(id)).map(({ id }) => id.slice(6));
/** @param {PageDriver} page @param {string} name */
const cardOf = async (page, name) => (await page.widgets()).find(({ id, label }) => /^found\/[0-9a-f]{16}$/.test(id) && label.startsWith(`Show ${name}, `))?.id ?? assert.fail(`no card of ${name}`);
/** The starts of the clips, and the end. @param {PageDriver} page @returns {Promise<number[]>} */
const borders = (page) => page.call('borders', () => {
  const { timeline, duration_steps: end } = /** @type {any} */ (window.gaitsmith.document());
  return [...timeline.map((/** @type {any} */ clip) => clip.start_step ?? 0), end];
});

/** Types a name into the dialog. @param {PageDriver} page @param {string} name */
async function typeName(page, name) {
  await page.until('the dialog', () => /** @type {HTMLDialogElement} */ (document.querySelector('#name-dialog')).open);
  await page.page.keyboard.type(name);
  await page.page.keyboard.press('Enter');
}

/** @param {Visit} visit */
async function suite({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  await page.page.setViewport({ width: 1280, height: 1500 }); // makes all cards visible
  const pointer = new Mouse(page);
  await page.call('short searches', () => {
    const document = window.gaitsmith.document();
    window.gaitsmith.open({ ...document, hash: undefined, search: { seed: 3, evaluations: 300 } });
  });
  await page.click('panels/3');
  await page.click('search/settings');
  await pointer.press('suite');
  // All goals and two styles are selected at first. Deselect the jump.
  await pointer.press('suite/task/2');
  await pointer.press('suite/make');
  await untilResults(page, 4);
  await page.click('suite');
  const found = await results(page);
  assert.equal(found.length, 4);
  assert.equal(new Set(found.map(({ hash }) => hash)).size, 4, 'different motions');
  await pointer.scrollTo(`found/${found[0].id}`, 60);
  assert.match((await page.widgets()).find(({ id }) => id === `found/${found[0].id}`)?.label ?? '', /^Show Mr\. Star-Man · travel to the left, more rotations, 10 rules/);

  // Name one and save it. A name that is too long is refused with a reason.
  const [first] = await cards(page);
  await pointer.press(`found/${first}/rename`);
  await typeName(page, 'Ä'.repeat(41));
  await page.until('a reason', () => /at most 80 bytes/.test(document.querySelector('#name-error')?.textContent ?? ''));
  await page.press('Control+a');
  await typeName(page, 'Leftward wheel');
  await page.until('no dialog', () => !(/** @type {HTMLDialogElement} */ (document.querySelector('#name-dialog')).open));
  await page.frames(4);
  assert.equal(await cardOf(page, 'Leftward wheel'), `found/${first}`);
  await pointer.press(`found/${first}/keep`);

  // Sorted by turns, most first. Then only the saved ones.
  await page.click('found/order');
  await page.click('found/order/3');
  await page.frames(4);
  const turns = (await page.widgets()).filter(({ id }) => /^found\/[0-9a-f]{16}$/.test(id))
    .map(({ value }) => Number(/rotations ([\d.]+)/.exec(value ?? '')?.[1] ?? assert.fail(`no rotations in ${value}`)));
  assert.ok(turns.length > 1 && turns[0] > 0, `turns: ${turns}`);
  assert.deepEqual(turns, [...turns].sort((a, b) => b - a), 'the most turns first');
  await page.click('found/filter');
  await page.click('found/filter/2');
  await page.frames(4);
  assert.deepEqual(await cards(page), [first]);

  // The shown result has its name. Repeating its search finds the same motion.
  await page.click(`found/${first}`);
  assert.equal((await page.text('#title')), 'Leftward wheel');
  const hash = await page.hash();
  await pointer.press(`found/${first}/again`);
  await page.until('the end', () => window.gaitsmith.queue().length === 0 && /Search done/.test(document.querySelector('#status')?.textContent ?? ''));
  const again = await results(page);
  assert.equal(again.length, 4, 'what is found again is the same');
  assert.equal(again.find(({ id }) => id === first)?.hash, hash);
  await page.reload();
  await page.until('results', () => window.gaitsmith.results().length === 4);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

const PARTS = /** @type {const} */ ([
  { name: 'Shuffle', task: { kind: 'travel-right', duration_steps: 500, weights: { slip_sum: 0.6 } }, tau: 0.3, seed: 4, evaluations: 8000 },
  { name: 'Cartwheel', task: { kind: 'travel-left', duration_steps: 400, weights: { rotations: 30 } }, tau: 0.3, seed: 3, evaluations: 8000 },
  // Faster responses leave the ground.
  { name: 'Jump', task: { kind: 'jump', duration_steps: 200 }, tau: 0.12, seed: 5, evaluations: 4000 },
]);

/** Searches for the three motions and names them. @param {PageDriver} page */
async function findParts(page) {
  const pointer = new Mouse(page);
  const problem = JSON.parse(await readFile(join(ROOT, 'examples/problems/star-man-travel.json'), 'utf8'));
  for (const { task, tau, seed, evaluations } of PARTS) {
    const wanted = { ...problem, hash: undefined, task, view: { panel: 3 }, senses: { ...problem.senses, tau_min_s: tau }, search: { seed, evaluations } };
    await page.page.evaluate((one) => { window.gaitsmith.open(one); }, wanted);
    await page.frames();
    await page.click('queue/add');
  }
  await page.click('search/settings');
  await pointer.press('queue/run');
  await untilResults(page, 3);
  await page.frames(4);
  for (const { name, seed } of PARTS) {
    const { id } = (await results(page)).find((one) => one.seed === seed) ?? assert.fail(name);
    await pointer.press(`found/${id}/rename`);
    await typeName(page, name);
    await page.frames(4);
  }
}

/** Shows a moment, to the step, by mouse. @param {PageDriver} page @param {number} step */
async function seek(page, step) {
  const scrub = (await page.widgets()).find(({ id }) => id === 'transport/scrub') ?? assert.fail('no scrub bar');
  const [, end] = [0, (await borders(page)).at(-1) ?? 1];
  const inside = scrub.rect.width - 4;
  await page.clickAt(scrub.rect.x + 2 + (step / end) * inside, scrub.rect.y + scrub.rect.height / 2);
  const now = async () => Math.round(100 * Number.parseFloat((await page.widgets()).find(({ id }) => id === 'transport/scrub')?.value ?? ''));
  for (let i = 0; i < 60 && (await now()) !== step; i++) await page.press((await now()) < step ? 'ArrowRight' : 'ArrowLeft');
  assert.equal(await now(), step);
}

const FIGURE_12 = [0, 260, 690, 850, 1100];

/** Drags the border before a clip to the shown moment. @param {PageDriver} page @param {number} clip @param {number} step */
async function moveBorder(page, clip, step) {
  const pointer = new Mouse(page);
  await seek(page, step);
  const rects = (await page.widgets()).filter(({ id }) => id.startsWith('timeline/clip/')).map(({ rect }) => rect);
  const all = await borders(page);
  const perStep = (rects[rects.length - 1].x + rects[rects.length - 1].width - rects[0].x) / (all.at(-1) ?? 1);
  const border = await pointer.centre(`timeline/switch/${clip}`);
  await pointer.drag(border, { x: border.x + (step - all[clip]) * perStep, y: border.y });
}

/** @param {PageDriver} page */
async function byMouse(page) {
  const pointer = new Mouse(page);
  const drop = async (/** @type {string} */ name, /** @type {number} */ step) => {
    await seek(page, step);
    const card = await cardOf(page, name);
    await pointer.scrollTo(card, 80);
    const clips = (await page.widgets()).filter(({ id }) => id.startsWith('timeline/clip/')).map(({ rect }) => rect);
    const [left, right] = [clips[0].x, clips[clips.length - 1].x + clips[clips.length - 1].width];
    await pointer.drag(await pointer.centre(card), { x: left + (step / ((await borders(page)).at(-1) ?? 1)) * (right - left), y: clips[0].y + 24 });
  };
  const shuffle = await cardOf(page, 'Shuffle');
  await pointer.press(shuffle);
  await drop('Cartwheel', 260);
  assert.deepEqual(await borders(page), [0, 260, 660, 900]);
  await moveBorder(page, 2, 690);
  await drop('Jump', 690);
  assert.deepEqual(await borders(page), [0, 260, 690, 890, 1100]);
  await moveBorder(page, 3, 850);
}

/** @param {PageDriver} page */
async function byKeys(page) {
  const insert = async (/** @type {string} */ name, /** @type {number} */ step) => {
    await setValue(page, 'slider', 'Time', String(step / 100));
    const card = (await page.widgets()).find(({ id, label }) => id.endsWith('/insert') && label.includes(`: ${name}, `)) ?? assert.fail(name);
    await activate(page, 'button', card.label);
  };
  const shuffle = (await page.widgets()).find(({ label }) => label.startsWith('Show Shuffle, ')) ?? assert.fail('no Shuffle');
  await activate(page, 'button', shuffle.label);
  await insert('Cartwheel', 260);
  await setValue(page, 'slider', 'Border 2 of 2: clip 3 takes over', '6.9');
  await insert('Jump', 690);
  await setValue(page, 'slider', 'Border 3 of 3: clip 4 takes over', '8.5');
}

/** @param {Visit} visit */
async function figure12({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  const example = JSON.parse(await readFile(join(ROOT, 'examples/figure-12.json'), 'utf8'));
  await findParts(page);
  await page.call('nothing to undo', () => { window.gaitsmith.run('document/new'); });
  for (const [way, make] of /** @type {const} */ ([['mouse', byMouse], ['keys', byKeys]])) {
    await make(page);
    assert.deepEqual(await borders(page), FIGURE_12, way);
    assert.equal(await page.hash(), example.hash, way);
    const names = await page.call('names', () => /** @type {any} */ (window.gaitsmith.document()).controllers.map((/** @type {any} */ one) => one.name));
    assert.deepEqual(names, ['Shuffle', 'Cartwheel', 'Jump']);
    for (let step = 0; step < 40 && (await borders(page)).length > 1; step++) await page.press('Control+z');
    assert.equal((await borders(page)).length, 1, `undone to the empty timeline, ${way}`);
  }
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function longLink({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  await page.until('the dialogs, which a resting page loads', () => document.querySelector('#link-dialog') !== null);
  const example = JSON.parse(await readFile(join(ROOT, 'examples/figure-12.json'), 'utf8'));
  const copy = async (/** @type {any} */ document) => {
    const length = await page.page.evaluate((one) => {
      window.gaitsmith.open(one);
      return window.gaitsmith.link().length;
    }, document);
    await page.clickElement('#copy-link');
    await page.frames();
    // If the browser forbids copying, a dialog with the link has the same sentence.
    const shown = await page.call('dialogs', () => {
      const of = (/** @type {string} */ dialog, /** @type {string} */ words) => (/** @type {HTMLDialogElement} */ (document.querySelector(dialog)).open
        ? document.querySelector(words)?.textContent ?? '' : '');
      const boxed = /** @type {HTMLDialogElement} */ (document.querySelector('#link-dialog'));
      const text = of('#long-link-dialog', '#long-link-words') + of('#link-dialog', '#link-words');
      const byHand = boxed.open;
      boxed.close();
      return { text, byHand };
    });
    return { length, shown: shown.text, byHand: shown.byHand };
  };
  const short = await copy(example);
  assert.ok(short.length <= 1900 && short.shown === '', `four clips, ${short.length} characters: ${short.shown}`);
  const others = example.controllers.map((/** @type {any} */ one) => ({ ...one, rules: [...one.rules].reverse() }));
  const long = await copy({ ...example, hash: undefined, controllers: [...example.controllers, ...others] });
  assert.ok(long.length > 1900);
  assert.ok(long.shown.includes(long.length.toLocaleString('en')), long.shown);
  if (long.byHand) return page.close();
  await page.clickElement('#long-link-save');
  assert.equal(await page.call('closed', () => /** @type {HTMLDialogElement} */ (document.querySelector('#long-link-dialog')).open), false);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @type {[string, (visit: Visit) => Promise<void>, string?][]} */
export const SUITE_SCENARIOS = [
  ['a suite in one press: named, sorted, kept, made again', suite, ONE_BROWSER],
  ['Figure 12 of the paper, chained by mouse and by keys alone', figure12],
  ['a link that is too long says so, and offers a file', longLink],
];
