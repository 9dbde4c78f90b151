// SPDX-License-Identifier: MIT
// The tour of the playground, which a person asks for. Each scenario opens its own pages.
import assert from 'node:assert/strict';
import { ONE_BROWSER, PageDriver } from '../page_driver.mjs';

/** @typedef {import('./all.mjs').Visit} Visit */

/** @param {PageDriver} page */
const tourState = (page) => page.call('tour', () => {
  const box = (/** @type {string} */ id) => {
    const node = document.querySelector(id);
    const { left, top, right, bottom } = node?.getBoundingClientRect() ?? new DOMRect();
    return { left, top, right, bottom, shown: node instanceof HTMLElement && !node.hidden };
  };
  return { card: box('#tour'), mark: box('#tour-mark'), count: document.querySelector('#tour-count')?.textContent ?? '',
    title: document.querySelector('#tour-title')?.textContent ?? '', width: innerWidth, height: innerHeight };
});

/** @param {Visit} visit */
async function sixSteps({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  for (const [width, height] of [[1280, 720], [390, 844]]) {
    await page.page.setViewport({ width, height, deviceScaleFactor: 1 });
    await page.call('start', () => window.gaitsmith.run('help/tour'));
    const titles = new Set();
    for (let step = 1; step <= 6; step++) {
      await page.frames(8);
      await page.until('the card is in its place', () => document.querySelector('#tour:not([hidden])') !== null);
      const { card, mark, count, title } = await tourState(page);
      assert.equal(count, `${step} of 6`);
      titles.add(title);
      assert.ok(card.left >= 0 && card.top >= 0 && card.right <= width && card.bottom <= height, `step ${step} leaves the window`);
      assert.ok(mark.shown && mark.right > mark.left, `step ${step} speaks of nothing`);
      const apart = card.right <= mark.left || card.left >= mark.right || card.bottom <= mark.top || card.top >= mark.bottom;
      assert.ok(step === 1 || apart, `step ${step} covers what it speaks of, on ${width} by ${height}`);
      await page.press('Enter'); // "Next" has the focus
    }
    assert.equal(titles.size, 6);
    assert.equal((await tourState(page)).card.shown, false, 'done');
  }
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function skipped({ browser, address }) {
  const page = await PageDriver.open(browser, address, { newcomer: true });
  await page.frames(8);
  assert.equal((await tourState(page)).card.shown, false, 'nobody has asked for it');
  await page.call('start', () => window.gaitsmith.run('help/tour'));
  await page.until('the tour', () => document.querySelector('#tour:not([hidden])') !== null);
  await page.press('Escape');
  assert.equal((await tourState(page)).card.shown, false);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @type {import('./all.mjs').Scenario[]} */
export const TOUR_SCENARIOS = [
  ['the tour shows six parts of the page, on a desk and on a phone', sixSteps],
  ['the tour comes only when asked for, and ends with Escape', skipped, ONE_BROWSER],
];
