// SPDX-License-Identifier: MIT
// Live: the page searches on while a control is held. And drawing on the empty stage, and the border of the panel. Each
// scenario opens its own pages.
import assert from 'node:assert/strict';
import { PageDriver, sleep } from '../page_driver.mjs';
import { Fingers, Mouse } from '../pointers.mjs';

/** @typedef {import('./all.mjs').Visit} Visit */

/** A page with the world's card open. @param {Visit} visit */
async function world({ browser, address }) {
  const page = await PageDriver.open(browser, address, { plays: true, live: true });
  await page.click('world/open');
  await page.until('the card', () => window.gaitsmith.widgets().some(({ id }) => id === 'world/live'));
  await page.frames(6);
  return { page, pointer: new Mouse(page) };
}

/** @param {PageDriver} page */
const previews = (page) => page.call('preview', () => window.gaitsmith.measures().preview);

/** Types gravity into the slider's field. @param {PageDriver} page @param {Mouse} pointer @param {string} text */
async function typeGravity(page, pointer, text) {
  const slider = (await pointer.find('world/gravity'))?.rect;
  assert.ok(slider);
  await pointer.tap({ x: slider.x + slider.width - 12, y: slider.y + 6 });
  await page.until('a field', () => window.gaitsmith.widgets().some(({ role }) => role === 'textbox'));
  await page.press('Control+a');
  for (const letter of text) await page.press(letter);
  await page.press('Enter');
}

/** @param {Visit} visit */
async function dragsGravity(visit) {
  const { page, pointer } = await world(visit);
  const before = await page.hash();
  const slider = (await pointer.find('world/gravity'))?.rect;
  assert.ok(slider);
  const { mouse } = page.page;
  const y = slider.y + 0.75 * slider.height;
  await mouse.move(slider.x + 0.4 * slider.width, y);
  await page.frames();
  await mouse.down();
  for (let step = 1; step <= 6; step++) {
    await mouse.move(slider.x + (0.4 - 0.02 * step) * slider.width, y);
    await page.frames(6);
  }
  await page.until('a preview', () => window.gaitsmith.measures().preview === true);
  assert.ok((await page.widgets()).every(({ id }) => id !== 'stage/stop'), 'the row of actions stays as it is');
  assert.equal(await page.call('results', () => window.gaitsmith.results().length), 0, 'a preview is no result');
  await mouse.up();
  await page.until('the motion for it', () => window.gaitsmith.results().length === 1 && !window.gaitsmith.measures().preview);
  const gravity = await page.call('gravity', () => window.gaitsmith.document().environment?.gravity_mps2 ?? 0);
  const end = await page.hash();
  assert.notEqual(end, before);
  await page.press('Control+z');
  await page.until('as before', `window.gaitsmith.hash() === ${JSON.stringify(before)}`);
  assert.equal(await page.call('undo', () => window.gaitsmith.canUndo()), false, 'one step');
  assert.deepEqual(page.complaints, []);
  await page.close();

  // The same value, typed: no preview, and the same end.
  const other = await world(visit);
  await typeGravity(other.page, other.pointer, String(Number(gravity.toFixed(6))));
  await other.page.until('the motion for it', () => window.gaitsmith.results().length === 1);
  assert.equal(await other.page.call('gravity', () => window.gaitsmith.document().environment?.gravity_mps2 ?? 0), gravity);
  assert.equal(await other.page.hash(), end, 'the way there does not count');
  assert.deepEqual(other.page.complaints, []);
  await other.page.close();
}

