// SPDX-License-Identifier: MIT
// Drawing by copying: a limb copied and deleted, a figure mirrored. Each opens pages of its own.
import assert from 'node:assert/strict';
import { Mouse } from './hands.mjs';
import { PageDriver } from './page_driver.mjs';

/** @typedef {import('./scenarios.mjs').Visit} Visit */

/** @param {Visit} visit */
async function copiesAndMirrors({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  const widget = async (/** @type {string} */ id) => (await page.widgets()).find((candidate) => candidate.id === id);
  const rods = () => page.call('rods', () => window.gaitsmith.document().figure.rods?.length);
  const stage = (await widget('stage'))?.rect ?? { x: 0, y: 0, width: 0, height: 0 };
  const toTheEnd = async () => { // of the panel
    await page.page.mouse.move(stage.x + stage.width + 100, stage.y + 60);
    await page.page.mouse.wheel({ deltaY: 3000 });
    await page.frames();
  };
  const before = await page.hash();
  await page.click('panels/0');
  const board = (await widget('figure/board'))?.rect;
  assert.ok(board);
  assert.equal(await rods(), 5);
  await new Mouse(page).press('figure/rod/more'); // the root cannot be copied, the second rod can
  await toTheEnd();
  await page.click('figure/copy');
  assert.equal(await rods(), 6);
  await page.click('figure/delete'); // the copy, which is the selected one now
  assert.equal(await rods(), 5);
  await page.clickElement('#undo');
  await page.clickElement('#undo');
  await page.frames();
  assert.equal(await page.hash(), before, 'as it was, controllers and all');

  await toTheEnd();
  await page.click('figure/mirror');
  assert.notEqual(await page.hash(), before);
  await page.clickElement('#undo');
  await page.frames();
  assert.equal(await page.hash(), before);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @type {[string, (visit: Visit) => Promise<void>][]} */
export const FIGURE_SCENARIOS = [['a limb copied and deleted, a figure mirrored; Undo brings back each', copiesAndMirrors]];
