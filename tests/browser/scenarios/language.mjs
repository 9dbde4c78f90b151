// SPDX-License-Identifier: MIT
// The language of the page: the default, choosing another one, and that no text stays in English.
import assert from 'node:assert/strict';
import { mkdir } from 'node:fs/promises';
import { join } from 'node:path';
import { ROOT } from '../browsers.mjs';
import { ONE_BROWSER, PageDriver } from '../page_driver.mjs';
import { DATA, speakPseudo, untranslated, wordsOn } from '../pseudo_language.mjs';
import { stateOf } from './history.mjs';

/** @typedef {import('./all.mjs').Visit} Visit */

/** @param {PageDriver} page */
const shownLanguage = (page) => page.call('language', () => {
  const list = document.querySelector('#language');
  return { code: document.documentElement.lang, chosen: list instanceof HTMLSelectElement ? list.value : '',
    save: document.querySelector('#save')?.textContent, menu: document.querySelector('#more')?.textContent,
    theme: document.querySelector('#theme')?.getAttribute('aria-label') };
});
const ENGLISH = { code: 'en', chosen: 'en', save: 'Save', menu: 'Menu', theme: 'Theme' };
const GERMAN = { code: 'de', chosen: 'de', save: 'Speichern', menu: 'Menü', theme: 'Darstellung' };

/** Runs in the page before its scripts: makes the browser prefer German. */
function germanBrowser() {
  Object.defineProperty(navigator, 'languages', { get: () => ['de-DE', 'de', 'en'] });
}

/** @param {PageDriver} page @param {string} code @param {object} expected */
async function chooseInHeader(page, code, expected) {
  await page.page.select('#language', code);
  await page.until(code, `document.documentElement.lang === '${code}'`);
  await page.frames(4);
  assert.deepEqual(await shownLanguage(page), expected);
}

/** @param {Visit} visit */
async function asTheBrowser({ browser, address }) {
  const page = await PageDriver.open(browser, address, { before: germanBrowser, newcomer: true });
  assert.deepEqual(await shownLanguage(page), GERMAN);
  const headline = () => document.querySelector('#mirror')?.textContent ?? '';
  assert.match(await page.call('headline', headline), /Dieser Strauß kann sich noch nicht bewegen\./);
  await page.call('start', () => window.gaitsmith.run('help/tour'));
  await page.until('the tour', () => document.querySelector('#tour:not([hidden])') !== null);
  assert.deepEqual([await page.text('#tour-title'), await page.text('#tour-next')], ['Das hat niemand animiert', 'Weiter']);
  // An open dialog changes, too.
  await chooseInHeader(page, 'en', ENGLISH);
  assert.deepEqual([await page.text('#tour-title'), await page.text('#tour-next')], ['Nobody animated this', 'Next']);
  await page.reload();
  assert.deepEqual(await shownLanguage(page), ENGLISH, 'what is chosen is remembered');
  assert.deepEqual(page.complaints, []);
  await page.close();

  const guest = await PageDriver.open(browser, address);
  assert.deepEqual(await shownLanguage(guest), ENGLISH);
  const tables = await guest.call('tables', () => performance.getEntriesByType('resource').filter(({ name }) => /\/languages\/\w+\.json$/.test(name)).length);
  assert.equal(tables, 0, 'no English visitor loads another language');
  await guest.close();
  const asked = await PageDriver.open(browser, `${address}?lang=de`);
  assert.deepEqual(await shownLanguage(asked), GERMAN);
  assert.deepEqual([...guest.complaints, ...asked.complaints], []);
  await asked.close();
}