/** @param {Visit} visit */
async function switchesOff(visit) {
  const { page, pointer } = await world(visit);
  await pointer.press('world/live');
  await typeGravity(page, pointer, '5');
  await page.until('the change', () => window.gaitsmith.document().environment?.gravity_mps2 === 5);
  const replayed = await page.hash();
  await page.frames(40);
  assert.equal(await page.hash(), replayed);
  assert.equal(await previews(page), false);
  assert.equal(await page.call('results', () => window.gaitsmith.results().length), 0);
  await page.reload();
  await page.click('world/open');
  await page.frames(6);
  assert.equal((await pointer.find('world/live'))?.state.checked, false, 'a reload keeps the choice');
  // A lesson, which shows a part of the page, has it off.
  const lesson = await PageDriver.open(visit.browser, `${visit.address}?panels=style`, { live: true });
  await lesson.click('world/open');
  await lesson.frames(6);
  assert.equal((await new Mouse(lesson).find('world/live'))?.state.checked, false);
  for (const each of [page, lesson]) {
    assert.deepEqual(each.complaints, []);
    await each.close();
  }
}

/** @param {Visit} visit */
async function drawsOnStage({ browser, address }) {
  const page = await PageDriver.open(browser, address, { newcomer: true, plays: true });
  await page.becomePhone();
  await page.frames(10);
  const finger = new Fingers(page);
  const rods = () => page.call('rods', () => window.gaitsmith.document().figure.rods?.length);
  await finger.tap(await finger.centre('figures/draw'));
  await page.frames(10);
  const board = (await finger.find('figure/board'))?.rect;
  assert.ok(board && board.height > 250, 'most of the stage');
  assert.equal((await finger.find('draw/teach'))?.state.disabled, true, 'nothing is drawn yet');
  const at = (/** @type {number} */ x, /** @type {number} */ y) => ({ x: board.x + x * board.width, y: board.y + y * board.height });
  const hip = at(0.4, 0.35);
  // A finger that rests before it draws, draws: no tooltip takes the stroke away.
  const touch = await page.page.touchscreen.touchStart(hip.x, hip.y);
  await sleep(700);
  await page.frames(4);
  for (const right of [0.5, 0.65]) {
    await touch.move(at(right, 0.35).x, hip.y);
    await page.frames(2);
  }
  await touch.end();
  await page.frames(6);
  assert.equal(await rods(), 1);
  // Each next stroke begins where the first one did: the board has not moved under the finger.
  await finger.drag(hip, at(0.3, 0.75));
  assert.equal(await rods(), 2);
  await finger.drag(at(0.65, 0.35), at(0.75, 0.75));
  assert.equal(await rods(), 3);
  await finger.tap(await finger.centre('draw/copy'));
  assert.equal(await rods(), 4);
  await finger.tap(await finger.centre('draw/delete'));
  assert.equal(await rods(), 3);
  await finger.tap(await finger.centre('draw/teach'));
  await page.until('the end of the search', () => window.gaitsmith.results().length > 0);
  assert.ok(await page.call('metres', () => (window.gaitsmith.results()[0]?.score ?? 0) > 0.5), 'it moves');
  assert.equal(await finger.find('figure/board'), undefined, 'the stage is back');
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function givesRoom({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  const mouse = new Mouse(page);
  const width = async () => (await mouse.find('stage'))?.rect.width ?? 0;
  const before = await width();
  const border = await mouse.centre('panel/split');
  await mouse.drag(border, { x: border.x - 100, y: border.y });
  assert.ok(Math.abs(await width() - (before - 100)) <= 2, `${before} to ${await width()}`);
  const wide = await width();
  const moved = await mouse.centre('panel/split');
  await mouse.drag(moved, { x: 5, y: moved.y });
  assert.ok(await width() >= 0.4 * 1280, 'the panel never takes the stage');
  assert.ok(await width() < wide);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @type {[string, (visit: Visit) => Promise<void>][]} */
export const LIVE_SCENARIOS = [
  ['Live: gravity dragged and gravity typed find the same motion, one step of Undo', dragsGravity],
  ['Live is off where a person or a lesson wants it off', switchesOff],
  ['a figure drawn on the empty stage by finger learns to move', drawsOnStage],
  ['the border between stage and panel can be moved', givesRoom],
];
