// SPDX-License-Identifier: MIT
// How the page looks, and that what is looked at is where it is clicked. Each opens a page of its own.
import assert from 'node:assert/strict';
import { PageDriver } from './page_driver.mjs';

/** @typedef {import('./scenarios.mjs').Visit} Visit */

/** @type {Record<string, {palette: string, scale: string}>} */
const LOOKS = {
  light: { palette: 'light', scale: 'normal' },
  dark: { palette: 'dark', scale: 'normal' },
  projector: { palette: 'strong-light', scale: 'large' },
  contrast: { palette: 'strong-light', scale: 'normal' },
  system: { palette: 'light', scale: 'normal' },
};

/** @param {PageDriver} page */
const look = (page) => page.call('look', () => {
  const { theme, scale } = document.documentElement.dataset;
  const list = document.querySelector('#theme');
  return { palette: theme, scale, chosen: list instanceof HTMLSelectElement ? list.value : '' };
});

/** @param {Visit} visit */
async function chosen({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  const sums = new Map();
  for (const [theme, { palette, scale }] of Object.entries(LOOKS)) {
    await page.page.select('#theme', theme);
    await page.frames(6);
    assert.deepEqual(await look(page), { palette, scale, chosen: theme });
    // What a theme draws larger is clicked where it then stands, and the mirror lies over it.
    for (const panel of ['panels/0', 'panels/2']) {
      await page.click(panel);
      const widget = (await page.widgets()).find(({ id }) => id === panel);
      assert.ok(widget?.state.selected, `${theme}: a click on ${panel}`);
      const mirrored = await page.page.evaluate((id) => {
        const { left, top, width, height } = document.querySelector(`#mirror [data-id="${id}"]`)?.getBoundingClientRect() ?? new DOMRect();
        return { left, top, width, height };
      }, panel);
      const { x, y, width, height } = widget.rect;
      for (const [here, there] of [[x, mirrored.left], [y, mirrored.top], [width, mirrored.width], [height, mirrored.height]]) {
        assert.ok(Math.abs(here - there) < 1.5, `${theme}: the mirror of ${panel} is off by ${here - there}`);
      }
    }
    sums.set(theme, (await page.stage()).spread);
  }
  assert.ok(sums.get('dark') !== sums.get('light'), 'the canvas follows');
  await page.page.select('#theme', 'projector');
  await page.reload();
  assert.deepEqual(await look(page), { ...LOOKS.projector, chosen: 'projector' }, 'remembered');
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** Runs before the page's own scripts: the system's wishes, which no browser lets a test change in full. */
function wishfulSystem() {
  const wishes = { dark: false, contrast: false };
  const queries = /** @type {EventTarget[]} */ ([]);
  const real = window.matchMedia.bind(window);
  window.matchMedia = (query) => {
    const wish = /color-scheme: dark/.test(query) ? 'dark' : /prefers-contrast: more/.test(query) ? 'contrast' : null;
    if (!wish) return real(query);
    const answer = Object.defineProperty(new EventTarget(), 'matches', { get: () => wishes[wish] });
    queries.push(answer);
    return /** @type {MediaQueryList} */ (answer);
  };
  Object.assign(window, { testWish: (/** @type {object} */ wish) => {
    Object.assign(wishes, wish);
    for (const query of queries) query.dispatchEvent(new Event('change'));
  } });
}

/** @param {Visit} visit */
async function asTheSystem({ browser, address }) {
  const page = await PageDriver.open(browser, address, { before: wishfulSystem });
  for (const [wish, palette] of /** @type {const} */ ([['{}', 'light'], ['{ dark: true }', 'dark'],
    ['{ contrast: true }', 'strong-dark'], ['{ dark: false }', 'strong-light'], ['{ contrast: false }', 'light']])) {
    await page.call('wish', `window.testWish(${wish})`);
    assert.deepEqual(await look(page), { palette, scale: 'normal', chosen: 'system' }, wish);
  }
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @type {[string, (visit: Visit) => Promise<void>][]} */
export const THEME_SCENARIOS = [
  ['every theme is drawn, clicked and mirrored in its own size, and is remembered', chosen],
  ['without a choice the page looks as the system does, in contrast too', asTheSystem],
];
