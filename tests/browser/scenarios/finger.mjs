// SPDX-License-Identifier: MIT
// A finger on a slider sets a value or scrolls, depending on its direction. Each scenario opens its own page.
import assert from 'node:assert/strict';
import { Fingers } from '../pointers.mjs';
import { PageDriver } from '../page_driver.mjs';

/** @typedef {import('./all.mjs').Visit} Visit */

/** @param {Visit} visit */
async function setsOrScrolls({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  await page.becomePhone();
  await page.frames(10);
  const pointer = new Fingers(page);
  await pointer.press('panels/1');
  const rules = () => page.call('rules', () => /** @type {{rules?: number}} */ (window.gaitsmith.document()).rules ?? 10);
  const slider = async () => {
    await pointer.scrollTo('controller/rules', 40);
    const rect = (await pointer.find('controller/rules'))?.rect;
    assert.ok(rect);
    return { rect, track: rect.y + rect.height - 13, at: (/** @type {number} */ share) => rect.x + share * rect.width };
  };
  const before = await rules();
  const { rect, track, at } = await slider();
  await pointer.drag({ x: at(0.2), y: track }, { x: at(0.2) + 4, y: track - 90 });
  assert.equal(await rules(), before, 'a finger that goes up scrolls');
  assert.notDeepEqual((await pointer.find('controller/rules'))?.rect.y, rect.y, 'the panel has moved');

  let now = await slider();
  await pointer.drag({ x: now.at(0.5), y: now.track }, { x: now.at(0.8), y: now.track + 4 });
  const sideways = await rules();
  assert.ok(sideways > before, `a finger that goes sideways sets: ${sideways}`);
  now = await slider();
  await pointer.tap({ x: now.at(0.1), y: now.track });
  assert.ok(await rules() < before, 'so does one that is lifted where it came down');
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** Phones held sideways, and text enlarged fourfold: the stage stays, and every panel can be reached. @param {Visit} visit */
async function lowWindows({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  const widget = async (/** @type {string} */ id) => (await page.widgets()).find((one) => one.id === id);
  const inWorld = async () => (await page.widgets()).some(({ id }) => id.startsWith('world/') && id !== 'world/open');
  for (const [width, height, covers] of /** @type {const} */ ([[844, 390, false], [915, 412, false], [667, 375, true], [640, 360, true], [320, 256, true]])) {
    await page.page.setViewport({ width, height });
    await page.frames(10);
    const stage = (await widget('stage'))?.rect.height ?? 0;
    assert.ok(stage >= 110, `${width} x ${height}: the stage is ${stage} px high`);
    await page.click('panels/3');
    assert.ok(await widget('search/start'), `${width} x ${height}: the search panel opens`);
    if (!covers) continue;
    assert.equal(await widget('stage'), undefined, `${width} x ${height}: the panel lies over the stage`);
    await page.click('panels/3');
    assert.ok(await widget('stage'), `${width} x ${height}: a second press closes the panel`);
    assert.equal(await widget('search/start'), undefined);
    await page.click('world/open');
    assert.ok(await inWorld(), `${width} x ${height}: the world card opens`);
    await page.click('panels/3');
    assert.ok(!await inWorld(), `${width} x ${height}: a press on a tab closes it`);
    await page.call('another panel', () => window.gaitsmith.run('panel/Style'));
    await page.frames();
    assert.ok(await widget('style/task'), 'a command opens its panel');
    await page.click('panels/2');
    assert.ok(await widget('stage'));
  }
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @type {[string, (visit: Visit) => Promise<void>][]} */
export const FINGER_SCENARIOS = [
  ['a finger on a slider scrolls the panel when it goes up, and sets when it goes sideways or taps', setsOrScrolls],
  ['low windows keep the figure, and a press on a tab opens its panel', lowWindows],
];
