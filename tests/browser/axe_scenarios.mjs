// SPDX-License-Identifier: MIT
// What axe, the accessibility checker, has to say about the page in its various states: nothing. In Chromium only, since
// it looks at the page's elements, which are the same everywhere.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { ROOT } from './browsers.mjs';
import { PageDriver } from './page_driver.mjs';

/** @typedef {import('./scenarios.mjs').Visit} Visit */

const axe = () => readFile(join(ROOT, 'web/node_modules/axe-core/axe.min.js'), 'utf8');

/** One line for each rule that is broken, with the elements that break it. @param {PageDriver} page @returns {Promise<string[]>} */
const violations = (page) => page.call('axe', `axe.run({ resultTypes: ['violations'] }).then(({ violations }) => violations.map(
  ({ id, impact, nodes }) => [impact, id, ...nodes.slice(0, 4).map(({ html }) => html.slice(0, 160))].join(' | ')))`);

/** Clicks a widget's element as soon as it is there: on a slow machine a panel takes its time. @param {PageDriver} page @param {string} id */
async function press(page, id) {
  const node = await page.page.waitForSelector(`#mirror [data-id="${id}"]`, { timeout: 20000 });
  await node?.evaluate((found) => { /** @type {HTMLElement} */ (found).click(); });
}

/** @param {Visit} visit */
async function nothingToComplainOf({ browser, address, figures }) {
  const source = await axe();
  const page = await PageDriver.open(browser, address);
  /** @type {string[]} */
  const seen = [];
  let looks = 0;
  const look = async (/** @type {string} */ where) => {
    await page.frames(6);
    looks++;
    seen.push(...(await violations(page)).map((line) => `${where}: ${line}`));
  };
  for (const theme of ['light', 'dark']) {
    await page.page.emulateMediaFeatures([{ name: 'prefers-color-scheme', value: theme }]);
    for (const [width, height] of [[1280, 720], [390, 844]]) {
      await page.page.setViewport({ width, height, deviceScaleFactor: 1 });
      await page.reload();
      await page.page.evaluate(source);
      const place = (/** @type {string} */ what) => `${what}, ${width} by ${height}, ${theme}`;
      await look(place('at rest'));
      // A rule that is broken on purpose is found, or the rest would say nothing.
      if (looks === 1) {
        await page.call('break', () => { document.querySelector('html')?.removeAttribute('lang'); });
        await look('broken on purpose');
        assert.ok(seen.splice(0).some((line) => line.includes('html-has-lang')), 'axe does not see what is wrong');
        await page.reload();
        await page.page.evaluate(source);
      }
      for (const panel of ['Figure', 'Controller', 'Style', 'Search', 'Lab', ...(width < 700 ? ['Timeline'] : [])]) {
        await press(page, `panels/${['Figure', 'Controller', 'Style', 'Search', 'Lab', 'Timeline'].indexOf(panel)}`);
        await page.frames(6);
        if (panel === 'Controller') await press(page, 'controller/rule/1');
        if (panel === 'Search') await press(page, 'search/algorithm');
        await look(place(`the ${panel} panel`));
        if (panel === 'Search') {
          await page.page.focus('[data-id="search/algorithm/0"]').catch(() => {});
          await page.press('Escape');
        }
      }
      await press(page, 'world/open');
      await look(place('the World card'));
      for (const [key, what] of [['Control+k', 'the palette'], ['F1', 'the sheet of keys'], ['Control+o', 'the dialog that opens']]) {
        await page.page.focus('canvas');
        await page.press(key);
        assert.ok(await page.call('dialog', () => document.querySelector('dialog[open]') !== null), `${what} does not open`);
        await look(place(what));
        await page.press('Escape');
      }
      await page.call('export', () => window.gaitsmith.run('document/export'));
      await page.until('the dialog that exports', () => document.querySelector('#export-dialog')?.hasAttribute('open') ?? false);
      await look(place('the dialog that exports'));
      await page.press('Escape');
      await page.page.evaluate(() => { location.hash = '#AZ4'; });
      await look(place('an error'));
      await page.clickElement('#banner-close');
      await page.page.focus('#describe');
      await look(place('the motion in words'));
    }
  }
  figures['states that axe looked at'] = looks;
  assert.deepEqual([...new Set(seen)], []);
  await page.close();
}

/** @type {[string, (visit: Visit) => Promise<void>, string?][]} */
export const AXE_SCENARIOS = [
  ['axe finds nothing wrong with the page, its panels, dialogs and sizes', nothingToComplainOf, 'Chromium'],
];
