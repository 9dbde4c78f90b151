// SPDX-License-Identifier: MIT
// A whole walk as a newcomer takes it: a figure drawn from one rod, a motion found for it, pushed, its rule changed, all
// of it undone and done again. By mouse on a desk, by fingers on a phone.
import assert from 'node:assert/strict';
import { Fingers, Mouse } from './hands.mjs';
import { PageDriver } from './page_driver.mjs';

/** @typedef {import('./scenarios.mjs').Visit} Visit */
/** @typedef {import('./hands.mjs').Point} Point */
/** @typedef {{length_m: number, parent?: number, parent_end?: string, rest_rad?: number}} DrawnRod */

/**
 * Where the ends of the rods are on the board, which shows the figure in its middle: the root's start, then each rod's end.
 * @param {DrawnRod[]} rods  each after its parent, all on ends @param {{x: number, y: number, width: number, height: number}} board
 */
function onBoard(rods, board) {
  /** @type {{start: Point, end: Point, angle: number}[]} */
  const drawn = [];
  for (const rod of rods) {
    const parent = rod.parent === undefined || rod.parent < 0 ? undefined : drawn[rod.parent];
    const start = parent ? (rod.parent_end === 'start' ? parent.start : parent.end) : { x: 0, y: 0 };
    const angle = (parent?.angle ?? 0) + (rod.rest_rad ?? 0);
    drawn.push({ start, angle, end: { x: start.x + rod.length_m * Math.cos(angle), y: start.y + rod.length_m * Math.sin(angle) } });
  }
  const all = [drawn[0].start, ...drawn.map(({ end }) => end)];
  const [left, right] = [Math.min(...all.map(({ x }) => x)), Math.max(...all.map(({ x }) => x))];
  const [low, high] = [Math.min(...all.map(({ y }) => y)), Math.max(...all.map(({ y }) => y))];
  const scale = 0.64 * Math.min(board.height / Math.max(high - low, 0.1), board.width / Math.max(right - left, 0.1));
  return all.map(({ x, y }) => ({
    x: board.x + board.width / 2 + (x - (left + right) / 2) * scale,
    y: board.y + board.height / 2 - (y - (low + high) / 2) * scale,
  }));
}

/** @param {Mouse | Fingers} hand */
async function walk(hand) {
  const { page } = hand;
  const rods = () => page.call('rods', () => /** @type {any} */ (window.gaitsmith.document()).figure.rods);
  const controllers = () => page.call('controllers', () => /** @type {any} */ (window.gaitsmith.document()).controllers ?? []);
  const enabled = (/** @type {string} */ id) => page.page.$eval(id, (button) => button.getAttribute('aria-disabled') !== 'true');
  const first = await page.hash();

  // Draw.
  await hand.press('panels/0');
  await hand.press('figure/fresh');
  assert.equal((await rods()).length, 1);
  for (const right of [70, -60]) {
    await hand.scrollTo('figure/board', 180);
    const board = (await hand.find('figure/board'))?.rect;
    assert.ok(board);
    // What is seen of it may be less than all of it: its middle is where the whole board's is.
    const whole = board.height >= 267 ? board : await fitted(hand, board);
    const from = onBoard(await rods(), whole).find(({ y }) => y > board.y + 15 && y < board.y + board.height - 15);
    assert.ok(from, 'an end of a rod is to be seen');
    await hand.drag(from, { x: from.x + right, y: board.y + board.height / 2 });
  }
  assert.equal((await rods()).length, 3, 'a figure of three rods');
  assert.deepEqual(await controllers(), []);

  // Search, until there is something to look at.
  await hand.press('panels/3');
  await hand.press('search/start');
  await page.until('a motion of it', () => (/** @type {any} */ (window.gaitsmith.document()).controllers ?? []).length > 0);
  const stop = await hand.find('search/stop');
  if (stop && !stop.state.disabled) await hand.press('search/stop');
  await page.frames(10);
  const found = await page.hash();
  assert.equal((await controllers()).length, 1);

  // Push.
  await hand.press('world/open');
  await hand.press('world/push');
  assert.notEqual(await page.hash(), found);
  await hand.press('world/open');
  const pushed = await page.hash();

  // Change a rule: take away one that acts.
  await hand.press('panels/1');
  await page.frames(6);
  for (let turn = 0; turn < 4 && await page.hash() === pushed; turn++) {
    await hand.scrollTo('controller/why');
    const [, acting] = /Rule (\d+) /.exec((await hand.find('controller/why'))?.label ?? '') ?? [];
    assert.ok(acting, 'it says which rule acts');
    await hand.press(`controller/rule/${acting}`);
    await hand.press('rule-edit/delete');
  }
  assert.notEqual(await page.hash(), pushed, 'a motion that needs none of its rules');
  const last = await page.hash();

  // All the way back, and forth.
  let steps = 0;
  for (; await enabled('#undo') && steps < 40; steps++) {
    await page.clickElement('#undo');
    await page.frames();
  }
  assert.ok(steps >= 6, `${steps} steps`);
  assert.equal(await page.hash(), first, 'as it began');
  for (let k = 0; k < steps; k++) {
    assert.ok(await enabled('#redo'));
    await page.clickElement('#redo');
    await page.frames();
  }
  assert.equal(await page.hash(), last, 'as it ended');
  assert.deepEqual(page.complaints, []);
}

/** The whole board, when the lower part of it is cut off by the panel. @param {Mouse | Fingers} hand @param {{x: number, y: number, width: number, height: number}} board */
async function fitted(hand, board) {
  const tabs = await hand.find('panels/0');
  const top = (tabs?.rect.y ?? 0) + (tabs?.rect.height ?? 0);
  return board.y > top + 1 ? { ...board, height: 268 } : { ...board, y: board.y + board.height - 268, height: 268 };
}

/** @param {Visit} visit */
async function byMouse({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  await walk(new Mouse(page));
  await page.close();
}

/** @param {Visit} visit */
async function byFingers({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  await page.page.setViewport({ width: 390, height: 844, deviceScaleFactor: 2, hasTouch: true, isMobile: true }).catch(() => page.page.setViewport({ width: 390, height: 844 }));
  await page.frames(10);
  const hand = new Fingers(page);
  // Two fingers part on the stage: the picture grows, the motion is as it was, and nothing has been pushed.
  const stage = (await hand.find('stage'))?.rect;
  assert.ok(stage);
  const middle = { x: stage.x + stage.width / 2, y: stage.y + stage.height / 2 };
  const hash = await page.hash();
  const playing = (await hand.find('transport/play'))?.label;
  await hand.pinch([{ x: middle.x - 30, y: middle.y }, { x: middle.x + 30, y: middle.y }],
    [{ x: middle.x - 90, y: middle.y }, { x: middle.x + 90, y: middle.y }]);
  assert.ok(await hand.find('stage/follow'), 'the picture is another one');
  assert.equal(await page.hash(), hash);
  assert.equal((await hand.find('transport/play'))?.label, playing, 'a pinch is no tap');
  await hand.press('stage/follow');
  assert.equal(await hand.find('stage/follow'), undefined);
  await walk(hand);
  await page.close();
}

/** @type {[string, (visit: Visit) => Promise<void>][]} */
export const WALK_SCENARIOS = [
  ['a walk by mouse: three rods drawn, a motion found, pushed, a rule changed, all undone and done again', byMouse],
  ['a walk by fingers on a phone: the same, and two fingers enlarge the picture', byFingers],
];
