// SPDX-License-Identifier: MIT
// The drawing board: a rod made longer, a limb copied and deleted, a figure mirrored, a figure of springs. Each scenario opens its own page.
import assert from 'node:assert/strict';
import { Fingers, Mouse } from '../pointers.mjs';
import { ONE_BROWSER, PageDriver } from '../page_driver.mjs';

/** @typedef {import('./all.mjs').Visit} Visit */

/** Opens a page with the board. @param {Visit} visit */
async function drawing({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  await page.click('panels/0');
  await page.frames(6);
  const pointer = new Mouse(page);
  const board = await pointer.find('figure/board');
  assert.ok(board);
  return { page, pointer, board: board.rect };
}

/** @param {PageDriver} page */
async function undo(page) {
  await page.clickElement('#undo');
  await page.frames();
}

/** @param {Visit} visit */
async function lengthens(visit) {
  const { page, pointer, board } = await drawing(visit);
  const before = await page.hash();
  // The head rod points up from the hub, in the middle of the board. Selecting it changes nothing.
  for (const up of [10, 25, 40]) {
    if (await pointer.find('figure/length')) break;
    await pointer.tap({ x: board.x + board.width / 2, y: board.y + board.height / 2 - up });
  }
  assert.equal(await page.hash(), before);
  await pointer.scrollTo('figure/length', 30);
  const length = (await pointer.find('figure/length'))?.rect;
  assert.ok(length, 'a chosen rod shows its length');
  await pointer.tap({ x: length.x + 0.8 * length.width, y: length.y + 0.75 * length.height });
  assert.notEqual(await page.hash(), before);
  await undo(page);
  assert.equal(await page.hash(), before);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function copiesAndMirrors(visit) {
  const { page, pointer } = await drawing(visit);
  const rods = () => page.call('rods', () => window.gaitsmith.document().figure.rods?.length);
  const before = await page.hash();
  assert.equal(await rods(), 5);
  await pointer.press('figure/rod/more'); // the root cannot be copied, the second rod can
  await pointer.press('figure/copy');
  assert.equal(await rods(), 6);
  await pointer.press('figure/delete'); // the copy, which is selected now
  assert.equal(await rods(), 5);
  await undo(page);
  await undo(page);
  assert.equal(await page.hash(), before, 'as it was, controllers and all');

  await pointer.press('figure/mirror');
  assert.notEqual(await page.hash(), before);
  await undo(page);
  assert.equal(await page.hash(), before);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function evolves({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  const pointer = new Mouse(page);
  const rodsOf = (/** @type {PageDriver} */ driver) => driver.call('rods', () => JSON.stringify(window.gaitsmith.document().figure.rods));
  const drawn = await rodsOf(page);
  await page.call('a short search', () => {
    window.gaitsmith.open({ ...window.gaitsmith.document(), hash: undefined, search: { algorithm: 'pose-cycle', seed: 2, evaluations: 600 } });
    return true;
  });
  await page.click('panels/3');
  await pointer.press('search/body');
  await pointer.press('search/body/2');
  await page.until('a lot', () => window.gaitsmith.document().search?.body === 'lot');
  await pointer.press('search/start');
  await page.until('the result', () => window.gaitsmith.results().length === 1 && /^Search done/.test(document.querySelector('#status')?.textContent ?? ''));
  const found = await rodsOf(page);
  assert.notEqual(found, drawn, 'the search changed the body');
  const link = await page.link();

  // Back to the drawn body. Then the controller that was found drives it.
  await page.click('panels/0');
  await pointer.press('figure/as-drawn');
  await page.frames();
  assert.equal(await rodsOf(page), drawn);
  assert.equal(await pointer.find('figure/as-drawn'), undefined);
  await page.click('panels/3');
  await pointer.press(`found/${await page.call('result', () => window.gaitsmith.results()[0].id)}/brain`);
  await page.frames();
  assert.equal(await rodsOf(page), drawn, 'the body stays');
  assert.equal(await page.call('clips', () => window.gaitsmith.document().timeline?.length), 1);
  assert.match(await page.status(), /Another brain/);

  const second = await PageDriver.open(browser, link, { beside: page });
  assert.equal(await rodsOf(second), found, 'a link has the found body');
  assert.deepEqual([page.complaints, second.complaints], [[], []]);
  await page.close();
}

/** @param {Visit} visit */
async function drawsSprings({ browser, address }) {
  const page = await PageDriver.open(browser, address, { newcomer: true, plays: true });
  await page.becomePhone();
  await page.frames(10);
  const finger = new Fingers(page);
  const count = () => page.call('parts', () => {
    const { nodes = [], springs = [] } = window.gaitsmith.document().figure;
    return [nodes.length, springs.length, springs.filter(({ min_rest = 1, max_rest = 1 }) => min_rest < max_rest).length];
  });
  await finger.tap(await finger.centre('figures/draw'));
  await page.frames(10);
  await finger.tap(await finger.centre('draw/made-of/1'));
  await page.frames(6);
  const board = (await finger.find('figure/springs'))?.rect;
  assert.ok(board && board.height > 250, 'most of the stage');
  assert.equal((await finger.find('draw/teach'))?.state.disabled, true, 'nothing is drawn yet');
  const at = (/** @type {number} */ x, /** @type {number} */ y) => ({ x: board.x + x * board.width, y: board.y + y * board.height });
  const [low, high, right] = [at(0.3, 0.6), at(0.3, 0.35), at(0.6, 0.35)];
  await finger.drag(low, high);
  assert.deepEqual(await count(), [2, 1, 0], 'the first spring');
  await finger.tap(right);
  assert.deepEqual(await count(), [3, 3, 0], 'a tap makes a node, which is held');
  await finger.drag(low, at(0.6, 0.6));
  assert.deepEqual(await count(), [4, 5, 0], 'a drag from a node makes a spring and its end');
  await finger.drag(high, at(0.6, 0.6));
  assert.deepEqual(await count(), [4, 6, 0], 'a drag between nodes makes a spring');
  await finger.tap({ x: (low.x + high.x) / 2, y: (low.y + high.y) / 2 });
  assert.deepEqual(await count(), [4, 6, 1], 'a tap on a spring makes it a muscle');
  await finger.tap(at(0.6, 0.475));
  assert.deepEqual(await count(), [4, 6, 2]);
  const stiffness = () => page.call('stiffness', () => window.gaitsmith.document().figure.springs?.[0]?.stiffness_npm);
  const before = Number(await stiffness());
  await finger.tap(await finger.centre('draw/stiffer'));
  assert.equal(await stiffness(), 2 * before);
  await finger.tap(await finger.centre('draw/teach'));
  await page.until('the end of the search', () => window.gaitsmith.results().length > 0);
  assert.ok(await page.call('metres', () => (window.gaitsmith.results()[0]?.score ?? 0) > 0.1), 'it moves');
  assert.equal(await finger.find('figure/springs'), undefined, 'the stage is back');
  // The link has all of it, and moves it with the same bits.
  const second = await PageDriver.open(browser, await page.link(), { beside: page });
  assert.equal(await second.hash(), await page.hash());
  assert.equal(await second.call('model', () => window.gaitsmith.document().model), 3);
  assert.deepEqual([page.complaints, second.complaints], [[], []]);
  await page.close();
}

/** Without the board: by the widgets of the panel alone, as the keyboard and screen readers have them. @param {Visit} visit */
async function drawsSpringsByKeys({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  await page.click('panels/0');
  await page.frames(6);
  const pointer = new Mouse(page);
  await pointer.press('figure/fresh-springs');
  await page.frames(6);
  const parts = () => page.call('parts', () => {
    const { nodes = [], springs = [] } = window.gaitsmith.document().figure;
    return [nodes.length, springs.length];
  });
  assert.deepEqual(await parts(), [2, 1]);
  await pointer.press('springs/add');
  await pointer.press('springs/add');
  assert.equal((await parts())[0], 4);
  await pointer.press('springs/kind/1');
  await pointer.press('springs/muscle');
  await page.until('a muscle', () => (window.gaitsmith.document().figure.springs ?? []).some(({ min_rest = 1 }) => min_rest < 1));
  const before = Number(await page.call('stiffness', () => window.gaitsmith.document().figure.springs?.[0]?.stiffness_npm));
  await pointer.press('springs/softer');
  assert.equal(await page.call('stiffness', () => window.gaitsmith.document().figure.springs?.[0]?.stiffness_npm), before / 2);
  // The length without force of a muscle stays within what its controller may ask for. A spring takes its own.
  const lengths = () => page.call('lengths', () => {
    const { rest = 1, min_rest: least = 1, max_rest: most = 1 } = window.gaitsmith.document().figure.springs?.[0] ?? {};
    return [rest, least, most];
  });
  const [, least, most] = await lengths();
  await page.page.focus('[data-id="springs/rest"]');
  await page.press('Home');
  await page.frames();
  assert.deepEqual(await lengths(), [least, least, most]);
  await undo(page);
  await pointer.press('springs/muscle');
  await page.page.focus('[data-id="springs/rest"]');
  await page.press('ArrowRight');
  await page.frames();
  assert.deepEqual(await lengths(), [1.01, 1.01, 1.01]);
  await undo(page);
  await undo(page);
  await pointer.press('springs/delete');
  await page.frames();
  for (const _ of [1, 2, 3, 4, 5]) await undo(page);
  assert.deepEqual(await parts(), [2, 1], 'Undo takes back each edit');
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @type {import('./all.mjs').Scenario[]} */
export const FIGURE_SCENARIOS = [
  ['a rod made longer changes the motion, and Undo brings the old one back', lengthens],
  ['a limb copied and deleted, a figure mirrored; Undo brings back each', copiesAndMirrors, ONE_BROWSER],
  ['a search that may change the body finds another, links have it, the drawn one comes back and takes its brain', evolves, ONE_BROWSER],
  ['a figure of springs, drawn by finger, learns to move, and its link moves it with the same bits', drawsSprings, ONE_BROWSER],
  ['a figure of springs is drawn without the board, and Undo takes back each edit', drawsSpringsByKeys, ONE_BROWSER],
];
