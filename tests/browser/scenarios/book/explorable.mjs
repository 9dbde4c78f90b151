// SPDX-License-Identifier: MIT
// "How things learn to move": light, soon alive, and each stage answers a drag.
import assert from 'node:assert/strict';
import { gzipSync } from 'node:zlib';
import { ONE_BROWSER, PATIENCE_MS } from '../../page_driver.mjs';

/** @typedef {import('../all.mjs').Visit} Visit */

/** @param {Visit} visit */
async function explorable(visit) {
  const page = await (await visit.browser.createBrowserContext()).newPage();
  await page.setViewport({ width: 1280, height: 720 });
  /** @type {Promise<number>[]} */
  const sizes = [];
  /** @type {string[]} */
  const faults = [];
  page.on('response', (response) => { if (response.status() === 200) sizes.push(response.buffer().then((body) => gzipSync(body, { level: 9 }).length, () => 0)); });
  page.on('pageerror', (error) => faults.push(/** @type {Error} */ (error).message));
  page.on('console', (message) => { if (message.type() === 'error') faults.push(message.text()); });
  await page.goto(`${visit.address}book/how-things-learn-to-move.html`);
  await page.waitForFunction(() => performance.getEntriesByName('gaitsmith-first-frame').length > 0, { timeout: PATIENCE_MS });
  visit.figures['explorable, open to first frame, ms'] = await page.evaluate(() => Math.round(performance.getEntriesByName('gaitsmith-first-frame')[0].startTime));
  const bytes = (await Promise.all(sizes)).reduce((sum, size) => sum + size, 0);
  visit.figures['explorable, gzip (KB)'] = Math.round(bytes / 1000);
  assert.ok(bytes <= 260_000, `${bytes} bytes`);

  const count = await page.evaluate(() => document.querySelectorAll('figure.stage').length);
  assert.ok(count >= 12, `${count} stages`);
  for (let i = 0; i < count; i++) {
    await page.evaluate((k) => document.querySelectorAll('figure.stage')[k].scrollIntoView({ block: 'center' }), i);
    await page.waitForFunction((k) => /\d/.test(document.querySelectorAll('figure.stage .said')[k].textContent ?? ''), { timeout: PATIENCE_MS }, i);
    const before = await page.evaluate((k) => document.querySelectorAll('figure.stage')[k].textContent ?? '', i);
    await page.evaluate((k) => {
      const input = /** @type {HTMLInputElement} */ (document.querySelectorAll('figure.stage')[k].querySelector('input'));
      if (input.type === 'checkbox') input.click();
      else {
        input.value = String((Number(input.min) + 2 * Number(input.max)) / 3);
        input.dispatchEvent(new Event('input'));
      }
    }, i);
    await page.waitForFunction((k, old) => document.querySelectorAll('figure.stage')[k].textContent !== old, { timeout: PATIENCE_MS }, i, before);
  }
  // What is out of sight rests.
  const begun = await page.evaluate(() => document.querySelectorAll('figure.stage.live').length);
  assert.equal(begun, count);
  await page.goto(`${visit.address}book/de/how-things-learn-to-move.html`);
  await page.waitForFunction(() => document.querySelector('figure.stage .said')?.textContent === '25,9 m in 8 s.' && document.querySelector('figure.stage label span')?.textContent === 'Zeitpunkt', { timeout: PATIENCE_MS });
  assert.deepEqual(faults, []);
  await page.browserContext().close();
}

/** @type {import('../all.mjs').Scenario[]} */
export const EXPLORABLE_SCENARIOS = [
  ['the explorable is light, and each of its stages answers', explorable, ONE_BROWSER],
];
