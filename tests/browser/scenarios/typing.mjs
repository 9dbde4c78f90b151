// SPDX-License-Identifier: MIT
// Typing the numbers of sliders, after a click or Enter. Numbers out of range become the nearest valid one. Invalid or
// cancelled input changes nothing.
import assert from 'node:assert/strict';
import { setValue, settle } from '../assistive.mjs';
import { PageDriver } from '../page_driver.mjs';

/** @typedef {import('./all.mjs').Visit} Visit */

const SLIDER = 'style/duration';

/** @param {PageDriver} page */
const shown = async (page) => {
  const widget = (await page.widgets()).find(({ id }) => id === SLIDER);
  const seconds = await page.call('duration', () => /** @type {any} */ (window.gaitsmith.document()).task.duration_steps / 100);
  return { role: widget?.role, value: Number.parseFloat(widget?.value ?? ''), seconds };
};

/** Waits for the role, because Dear ImGui handles one key per frame. @param {PageDriver} page @param {string} role */
async function becomes(page, role) {
  for (let wait = 0; wait < 60 && (await shown(page)).role !== role; wait++) await page.frames();
  assert.equal((await shown(page)).role, role);
}

/** Opens the field with a click on the number. @param {PageDriver} page */
async function open(page) {
  const { rect } = (await page.widgets()).find(({ id }) => id === SLIDER) ?? assert.fail(`no ${SLIDER}`);
  await page.clickAt(rect.x + rect.width - 12, rect.y + 8);
  await becomes(page, 'textbox');
}

/** @param {PageDriver} page @param {string} text @param {string} end  a key */
async function type(page, text, end) {
  await page.page.keyboard.type(text, { delay: 40 });
  await page.frames();
  await page.press(end);
  await becomes(page, 'slider');
}

/** @param {Visit} visit */
async function typed({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  await page.click('panels/2');
  const before = await shown(page);
  assert.equal(before.role, 'slider');
  for (const [text, seconds] of /** @type {[string, number][]} */ ([['7.5', 7.5], ['12,0', 12], ['99999', 30], ['0.2', 1], ['-', 1], ['6', 6]])) {
    await open(page);
    await type(page, text, 'Enter');
    assert.deepEqual(await shown(page), { role: 'slider', value: seconds, seconds }, `after ${text}`);
  }
  await open(page);
  await type(page, '9', 'Escape');
  assert.deepEqual(await shown(page), { role: 'slider', value: 6, seconds: 6 }, 'after Escape');

  // Only with keys: Enter opens the field, and afterwards an arrow steps the slider.
  await setValue(page, 'slider', 'Duration', '6.5');
  await page.page.focus('#on-canvas-style-duration');
  await page.press('Enter');
  const field = await page.call('field', () => {
    const node = /** @type {HTMLInputElement} */ (document.activeElement);
    return { type: node.type, role: node.getAttribute('role'), value: node.value, label: node.getAttribute('aria-label') };
  });
  assert.deepEqual(field, { type: 'text', role: 'spinbutton', value: '6.5', label: 'Duration' });
  await type(page, '7', 'Escape');
  assert.equal((await shown(page)).seconds, 6.5);
  // Leaving the field without a change restores the slider.
  await page.press('Enter');
  await page.press('Tab');
  await settle(page);
  assert.equal(await page.call('left', () => /** @type {HTMLInputElement} */ (document.querySelector('#on-canvas-style-duration')).type), 'range');
  assert.equal((await shown(page)).seconds, 6.5);
  await page.page.focus('#on-canvas-style-duration');
  await page.press('Enter');
  await type(page, '8', 'Enter');
  await settle(page);
  assert.deepEqual(await shown(page), { role: 'slider', value: 8, seconds: 8 }, 'by Enter');
  await page.press('ArrowRight');
  await settle(page);
  assert.equal((await shown(page)).seconds, 8.5);
  for (let step = 0; step < 12 && (await shown(page)).seconds !== before.seconds; step++) await page.press('Control+z');
  assert.deepEqual(await shown(page), before);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {PageDriver} page */
const seed = (page) => page.call('seed', () => /** @type {any} */ (window.gaitsmith.document()).search.seed);

/** @param {PageDriver} page @param {number} wanted @param {string} how */
async function assertSearches(page, wanted, how) {
  await page.until(`a search ${how}`, () => window.gaitsmith.widgets().some(({ id }) => id === 'search/stop'));
  assert.equal(await seed(page), wanted, how);
  await page.call('stop', () => window.gaitsmith.stop());
  await page.until('its end', () => window.gaitsmith.widgets().some(({ id }) => id === 'search/start'));
}

/** @param {Visit} visit */
async function pressedWhileTyping({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  // High enough for the seed and Synthesize at once: the focus scrolls to what it is on.
  await page.page.setViewport({ width: 1280, height: 1000 });
  await page.call('a long search', () => {
    const document = window.gaitsmith.document();
    window.gaitsmith.open({ ...document, hash: undefined, search: { ...document.search, evaluations: 1000000 }, view: { panel: 3 } });
  });
  await page.frames(6);
  // A field that is open on the canvas. Synthesize is above it, so it is drawn first.
  await page.click('search/seed');
  await page.page.keyboard.type('77', { delay: 40 });
  await page.frames(4);
  await page.click('search/start');
  await assertSearches(page, 77, 'by mouse, a field on the canvas');
  // A field of the page.
  await page.page.focus('#on-canvas-search-seed');
  await page.page.keyboard.type('78', { delay: 40 });
  await page.click('search/start');
  await assertSearches(page, 78, 'by mouse, a field of the page');
  // By an assistive tool, which may leave the focus where it is.
  await page.page.focus('#on-canvas-search-seed');
  await page.page.keyboard.type('79', { delay: 40 });
  await page.page.evaluate(() => /** @type {HTMLElement} */ (document.querySelector('#on-canvas-search-start')).click());
  await assertSearches(page, 79, 'without the focus');
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function typesTheNewNumber({ browser, address }) {
  const page = await PageDriver.open(browser, address, {
    before: () => { // the mirror follows actions only
      const plain = window.setInterval;
      Object.assign(window, { setInterval: (/** @type {() => void} */ body, /** @type {number} */ ms) => plain(() => { if (ms !== 250 || !(/** @type {any} */ (window).testStill)) body(); }, ms) });
    },
  });
  await page.click('panels/2');
  await settle(page);
  await page.page.focus('#on-canvas-style-duration');
  await settle(page);
  await page.call('another duration', () => {
    Object.assign(window, { testStill: true });
    const document = window.gaitsmith.document();
    window.gaitsmith.open({ ...document, hash: undefined, task: { ...document.task, duration_steps: 730 }, view: { panel: 2 } });
  });
  await page.until('the slider', () => /^7\.3/.test(window.gaitsmith.widgets().find(({ id }) => id === 'style/duration')?.value ?? ''));
  await page.press('Enter');
  assert.equal(await page.call('field', () => /** @type {HTMLInputElement} */ (document.querySelector('#on-canvas-style-duration')).value), '7.3');
  await page.close();
}

/** @type {[string, (visit: Visit) => Promise<void>][]} */
export const TYPING_SCENARIOS = [
  ['a press on a button while a number is typed takes the number and presses the button', pressedWhileTyping],
  ['typing begins with the number of now', typesTheNewNumber],
  ['numbers beside sliders are typed', typed],
];
