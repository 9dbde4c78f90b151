// SPDX-License-Identifier: MIT
// Themes: colours, and that enlarged widgets are clicked where they are drawn. Each scenario opens its own page.
import assert from 'node:assert/strict';
import { PageDriver } from '../page_driver.mjs';

/** @typedef {import('./all.mjs').Visit} Visit */

/** @type {Record<string, {palette: string, scale: string}>} */
const LOOKS = {
  light: { palette: 'light', scale: 'normal' },
  dark: { palette: 'dark', scale: 'normal' },
  projector: { palette: 'strong-light', scale: 'large' },
  contrast: { palette: 'strong-light', scale: 'normal' },
  system: { palette: 'light', scale: 'normal' },
};

/** @param {PageDriver} page */
const appearance = (page) => page.call('look', () => {
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
    assert.deepEqual(await appearance(page), { palette, scale, chosen: theme });
    // Enlarged widgets can be clicked, and the mirror matches them.
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
  assert.deepEqual(await appearance(page), { ...LOOKS.projector, chosen: 'projector' }, 'remembered');
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** Runs in the page before its scripts: fakes the system's preferences, because browsers let tests change only some. */
function fakePreferences() {
  const preferences = { dark: false, contrast: false };
  const queries = /** @type {EventTarget[]} */ ([]);
  const real = window.matchMedia.bind(window);
  window.matchMedia = (query) => {
    const preference = /color-scheme: dark/.test(query) ? 'dark' : /prefers-contrast: more/.test(query) ? 'contrast' : null;
    if (!preference) return real(query);
    const answer = Object.defineProperty(new EventTarget(), 'matches', { get: () => preferences[preference] });
    queries.push(answer);
    return /** @type {MediaQueryList} */ (answer);
  };
  Object.assign(window, { testWish: (/** @type {object} */ preference) => {
    Object.assign(preferences, preference);
    for (const query of queries) query.dispatchEvent(new Event('change'));
  } });
}

/** @param {Visit} visit */
async function asTheSystem({ browser, address }) {
  const page = await PageDriver.open(browser, address, { before: fakePreferences });
  for (const [preference, palette] of /** @type {const} */ ([['{}', 'light'], ['{ dark: true }', 'dark'],
    ['{ contrast: true }', 'strong-dark'], ['{ dark: false }', 'strong-light'], ['{ contrast: false }', 'light']])) {
    await page.call('wish', `window.testWish(${preference})`);
    assert.deepEqual(await appearance(page), { palette, scale: 'normal', chosen: 'system' }, preference);
  }
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** Text stays readable on every main button, at rest, under the mouse, and after a click. @param {Visit} visit */
async function mainButtons({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  /** Contrast of the button's text [WCAG 2.2]. @param {string} id */
  const contrast = (id) => page.page.evaluate((selector) => {
    const style = getComputedStyle(/** @type {Element} */ (document.querySelector(selector)));
    const luminance = (/** @type {string} */ colour) => {
      const [r = 0, g = 0, b = 0, a = 1] = (colour.match(/[\d.]+/g) ?? []).map(Number);
      if (a < 1) throw new Error(`${colour} is not opaque`);
      const [lr = 0, lg = 0, lb = 0] = [r, g, b].map((c) => (c <= 10.31 ? c / 3294.6 : ((c / 255 + 0.055) / 1.055) ** 2.4));
      return 0.2126 * lr + 0.7152 * lg + 0.0722 * lb;
    };
    const [dark = 0, light = 1] = [luminance(style.color), luminance(style.backgroundColor)].sort((x, y) => x - y);
    return (light + 0.05) / (dark + 0.05);
  }, id);
  for (const theme of Object.keys(LOOKS)) {
    await page.page.select('#theme', theme);
    await page.page.mouse.move(5, 300);
    assert.ok(await contrast('#copy-link') >= 4.5, `${theme}: at rest`);
    await page.page.hover('#copy-link');
    assert.ok(await contrast('#copy-link') >= 4.5, `${theme}: under the mouse ${await contrast('#copy-link')}`);
    await page.page.click('#open');
    await page.until('the dialog', () => document.querySelector('#open-dialog')?.hasAttribute('open') ?? false);
    await page.page.hover('#open-go');
    assert.ok(await contrast('#open-go') >= 4.5, `${theme}: in a dialog, under the mouse`);
    await page.page.keyboard.press('Escape');
  }
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @type {[string, (visit: Visit) => Promise<void>][]} */
export const THEME_SCENARIOS = [
  ['every theme is drawn, clicked and mirrored in its own size, and is remembered', chosen],
  ['without a choice the page looks as the system does, in contrast too', asTheSystem],
  ['main buttons stay readable under the mouse', mainButtons],
];
