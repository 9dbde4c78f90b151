// SPDX-License-Identifier: MIT
// The front of NSGA-II in the Search panel: by mouse and by keys, and what the stage then shows. The scenario opens its own
// page.
import assert from 'node:assert/strict';
import { active, reached, settle } from '../assistive.mjs';
import { PageDriver } from '../page_driver.mjs';

/** @typedef {import('./all.mjs').Visit} Visit */

const SECONDS = 2;

/** The points: what they say, and where they are. @param {PageDriver} page */
async function pointsOf(page) {
  return (await page.widgets()).filter(({ id }) => /^front\/\d+$/.test(id)).map(({ id, label, value, rect }) => {
    const [, cost] = /^Effort, radians a second and joint: ([\d.]+)$/.exec(label) ?? assert.fail(label);
    const [, score] = /^score (−?[\d.]+)$/.exec(value) ?? assert.fail(value);
    return { id, cost, score, x: rect.x + rect.width / 2, y: rect.y + rect.height / 2, rect };
  });
}

/** The motion on the stage, in the terms of the front. @param {PageDriver} page */
const shown = (page) => page.page.evaluate((seconds) => {
  const { gaitsmith } = window;
  const measures = gaitsmith.measures();
  const joints = (gaitsmith.document().figure.rods ?? []).length - 1;
  return { score: Number(measures.travel).toFixed(2).replace('-', '−'), cost: (Number(measures.effort) / seconds / joints).toFixed(2),
    hash: gaitsmith.hash(), title: gaitsmith.document().title };
}, SECONDS);

/** What the panel says of the point under the pointer, or with the keyboard. @param {PageDriver} page */
async function pointed(page) {
  await settle(page);
  return page.call('words', () => [...document.querySelectorAll('#mirror p')].map(({ textContent }) => /Pointed at: .*/.exec(textContent ?? '')?.[0]).find((text) => text));
}

/** The picture of the stage after one and a half seconds of the motion. @param {PageDriver} page */
async function pictured(page) {
  await page.play(false);
  await page.page.evaluate(() => window.gaitsmith.run('motion/start'));
  await page.forward(150);
  await page.frames(4);
  return (await page.stage()).sum;
}

/** @param {Visit} visit */
async function clicked({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  await page.page.setViewport({ width: 1280, height: 1300 });
  // Without weights, the score is the metres to the right.
  await page.page.evaluate((steps) => {
    const { gaitsmith } = window;
    gaitsmith.open({ ...gaitsmith.document(), hash: undefined, title: 'Before', task: { kind: 'travel-right', duration_steps: steps },
      search: { algorithm: 'nsga-ii', seed: 3, evaluations: 400, genetic: { population: 50 } }, view: { panel: 3 } });
  }, 100 * SECONDS);
  assert.deepEqual(await pointsOf(page), [], 'no front before the search');
  await page.call('search', () => window.gaitsmith.synthesize({}).then(() => true));
  await settle(page);

  // At first the stage shows the last point, which scores most.
  const points = await pointsOf(page);
  assert.ok(points.length > 3, `${points.length} points`);
  assert.equal((await page.widgets()).find(({ id }) => id === 'front')?.value, `${points.length}`);
  const best = await shown(page);
  const highest = points[points.length - 1];
  assert.deepEqual([best.score, best.cost], [highest.score, highest.cost]);
  const bestPicture = await pictured(page);

  // A click on a point between the ends that no other one covers.
  const free = points.findIndex(({ x, y }, i) => i > 0 && i < points.length - 1
    && points.every(({ rect }, other) => other === i || x < rect.x || x > rect.x + rect.width || y < rect.y || y > rect.y + rect.height));
  assert.ok(free > 0, 'all points overlap');
  const middle = points[free];
  assert.notEqual(middle.score, highest.score);
  await page.click(middle.id);
  await page.frames(4);
  const cheaper = await shown(page);
  assert.deepEqual([cheaper.score, cheaper.cost], [middle.score, middle.cost]);
  assert.notEqual(cheaper.hash, best.hash);
  assert.match(cheaper.title ?? '', /^Mr\. Star-Man · travel to the right/);
  assert.equal(await page.text('#title'), cheaper.title);
  assert.equal(await page.status(), `${cheaper.title}. “Save to results” keeps it. Undo restores the previous version.`);
  assert.equal(await pointed(page), `Pointed at: ${middle.score} for ${middle.cost}.`);
  assert.notEqual(await pictured(page), bestPicture);

  // Another one by keys: Tab enters the front, arrows move in it, Enter shows.
  await page.page.focus('#mirror [data-id="front"]');
  await page.press('Tab');
  await reached(page, 'front/0');
  await page.press('ArrowRight');
  await reached(page, /^front\/[1-9]/);
  const arrived = await active(page);
  assert.notEqual(arrived, middle.id);
  const there = points.find(({ id }) => id === arrived) ?? assert.fail(arrived);
  await page.press('Enter');
  await page.until('another motion', `window.gaitsmith.hash() !== ${JSON.stringify(cheaper.hash)}`);
  const byKeys = await shown(page);
  assert.equal(await pointed(page), `Pointed at: ${there.score} for ${there.cost}.`);
  assert.deepEqual([byKeys.score, byKeys.cost], [there.score, there.cost]);

  // Each is one step of Undo.
  for (const former of [cheaper, best]) {
    await page.clickElement('#undo');
    await page.frames(4);
    assert.deepEqual(await shown(page), former);
  }
  assert.deepEqual((await pointsOf(page)).map(({ id, cost, score }) => [id, cost, score]), points.map(({ id, cost, score }) => [id, cost, score]), 'the front stays');
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @type {import('./all.mjs').Scenario[]} */
export const FRONT_SCENARIOS = [
  ['a point of the front of NSGA-II, clicked or by keys, is the motion on the stage, and Undo goes back', clicked],
];
