// SPDX-License-Identifier: MIT
// Teaching by example: a way drawn on the stage, a pose made by dragging limbs, and what searches make of them.
import assert from 'node:assert/strict';
import { Mouse } from '../pointers.mjs';
import { PageDriver } from '../page_driver.mjs';

/** @typedef {import('./all.mjs').Visit} Visit */

/** @param {PageDriver} page */
const task = (page) => page.call('task', () => {
  const { shown, weights } = window.gaitsmith.document().task ?? {};
  return { shown, weights };
});
/** @param {PageDriver} page @param {string} id */
const press = async (page, id) => {
  await new Mouse(page).scrollTo(id);
  await page.click(id);
  await page.frames(4);
};

/** Shows the form, and the same motion in every browser. @param {Visit} visit */
async function lesson({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  await page.call('example', () => window.gaitsmith.run('panel/Style'));
  await page.frames(4);
  await press(page, 'style/example');
  return page;
}

/** @param {Visit} visit */
async function way(visit) {
  const page = await lesson(visit);
  const before = await page.hash();
  await press(page, 'example/way');
  const stage = await page.placeOf('stage');
  await new Mouse(page).drag({ x: stage.x + 0.45 * stage.width, y: stage.y + 0.6 * stage.height },
    { x: stage.x + 0.8 * stage.width, y: stage.y + 0.45 * stage.height });
  const { shown, weights } = await task(page);
  assert.ok(shown?.way?.length === 12 && weights?.on_way === 10, JSON.stringify({ shown, weights }));
  const xs = shown.way.map(({ x_m = 0 }) => x_m);
  assert.ok(xs.every((x, i) => i === 0 || x > xs[i - 1]), `to the right: ${xs}`);
  assert.equal(await page.hash(), before, 'what is shown changes no motion');
  await new Mouse(page).scrollTo('example/point');
  await press(page, 'example/way/forget');
  assert.equal((await task(page)).shown, undefined);
  await page.press('Control+z');
  assert.equal((await task(page)).shown?.way?.length, 12, 'Undo brings it back');
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function pose(visit) {
  const page = await lesson(visit);
  await page.call('seek', () => {
    window.gaitsmith.run('motion/start');
    for (let step = 0; step < 150; step++) window.gaitsmith.run('motion/forward');
  });
  await press(page, 'example/pose');
  const { shown } = await task(page);
  assert.ok(shown?.pose_step === 150 && (shown.pose ?? []).length > 1, JSON.stringify(shown));
  const stage = await page.placeOf('stage');
  // The figure is near the middle. A drag somewhere on it turns a limb or all of it, and moves neither view nor motion.
  const hash = await page.hash();
  let turned = false;
  for (let y = 0.3; y < 0.8 && !turned; y += 0.06) {
    for (let x = 0.35; x < 0.6 && !turned; x += 0.04) {
      const at = { x: stage.x + x * stage.width, y: stage.y + y * stage.height };
      await new Mouse(page).drag(at, { x: at.x + 50, y: at.y - 30 });
      turned = JSON.stringify((await task(page)).shown) !== JSON.stringify(shown);
    }
  }
  assert.ok(turned, 'a limb follows the drag');
  assert.equal(await page.hash(), hash);
  assert.ok(!(await page.widgets()).some(({ id }) => id === 'stage/follow'), 'the view stays');
  await press(page, 'example/pose/forget');
  assert.equal((await task(page)).shown, undefined);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @type {import('./all.mjs').Scenario[]} */
export const TEACH_SCENARIOS = [
  ['teach by example: a way drawn on the stage is part of the task, and can be forgotten', way],
  ['teach by example: a pose is made by dragging limbs', pose],
];
