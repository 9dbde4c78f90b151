// SPDX-License-Identifier: MIT
// The use of WebGL by the page.
import assert from 'node:assert/strict';
import { ONE_BROWSER, PageDriver } from '../page_driver.mjs';

/** @typedef {import('./all.mjs').Visit} Visit */

/** Runs in the page before its scripts: counts created and deleted WebGL objects. */
function counted() {
  const tally = Object.assign(window, { testMade: 0, testFences: 0, testDraws: 0 });
  /** @type {any} */
  const gl = WebGL2RenderingContext.prototype;
  for (const name of Object.getOwnPropertyNames(gl).filter((each) => /^create|^(?:fenceSync|deleteSync|drawElements)$/.test(each))) {
    const whole = gl[name];
    gl[name] = function (/** @type {unknown[]} */ ...words) {
      if (name === 'fenceSync') tally.testFences++;
      else if (name === 'deleteSync') tally.testFences--;
      else if (name === 'drawElements') tally.testDraws++;
      else tally.testMade++;
      return whole.apply(this, words);
    };
  }
}

/**
 * Frames create no WebGL objects. Emscripten's tables never shrink, so one object per frame would be a memory leak.
 * @param {Visit} visit
 */
async function framesMakeNothing({ browser, address }) {
  const page = await PageDriver.open(browser, address, { before: counted, plays: true });
  const tally = () => page.call('counts', () => {
    const { testMade, testFences, testDraws } = /** @type {any} */ (window);
    return { made: testMade, fences: testFences, draws: testDraws };
  });
  await page.frames(10); // the first frames create typefaces and programs
  const before = await tally();
  assert.ok(before.made > 0);
  await page.frames(60);
  const after = await tally();
  assert.ok(after.draws > before.draws + 60, `${after.draws - before.draws} draws in 60 frames`);
  assert.equal(after.made, before.made);
  assert.ok(after.fences >= 0 && after.fences <= 1, `${after.fences} fences wait`);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/**
 * Where a pixel has two points (deviceScaleFactor of run.mjs), a canvas of one has none. Letters of no pixels have no width,
 * and the mirror no rectangles.
 * @param {Visit} visit
 */
async function pointStays({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  await page.click('panels/3'); // on a low canvas the panel would cover the stage
  const before = await page.widgets();
  const resize = (/** @type {string} */ size) => page.page.evaluate((length) => {
    Object.assign(/** @type {HTMLElement} */ (document.querySelector('canvas')).style, { width: length, height: length });
  }, size);
  await resize('1px');
  await page.until('a canvas of one point', () => document.querySelector('canvas')?.width === 0);
  await page.frames(12);
  await page.until('a mirror of a phone', () => document.querySelector('#mirror [aria-label="Stage"]') === null);
  await resize('');
  await page.until('the whole canvas', () => (document.querySelector('canvas')?.width ?? 0) > 100);
  await page.frames(12);
  assert.deepEqual((await page.widgets()).map(({ id, rect }) => ({ id, rect })), before.map(({ id, rect }) => ({ id, rect })));
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @type {import('./all.mjs').Scenario[]} */
export const GRAPHICS_SCENARIOS = [
  ['frames make nothing in WebGL that stays', framesMakeNothing],
  ['a canvas of one point leaves the page as it was', pointStays, ONE_BROWSER],
];
