// SPDX-License-Identifier: MIT
// The part of the application that is loaded after the first frame.
import assert from 'node:assert/strict';
import { PageDriver } from '../page_driver.mjs';

/** @typedef {import('./all.mjs').Visit} Visit */

/** The page waits where a function is called that is not there yet. @param {Visit} visit */
async function calledBefore({ browser, address }) {
  const page = await PageDriver.open(browser, address, { newcomer: true, before: () => {
    const { fetch } = window;
    window.fetch = (asked, options) => (String(asked).includes('app_rest.wasm') ? new Promise(() => {}) : fetch(asked, options));
  } });
  await page.call('a panel', () => window.gaitsmith.run('panel/Style'));
  await page.until('its sliders', () => window.gaitsmith.widgets().some(({ id }) => id.startsWith('style/')));
  await page.call('synthesize', () => window.gaitsmith.synthesize({ evaluations: 400, seed: 2 }).then(() => true));
  assert.equal(await page.call('loaded', () => performance.getEntriesByType('resource').filter(({ name }) => name.includes('app_rest.wasm')).length), 1);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** A part of another build would call wrong functions. @param {Visit} visit */
async function anotherVersion({ browser, address }) {
  const page = await PageDriver.open(browser, address, { newcomer: true, before: () => {
    const { fetch } = window;
    const empty = () => Promise.resolve(new Response(Uint8Array.of(0, 0x61, 0x73, 0x6d, 1, 0, 0, 0)));
    window.fetch = (asked, options) => (String(asked).includes('app_rest.wasm') ? empty() : fetch(asked, options));
  } });
  await page.until('the banner', () => /reload/i.test(document.querySelector('#banner-text')?.textContent ?? ''));
  await page.close();
}

/** @type {import('./all.mjs').Scenario[]} */
export const REST_SCENARIOS = [
  ['a panel opens before the part with panels is loaded', calledBefore],
  ['a part of another version is refused, and the page asks to be loaded again', anotherVersion],
];
