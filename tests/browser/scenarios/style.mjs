// SPDX-License-Identifier: MIT
// The Style panel: weights and the sum that they make.
import assert from 'node:assert/strict';
import { PageDriver } from '../page_driver.mjs';

/** @param {import('./all.mjs').Visit} visit */
async function weighs({ browser, address }) {
  const fresh = await PageDriver.open(browser, address);
  const weights = () => fresh.call('weights', () => window.gaitsmith.document().task?.weights ?? {});
  await fresh.page.evaluate(() => {
    const document = window.gaitsmith.document();
    window.gaitsmith.open({ ...document, task: { ...document.task, weights: { slip_sum: 0.5, upright: 4 } } });
  });
  await fresh.forward(200);
  const before = await fresh.hash();
  await fresh.click('panels/2');
  await fresh.click('style/sum');
  const note = (await fresh.widgets()).find(({ id }) => id === 'style/score');
  assert.match(note?.value ?? '', /^Score .*: travel.* m; slip .* m times 0\.5 adds .*; upright .* times 4\.0 .*\. Not weighed: .*effort/);
  const stage = (await fresh.widgets()).find(({ id }) => id === 'stage')?.rect ?? { x: 0, y: 0, width: 0, height: 0 };
  await fresh.page.mouse.move(stage.x + stage.width + 100, stage.y + 200);
  const scrollTo = async (/** @type {string} */ wanted) => {
    for (let turns = 0; turns < 40 && !(await fresh.widgets()).some(({ id }) => id === wanted); turns++) {
      await fresh.page.mouse.wheel({ deltaY: 100 });
      await fresh.frames();
    }
  };
  await scrollTo('style/effort');
  await fresh.click('style/effort'); // the middle of its track, weight 0
  await fresh.page.keyboard.press('ArrowLeft', { delay: 60 });
  await fresh.frames();
  await fresh.page.keyboard.press('ArrowLeft', { delay: 60 });
  await fresh.frames();
  const { effort = 0 } = await weights();
  assert.ok(Math.abs(effort + 0.005) < 0.0014, `effort weighs ${effort}`); // two steps of a twentieth of the usual 0.05
  await fresh.page.focus('#describe');
  await fresh.page.keyboard.press('Enter');
  await fresh.frames();
  assert.match(await fresh.call('text', () => document.querySelector('#description')?.textContent ?? ''),
    / Score .*; effort .* rad times −0\.00\d takes away /);
  await scrollTo('style/reset');
  await fresh.click('style/reset');
  assert.ok(Object.values(await weights()).every((weight) => weight === 0), 'a weight was not reset');
  assert.equal(await fresh.hash(), before);
  assert.deepEqual(fresh.complaints, []);
  await fresh.close();
}

/** @type {import('./all.mjs').Scenario[]} */
export const STYLE_SCENARIOS = [
  ['the Style panel weighs further terms by mouse and key, shows the sum, and resets', weighs],
];
