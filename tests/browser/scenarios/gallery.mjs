// SPDX-License-Identifier: MIT
// The Open dialog: shipped motions that play, files and links. Each scenario opens its own pages.
import assert from 'node:assert/strict';
import { readdirSync } from 'node:fs';
import { join } from 'node:path';
import { ROOT } from '../browsers.mjs';
import { PageDriver, sleep } from '../page_driver.mjs';

/** @typedef {import('./all.mjs').Visit} Visit */

const MOTIONS = readdirSync(join(ROOT, 'examples/gallery')).filter((name) => name.endsWith('.json')).length;

/** Opens the dialog and waits until a card is painted. @param {PageDriver} page */
async function opened(page) {
  await page.press('Control+o');
  await page.until('the dialog', () => document.querySelector('#open-dialog')?.hasAttribute('open') ?? false);
  await page.until('the gallery', `document.querySelectorAll('#open-gallery button').length === ${MOTIONS}`);
  await page.until('a picture', () => (document.querySelector('#open-gallery canvas')?.getAttribute('width') ?? '') !== '');
  await page.frames(10);
}

/** What the pictures of some cards show. @param {PageDriver} page @param {number} count */
const pictures = (page, count) => page.call('pictures', `[...document.querySelectorAll('#open-gallery canvas')].slice(0, ${count}).map((canvas) => canvas.toDataURL())`);
/** @param {PageDriver} page */
const shown = (page) => page.call('shown', () => document.querySelector('#open-dialog')?.hasAttribute('open') ?? false);

/** @param {Visit} visit */
async function plays({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  const before = await page.hash();
  await page.page.focus('#open');
  await opened(page);
  const first = /** @type {string[]} */ (await pictures(page, 3));
  await sleep(400);
  const later = /** @type {string[]} */ (await pictures(page, 3));
  for (const [i, picture] of first.entries()) assert.notEqual(picture, later[i], `card ${i + 1} plays`);
  const untouched = await page.call('cards out of sight', () => [...document.querySelectorAll('#open-gallery canvas')].filter((canvas) => !canvas.hasAttribute('width')).length);
  assert.ok(untouched > MOTIONS / 3, `only what is in sight runs: ${untouched} never did`);
  assert.equal(await page.call('name', () => document.activeElement?.textContent), 'Acrobat out for a walkAcrobat, 7.1 m');
  // One stop of the Tab key, arrows within.
  await page.press('ArrowRight');
  await page.press('End');
  await page.press('Home');
  await page.press('ArrowDown');
  const title = await page.call('title', () => document.activeElement?.querySelector('strong')?.textContent ?? '');
  assert.ok(title);
  await page.press('Enter');
  assert.equal(await shown(page), false);
  assert.equal(await page.call('document', () => window.gaitsmith.document().title), title);
  assert.notEqual(await page.hash(), before);
  assert.equal(await page.status(), `Opened ${title}. Undo restores the previous version.`);
  assert.equal(await page.call('focus', () => document.activeElement?.id), 'open');
  await page.clickElement('#undo');
  assert.equal(await page.hash(), before);
  // By mouse, and again: the pictures start anew.
  await page.clickElement('#open');
  await page.until('a card', () => document.activeElement?.closest('#open-gallery') !== null);
  await page.clickElement('#open-gallery li:nth-child(2) button');
  assert.equal(await page.call('document', () => window.gaitsmith.document().title), 'A walk without a body');
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function refuses({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  const before = await page.hash();
  const link = await page.link();
  await opened(page);
  await page.page.focus('#open-text');
  await page.page.keyboard.type('https://example.org/#AZ4nonsense');
  await page.press('Enter');
  await page.until('a sentence', () => document.querySelector('#open-error')?.textContent !== '');
  assert.equal(await shown(page), true);
  const input = /** @type {import('../../../web/node_modules/puppeteer-core/lib/types.d.ts').ElementHandle<HTMLInputElement>} */ (await page.page.$('#file'));
  await input.uploadFile(join(ROOT, 'web/icon-180.png'));
  await page.until('another one', () => document.querySelector('#open-error')?.textContent?.includes('not a Gaitsmith document') ?? false);
  assert.equal(await page.hash(), before);
  await input.uploadFile(join(ROOT, 'examples/gallery/frog-hop.json'));
  await page.until('the frog', () => window.gaitsmith.document().title === 'Frog hops');
  assert.equal(await shown(page), false);
  // Opened again before the event of its closing has come.
  await opened(page);
  await page.call('closes and opens', () => {
    document.querySelector('#open-dialog')?.querySelector('form')?.requestSubmit();
    document.querySelector('#open')?.dispatchEvent(new MouseEvent('click'));
  });
  await page.frames(10);
  // A link that is pasted anywhere in the dialog opens.
  await page.until('the keyboard is in the dialog', () => (document.activeElement?.closest('dialog') ?? null) !== null);
  await page.page.evaluate((text) => {
    const paste = new ClipboardEvent('paste', { bubbles: true, cancelable: true });
    // Firefox keeps what a person pastes, but drops what a constructor is given.
    Object.defineProperty(paste, 'clipboardData', { value: { getData: () => text } });
    document.activeElement?.dispatchEvent(paste);
  }, link);
  await page.until('the link', `window.gaitsmith.hash() === ${JSON.stringify(before)}`);
  await opened(page);
  await page.press('Escape');
  assert.equal(await shown(page), false);
  assert.equal(await page.hash(), before);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function fits({ browser, address }) {
  for (const [width, height] of [[1280, 720], [390, 844], [844, 390], [320, 480]]) {
    const page = await PageDriver.open(browser, address);
    await page.page.setViewport({ width, height, deviceScaleFactor: 1 });
    await opened(page);
    const { outside, low, across } = await page.call('sizes', () => {
      const box = (/** @type {Element} */ node) => node.getBoundingClientRect();
      const dialog = document.querySelector('#open-dialog');
      const list = document.querySelector('#open-gallery');
      if (!dialog || !list) throw new Error('no dialog');
      const parts = [dialog, list, ...dialog.querySelectorAll('#open-file, #open-go, #open-text, [value=cancel]')];
      return {
        outside: parts.filter((node) => box(node).left < 0 || box(node).top < 0 || box(node).right > innerWidth || box(node).bottom > innerHeight).map(({ id }) => id),
        low: [...list.querySelectorAll('button')].filter((node) => box(node).height < 44).length,
        across: list.scrollWidth - list.clientWidth,
      };
    });
    assert.deepEqual({ outside, low, across }, { outside: [], low: 0, across: 0 }, `${width} by ${height}`);
    assert.deepEqual(page.complaints, []);
    await page.close();
  }
}

/** @param {Visit} visit */
async function calm({ browser, address }) {
  const page = await PageDriver.open(browser, address, { before: () => {
    const { matchMedia } = window;
    window.matchMedia = (query) => (query.includes('prefers-reduced-motion')
      ? /** @type {MediaQueryList} */ (Object.assign(new EventTarget(), { matches: true, media: query, onchange: null })) : matchMedia.call(window, query));
  } });
  await opened(page);
  await page.frames(20);
  const first = await pictures(page, 4);
  await sleep(400);
  assert.deepEqual(await pictures(page, 4), first, 'nothing moves');
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @type {[string, (visit: Visit) => Promise<void>][]} */
export const GALLERY_SCENARIOS = [
  ['Open shows the gallery alive: what is in sight plays, and a press opens it', plays],
  ['Open refuses a wrong link and a wrong file with a sentence, and changes nothing', refuses],
  ['Open fits into every window', fits],
  ['Open shows poses side by side where little should move', calm],
];