/** @param {Visit} visit */
async function chosen({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  await page.call('work', () => {
    for (const friction of [0.3, 0.6]) window.gaitsmith.open({ ...window.gaitsmith.document(), hash: undefined, environment: { friction } });
  });
  const before = await stateOf(page);
  const steps = () => page.call('steps', () => [window.gaitsmith.canUndo(), window.gaitsmith.canRedo()]);
  assert.deepEqual(await steps(), [true, false]);
  assert.ok(await page.call('within reach', () => {
    const { left, top, width, height } = document.querySelector('#language')?.getBoundingClientRect() ?? new DOMRect();
    return document.elementFromPoint(left + width / 2, top + height / 2)?.id === 'language';
  }), 'the pointer does not get to the list');
  await chooseInHeader(page, 'de', GERMAN);
  assert.equal(await page.status(), 'Sprache: Deutsch');
  assert.match(await page.call('title', () => document.querySelector('#undo')?.getAttribute('title') ?? ''), /^Rückgängig \(/);
  for (const [words, expected] of /** @type {const} */ ([['sprache eng', ENGLISH], ['language deu', GERMAN]])) {
    await page.page.focus('canvas');
    await page.openPalette();
    await page.page.keyboard.type(words);
    await page.press('Enter');
    await page.until('the other language', `document.documentElement.lang === '${expected.code}'`);
    assert.deepEqual(await shownLanguage(page), expected);
    assert.equal(await page.call('focus', () => document.activeElement?.id), 'canvas');
  }
  assert.equal(await stateOf(page), before);
  assert.deepEqual(await steps(), [true, false]);
  await page.clickElement('#undo');
  await page.frames();
  assert.notEqual(await stateOf(page), before);
  await page.clickElement('#redo');
  await page.frames();
  assert.equal(await stateOf(page), before);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function unreachable({ browser, address }) {
  const page = await PageDriver.open(browser, `${address}?lang=de`, { before: () => {
    const originalFetch = window.fetch;
    window.fetch = (...request) => (String(request[0]).includes('/languages/') ? Promise.reject(new TypeError('no line')) : originalFetch(...request));
  } });
  assert.deepEqual(await shownLanguage(page), ENGLISH);
  assert.equal(await page.status(), 'Deutsch could not be loaded. The page stays in English.');
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function nothingLeft({ browser, address, figures }) {
  const page = await PageDriver.open(browser, address, { before: speakPseudo });
  const run = (/** @type {string} */ id) => page.page.evaluate((name) => window.gaitsmith.run(name), id);
  const leftOf = await untranslated();
  /** Untranslated texts, and where each was first seen. @type {Map<string, string>} */
  const left = new Map();
  let read = 0;
  const checkPage = async (/** @type {string} */ what) => {
    await page.frames(6);
    await page.call('mirror', () => new Promise((resolve) => { setTimeout(() => resolve(true), 350); }));
    for (const [where, text] of await wordsOn(page)) {
      read++;
      const rest = leftOf(text);
      if (rest && !left.has(text) && !DATA.some((place) => where.split(' ').includes(place))) left.set(text, `${what}, ${where}: ${text.trim()}`);
    }
  };
  // One English announcement is shown and the next one waits. Neither may stay.
  for (const shown of [true, false]) {
    await page.page.evaluate(() => document.getElementById('describe')?.click());
    if (shown) await page.until('the announcement', () => document.querySelector('#spoken span') !== null);
  }
  await page.page.select('#language', 'de');
  await page.until('the language', () => document.documentElement.lang === 'de');
  assert.equal(await page.text('#save'), '«Save»');
  await wordsOn(page); // discards earlier messages
  await page.page.evaluate(() => {
    Object.defineProperty(navigator, 'clipboard', { value: { writeText: () => Promise.reject(new Error('not here')) } });
  });

  for (const panel of ['Figure', 'Controller', 'Style', 'Search', 'Lab']) {
    await run(`panel/${panel}`);
    if (panel === 'Controller') await page.click('controller/rule/1');
    await checkPage(`the ${panel} panel`);
    if (panel === 'Search') {
      await page.click('search/algorithm');
      await checkPage('the algorithms');
      await page.press('Escape');
    }
  }
  await run('view/world');
  await page.click('world/open');
  await checkPage('the World card');
  await page.click('world/open');

  for (const [key, what] of [['Control+k', 'the palette'], ['F1', 'the sheet of keys'], ['Control+o', 'the dialog that opens']]) {
    await page.page.focus('canvas');
    await page.press(key);
    await page.until(what, () => document.querySelector('dialog[open]') !== null);
    if (key === 'Control+o') await page.clickElement('#open-go'); // with nothing to open
    await checkPage(what);
    if (key === 'Control+k') {
      await page.page.keyboard.type('!!!');
      await checkPage('the empty palette');
    }
    await page.press('Escape');
  }
  await run('motion/breed');
  await page.until('nine motions', () => [...document.querySelectorAll('#breed-tiles .tile')].filter((tile) => /** @type {HTMLElement} */ (tile).title).length === 9);
  await page.press('2');
  await page.press('n');
  await page.until('their children', () => document.querySelectorAll('#breed-rounds canvas.picked').length === 1);
  await page.clickElement('#breed-tiles li:nth-child(1) .more');
  await checkPage('breeding');
  await page.press('Escape');
  await page.press('Escape');
  await page.clickElement('#copy-link');
  await checkPage('the link to copy');
  await page.press('Escape');
  await page.page.evaluate(() => { location.hash = '#AZ4'; });
  await checkPage('a damaged link');
  await page.clickElement('#banner-close');
  await run('motion/end');
  await checkPage('the end, paused');

  await page.page.evaluate(() => void window.gaitsmith.synthesize({ evaluations: 60000, seed: 5 }).catch(() => {}));
  await page.until('a rate', () => Boolean(document.querySelector('#rate')?.textContent));
  await checkPage('a search');
  await page.page.evaluate(() => window.gaitsmith.pause());
  await checkPage('a search, paused');
  await page.page.evaluate(() => { window.gaitsmith.enqueue({ seed: 77 }); });
  await checkPage('the queue');
  await page.page.evaluate(() => window.gaitsmith.stop());
  await checkPage('a search, stopped');
  await page.page.evaluate(() => void window.gaitsmith.lab({ algorithms: ['rgt', 'sphc'], trials: 2, evaluations: 400 }).catch(() => {}));
  await run('panel/Lab');
  await checkPage('the lab');
  await page.page.evaluate(() => window.gaitsmith.stop());

  await run('help/tour');
  for (let step = 1; step <= 6; step++) {
    await page.until('the card', () => document.querySelector('#tour:not([hidden])') !== null);
    await checkPage(`step ${step} of the tour`);
    await page.press('Enter');
  }
  if (/chrome/i.test(await browser.version())) {
    await page.page.setViewport({ width: 390, height: 844, deviceScaleFactor: 1 });
    await page.frames(4);
    await run('panel/Timeline');
    await checkPage('the timeline of a phone');
  }
  figures['texts read in another language'] = read;
  assert.ok(left.size === 0, [...left.values()].join('\n'));
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function longerWords(visit) {
  for (const code of ['de', 'es']) await headerFits(visit, code);
}

/** @param {Visit} visit @param {string} code */
async function headerFits({ browser, address }, code) {
  const page = await PageDriver.open(browser, `${address}?lang=${code}`);
  await page.until('the language', `document.documentElement.lang === '${code}' && document.querySelector('#learn')?.getAttribute('href') === 'book/${code}/index.html'`);
  await mkdir(join(ROOT, 'build/screenshots'), { recursive: true });
  for (const [name, width, height, theme = 'light'] of /** @type {[string, number, number, string?][]} */ ([['desk', 1280, 720],
    ['room', 1024, 768, 'projector'], ['narrow room', 900, 700, 'projector'], ['window', 900, 700], ['narrow window', 720, 700], ['phone', 390, 844]])) {
    await page.page.setViewport({ width, height, deviceScaleFactor: 1 });
    await page.page.select('#theme', theme);
    await page.frames(6);
    if (width < 900) await page.clickElement('#more');
    const faults = await page.call('header', () => {
      // Only the document's title may be shortened.
      const all = [...document.querySelectorAll('header :is(button, a, select)')].filter((node) => node.getClientRects().length > 0);
      const box = (/** @type {Element} */ node) => node.getBoundingClientRect();
      const apart = (/** @type {DOMRect} */ a, /** @type {DOMRect} */ b) =>
        a.right <= b.left + 0.5 || b.right <= a.left + 0.5 || a.bottom <= b.top + 0.5 || b.bottom <= a.top + 0.5;
      return all.flatMap((node, index) => [
        ...(node.scrollWidth > node.clientWidth ? [`${node.id} is cut off`] : []),
        ...(box(node).left < 0 || box(node).right > innerWidth ? [`${node.id} leaves the window`] : []),
        ...all.slice(index + 1).filter((other) => !apart(box(node), box(other))).map((other) => `${node.id} lies on ${other.id}`),
      ]);
    });
    assert.deepEqual(faults, [], `${code}, ${width} by ${height}`);
    await page.page.screenshot({ path: /** @type {`${string}.png`} */ (join(ROOT, `build/screenshots/${code}-${name.replace(' ', '-')}.png`)) });
  }
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @type {[string, (visit: Visit) => Promise<void>, string?][]} */
export const LANGUAGE_SCENARIOS = [
  ['whose browser speaks German reads German, until another language is chosen', asTheBrowser],
  ['a language is chosen in the header and by the palette, and the work stays as it was', chosen],
  ['a language that cannot be loaded leaves the page in English, and it says so', unreachable],
  ['in another language nothing is left in English', nothingLeft, ONE_BROWSER],
  ['in German and in Spanish nothing of the header is cut off', longerWords, 'Chromium'], // Firefox's window cannot be this small
];
