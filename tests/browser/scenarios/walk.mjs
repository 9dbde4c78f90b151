// SPDX-License-Identifier: MIT
// A newcomer's whole visit: draws a figure from one rod, finds a motion for it, pushes it, changes a rule, undoes and
// redoes everything. By mouse on a desktop, by fingers on a phone.
import assert from 'node:assert/strict';
import { Fingers, Mouse } from '../pointers.mjs';
import { PageDriver } from '../page_driver.mjs';

/** @typedef {import('./all.mjs').Visit} Visit */
/** @typedef {import('../pointers.mjs').Point} Point */
/** @typedef {{length_m: number, parent?: number, parent_end?: string, rest_rad?: number}} DrawnRod */

/**
 * The positions of the rods' ends on the board, which shows the figure in its middle: the root's start, then each rod's
 * end.
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

/** @param {Mouse | Fingers} pointer */
async function walk(pointer) {
  const { page } = pointer;
  const rods = () => page.call('rods', () => /** @type {any} */ (window.gaitsmith.document()).figure.rods);
  const controllers = () => page.call('controllers', () => /** @type {any} */ (window.gaitsmith.document()).controllers ?? []);
  const enabled = (/** @type {string} */ id) => page.page.$eval(id, (button) => button.getAttribute('aria-disabled') !== 'true');
  const first = await page.hash();

  // Draw.
  await pointer.press('panels/0');
  await pointer.press('figure/fresh');
  assert.equal((await rods()).length, 1);
  /** The joint that both rods begin at, from the board's corner: the view stays while the figure fits. @type {Point | null} */
  let joint = null;
  for (const right of [70, -60]) {
    await pointer.scrollTo('figure/board', 180);
    const board = (await pointer.find('figure/board'))?.rect;
    assert.ok(board);
    // The board may be partly hidden. The figure is in the middle of the whole board.
    const whole = board.height >= 267 ? board : await fitted(pointer, board);
    if (!joint) {
      const end = onBoard(await rods(), whole).find(({ y }) => y > board.y + 15 && y < board.y + board.height - 15);
      assert.ok(end, 'an end of a rod is to be seen');
      joint = { x: end.x - whole.x, y: end.y - whole.y };
    }
    const from = { x: whole.x + joint.x, y: whole.y + joint.y };
    await pointer.drag(from, { x: from.x + right, y: board.y + board.height / 2 });
  }
  assert.equal((await rods()).length, 3, 'a figure of three rods');
  assert.deepEqual(await controllers(), []);

  // Search until there is a motion.
  await pointer.press('panels/3');
  await pointer.press('search/start');
  await page.until('a motion of it', () => (/** @type {any} */ (window.gaitsmith.document()).controllers ?? []).length > 0);
  const stop = await pointer.find('search/stop');
  if (stop && !stop.state.disabled) await pointer.press('search/stop');
  await page.frames(10);
  const found = await page.hash();
  assert.equal((await controllers()).length, 1);

  // Push.
  await pointer.press('world/open');
  await pointer.press('world/push');
  assert.notEqual(await page.hash(), found);
  await pointer.press('world/open');
  const pushed = await page.hash();

  // Change a rule: delete an active one.
  await pointer.press('panels/1');
  await page.frames(6);
  for (let turn = 0; turn < 4 && await page.hash() === pushed; turn++) {
    await pointer.scrollTo('controller/why');
    const [, acting] = /Rule (\d+) /.exec((await pointer.find('controller/why'))?.label ?? '') ?? [];
    assert.ok(acting, 'it says which rule acts');
    await pointer.press(`controller/rule/${acting}`);
    await pointer.press('rule-edit/delete');
  }
  assert.notEqual(await page.hash(), pushed, 'a motion that needs none of its rules');
  const last = await page.hash();

  // Undo and redo everything.
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

/** The whole board's rectangle, if the panel cuts off its lower part. @param {Mouse | Fingers} pointer @param {{x: number, y: number, width: number, height: number}} board */
async function fitted(pointer, board) {
  const tabs = await pointer.find('panels/0');
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
  await page.becomePhone();
  await page.frames(10);
  const pointer = new Fingers(page);
  // Spreading two fingers on the stage enlarges the picture. It does not change the motion or push the figure.
  const stage = (await pointer.find('stage'))?.rect;
  assert.ok(stage);
  const middle = { x: stage.x + stage.width / 2, y: stage.y + stage.height / 2 };
  const hash = await page.hash();
  const playing = (await pointer.find('transport/play'))?.label;
  await pointer.pinch([{ x: middle.x - 30, y: middle.y }, { x: middle.x + 30, y: middle.y }],
    [{ x: middle.x - 90, y: middle.y }, { x: middle.x + 90, y: middle.y }]);
  assert.ok(await pointer.find('stage/follow'), 'the picture is another one');
  assert.equal(await page.hash(), hash);
  assert.equal((await pointer.find('transport/play'))?.label, playing, 'a pinch is no tap');
  await pointer.press('stage/follow');
  assert.equal(await pointer.find('stage/follow'), undefined);
  await walk(pointer);
  await page.close();
}

/** @type {[string, (visit: Visit) => Promise<void>][]} */
export const WALK_SCENARIOS = [
  ['a walk by mouse: three rods drawn, a motion found, pushed, a rule changed, all undone and done again', byMouse],
  ['a walk by fingers on a phone: the same, and two fingers enlarge the picture', byFingers],
];
