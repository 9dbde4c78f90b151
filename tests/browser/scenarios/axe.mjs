// SPDX-License-Identifier: MIT
// axe, the accessibility checker, finds no errors in the page's various states. Only in Chromium, because axe looks at
// the page's elements, which are the same in all browsers.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { ROOT } from '../browsers.mjs';
import { PageDriver } from '../page_driver.mjs';

/** @typedef {import('./all.mjs').Visit} Visit */

const axe = () => readFile(join(ROOT, 'web/node_modules/axe-core/axe.min.js'), 'utf8');

/** One line per violated rule, with its elements. @param {PageDriver} page @returns {Promise<string[]>} */
const violations = (page) => page.call('axe', `axe.run({ resultTypes: ['violations'] }).then(({ violations }) => violations.map(
  ({ id, impact, nodes }) => [impact, id, ...nodes.slice(0, 4).map(({ html }) => html.slice(0, 160))].join(' | ')))`);

/** Waits for a widget's element and clicks it. @param {PageDriver} page @param {string} id */
async function pressWidget(page, id) {
  const node = await page.page.waitForSelector(`#mirror [data-id="${id}"]`, { timeout: 20000 });
  await node?.evaluate((found) => { /** @type {HTMLElement} */ (found).click(); });
}

/** @param {Visit} visit */
async function noViolations({ browser, address, figures }) {
  const source = await axe();
  const page = await PageDriver.open(browser, address);
  /** @type {string[]} */
  const seen = [];
  let looks = 0;
  const checkPage = async (/** @type {string} */ where) => {
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
      await checkPage(place('at rest'));
      // Make sure that axe works: it finds an intentional violation.
      if (looks === 1) {
        await page.call('break', () => { document.querySelector('html')?.removeAttribute('lang'); });
        await checkPage('broken on purpose');
        assert.ok(seen.splice(0).some((line) => line.includes('html-has-lang')), 'axe does not see what is wrong');
        await page.reload();
        await page.page.evaluate(source);
      }
      for (const panel of ['Figure', 'Controller', 'Style', 'Search', 'Lab', ...(width < 700 ? ['Timeline'] : [])]) {
        await pressWidget(page, `panels/${['Figure', 'Controller', 'Style', 'Search', 'Lab', 'Timeline'].indexOf(panel)}`);
        await page.frames(6);
        if (panel === 'Controller') await pressWidget(page, 'controller/rule/1');
        if (panel === 'Search') await pressWidget(page, 'search/algorithm');
        await checkPage(place(`the ${panel} panel`));
        if (panel === 'Search') {
          await page.page.focus('[data-id="search/algorithm/0"]').catch(() => {});
          await page.press('Escape');
        }
      }
      await pressWidget(page, 'world/open');
      await checkPage(place('the World card'));
      for (const [key, what] of [['Control+k', 'the palette'], ['F1', 'the sheet of keys'], ['Control+o', 'the dialog that opens']]) {
        await page.page.focus('canvas');
        await page.press(key);
        await page.until(what, () => document.querySelector('dialog[open]') !== null);
        await checkPage(place(what));
        await page.press('Escape');
      }
      await page.call('export', () => window.gaitsmith.run('document/export'));
      await page.until('the dialog that exports', () => document.querySelector('#export-dialog')?.hasAttribute('open') ?? false);
      await checkPage(place('the dialog that exports'));
      await page.press('Escape');
      await page.call('breed', () => window.gaitsmith.run('motion/breed'));
      await page.until('nine motions', () => [...document.querySelectorAll('#breed-tiles .tile')].filter((tile) => /** @type {HTMLElement} */ (tile).title).length === 9);
      await page.press('2');
      await page.press('n');
      await page.until('their children', () => document.querySelectorAll('#breed-rounds canvas.picked').length === 1);
      await checkPage(place('breeding'));
      await page.press('Escape');
      await page.page.evaluate(() => { location.hash = '#AZ4'; });
      await checkPage(place('an error'));
      await page.clickElement('#banner-close');
      await page.page.focus('#describe');
      await checkPage(place('the motion in words'));
    }
  }
  figures['states that axe looked at'] = looks;
  assert.deepEqual([...new Set(seen)], []);
  await page.close();
}

/** @type {[string, (visit: Visit) => Promise<void>, string?][]} */
export const AXE_SCENARIOS = [
  ['axe finds nothing wrong with the page, its panels, dialogs and sizes', noViolations, 'Chromium'],
];
