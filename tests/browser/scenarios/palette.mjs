// SPDX-License-Identifier: MIT
// Keys, the list of keys, the palette, and the header on narrow screens. Each scenario opens its own pages.
import assert from 'node:assert/strict';
import { Mouse } from '../pointers.mjs';
import { PageDriver } from '../page_driver.mjs';

/** @typedef {import('./all.mjs').Visit} Visit */

/** The palette as assistive tools see it. @param {PageDriver} page */
const palette = (page) => page.call('palette', () => {
  const input = document.activeElement;
  const list = document.getElementById(input?.getAttribute('aria-controls') ?? '');
  const options = [...list?.querySelectorAll('[role=option]') ?? []];
  const chosen = document.getElementById(input?.getAttribute('aria-activedescendant') ?? '');
  return {
    open: document.querySelector('dialog')?.open ?? false,
    role: input?.getAttribute('role'),
    listRole: list?.getAttribute('role'),
    titles: options.map((option) => option.querySelector('span')?.textContent ?? ''),
    off: options.filter((option) => option.getAttribute('aria-disabled') === 'true').map((option) => option.querySelector('span')?.textContent),
    selected: options.findIndex((option) => option.getAttribute('aria-selected') === 'true'),
    chosen: options.indexOf(/** @type {Element} */ (chosen)),
    seen: chosen ? list !== null && chosen.getBoundingClientRect().bottom <= list.getBoundingClientRect().bottom + 1 : false,
    count: document.querySelector('#palette-count')?.textContent ?? '',
  };
});

/** @param {PageDriver} page */
const paletteIsOpen = (page) => page.call('open', () => document.querySelector('#palette')?.hasAttribute('open') ?? false);

/** @param {Visit} visit */
async function byKeyboard({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  await page.page.focus('canvas');
  await page.until('the examples', () => window.gaitsmith.commands().some(({ id }) => id === 'example/there-and-back'));
  await page.openPalette();
  const all = await palette(page);
  assert.deepEqual([all.role, all.listRole, all.selected, all.chosen], ['combobox', 'listbox', 0, 0]);
  assert.equal(all.count, `${all.titles.length} commands`);
  for (const title of ['New', 'Undo', 'Save as a file', 'Play or pause', 'Lab panel', 'Open example: There and back', 'Choose task: Beryl Biped travels']) {
    assert.ok(all.titles.includes(title), `no command ${title}`);
  }
  assert.deepEqual(all.off, ['Pause or resume the search', 'Run the queue', 'Clear the queue',
    'Show the best result for this figure and task', 'Bring back the deleted result', 'Move the selected clip earlier', 'Move the selected clip later',
    'Track the planned motion by rules',
    'Repair the selected clip: search from where it takes over', 'Snap to best: move the switch to the nearest good moment', 'Remove the selected clip', 'Undo', 'Redo']);
  // Past the end and back. The selected row is always visible.
  await page.press('ArrowUp');
  const last = await palette(page);
  assert.deepEqual([last.selected, last.chosen, last.seen], [all.titles.length - 1, all.titles.length - 1, true]);
  await page.press('ArrowDown', 3);
  assert.equal((await palette(page)).chosen, 2);
  // An unavailable command does nothing.
  await page.page.keyboard.type('undo');
  assert.equal((await palette(page)).titles[0], 'Undo');
  await page.press('Enter');
  assert.ok(await paletteIsOpen(page));
  await page.press('Control+a');
  await page.page.keyboard.type('zzz');
  const none = await palette(page);
  assert.deepEqual([none.titles.length, none.chosen, none.count], [0, -1, '0 commands']);
  await page.press('Escape');
  assert.equal(await paletteIsOpen(page), false);
  assert.equal(await page.call('focus', () => document.activeElement?.id), 'canvas');

  await page.openPalette();
  await page.page.keyboard.type('task beryl');
  const found = await palette(page);
  assert.deepEqual(found.titles, ['Choose task: Beryl Biped travels']);
  await page.press('Enter');
  assert.equal(await paletteIsOpen(page), false);
  await page.frames();
  assert.equal(await page.call('title', () => window.gaitsmith.document().title), 'Beryl Biped travels');
  await page.openPalette();
  await page.page.keyboard.type('undo');
  await page.press('Enter');
  assert.equal(await page.call('title', () => window.gaitsmith.document().title), 'Mr. Star-Man shuffles');
  // A command that opens a dialog.
  await page.openPalette();
  await page.page.keyboard.type('open link');
  await page.press('Enter');
  await page.until('the dialog', () => document.querySelector('#open-dialog')?.hasAttribute('open') ?? false);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function keysWork({ browser, address }) {
  const page = await PageDriver.open(browser, address, { plays: true });
  const value = async (/** @type {string} */ id) => (await page.widgets()).find((widget) => widget.id === id);
  const playing = async () => (await value('transport/play'))?.label === 'Pause';
  const time = async () => Number.parseFloat((await value('transport/scrub'))?.value ?? '');
  const panel = async () => (await page.widgets()).find(({ id, state }) => id.startsWith('panels/') && state.selected)?.id;
  const theme = () => page.call('theme', () => document.documentElement.dataset.theme);
  for (const focus of ['canvas', '#home']) {
    await page.page.focus(focus);
    await page.press('Home');
    assert.ok(await playing());
    await page.press(' ');
    if (focus === 'canvas') assert.equal(await playing(), false);
    await page.press('End');
    const end = await time();
    await page.press(',', 3);
    assert.ok(Math.abs(end - 0.03 - await time()) < 0.0051, `${end} and three steps back is ${await time()}`);
    await page.press('.');
    assert.ok(Math.abs(end - 0.02 - await time()) < 0.0051);
    await page.press('3');
    assert.equal(await panel(), 'panels/2');
    await page.press('4');
    assert.equal(await panel(), 'panels/3');
    const before = await theme();
    await page.press('t');
    assert.notEqual(await theme(), before);
    await page.call('play', () => window.gaitsmith.widgets().some(({ label }) => label === 'Play'));
    if (!(await playing())) {
      await page.page.focus('canvas');
      await page.press(' ');
    }
  }
  // Space plays and pauses wherever the mouse last clicked, and presses nothing there.
  await page.page.evaluate(() => {
    Object.assign(window, { testPresses: 0 });
    document.querySelector('#undo')?.addEventListener('click', () => { /** @type {any} */ (window).testPresses++; });
  });
  for (const click of [() => new Mouse(page).press('panels/0'), () => page.page.click('#undo'), () => new Mouse(page).press('panels/3')]) {
    await click();
    const before = await playing();
    await page.press(' ');
    assert.equal(await playing(), !before);
  }
  assert.equal(await page.call('presses', () => /** @type {any} */ (window).testPresses), 1);
  await page.page.focus('canvas');
  await page.press('s');
  await page.until('a search', () => window.gaitsmith.widgets().some(({ id }) => id === 'search/stop'));
  await page.press('s');
  await page.until('its end', () => /^Search stopped/.test(document.querySelector('#status')?.textContent ?? ''));

  // Digits go to an open number field.
  await new Mouse(page).press('search/seed'); // below the curve now
  await page.page.keyboard.type('21');
  await page.press('Enter');
  await page.frames();
  assert.equal(await panel(), 'panels/3');
  assert.match((await value('search/seed'))?.value ?? '', /21/);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function sheet({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  const open = () => page.call('open', () => document.querySelector('#help')?.hasAttribute('open') ?? false);
  const opens = (/** @type {string} */ key) => page.until(`the sheet, by ${key}`, () => document.querySelector('#help')?.hasAttribute('open') ?? false);
  for (const key of ['?', 'F1']) {
    await page.page.focus('canvas');
    await page.press(key);
    await opens(key);
    await page.press('Escape');
    assert.equal(await open(), false);
  }
  await page.clickElement('#keys');
  await opens('the button');
  const caps = await page.call('caps', () => [...document.querySelectorAll('#help kbd')].map((cap) => cap.textContent ?? ''));
  assert.equal(new Set(caps).size, caps.length, `a key stands for two things: ${caps}`);
  for (const cap of ['Space', 'S', '1', '5', 'Home', '?', 'T']) assert.ok(caps.includes(cap), `no ${cap}`);
  // Single keys can be turned off, also for later visits.
  await page.clickElement('#help-single');
  await page.press('Escape');
  await page.page.focus('canvas');
  const panel = async () => (await page.widgets()).find(({ id, state }) => id.startsWith('panels/') && state.selected)?.id;
  const before = await panel();
  await page.press('1');
  assert.equal(await panel(), before);
  await page.press('F1');
  await opens('F1');
  await page.reload();
  await page.page.focus('canvas');
  await page.press('1');
  assert.equal(await panel(), before);
  await page.clickElement('#keys');
  await opens('the button');
  await page.clickElement('#help-single');
  await page.press('Escape');
  await page.page.focus('canvas');
  await page.press('1');
  assert.equal(await panel(), 'panels/0');
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function narrow({ browser, address, name }) {
  if (name === 'Firefox') return; // its window cannot be this small
  const page = await PageDriver.open(browser, address);
  for (const width of [390, 320]) {
    await page.page.setViewport({ width, height: 700, deviceScaleFactor: 2 });
    await page.frames();
    const outside = () => page.call('outside', () => [...document.querySelectorAll('header button, header a, dialog[open] *')]
      .filter((node) => node.getClientRects().length > 0)
      .filter((node) => node.getBoundingClientRect().right > innerWidth + 0.5 || node.getBoundingClientRect().left < -0.5)
      .map((node) => node.id || node.tagName));
    assert.deepEqual(await outside(), []);
    await page.clickElement('#more');
    assert.deepEqual(await outside(), []);
    await page.clickElement('#commands');
    await page.until('the palette', () => document.querySelector('#palette')?.hasAttribute('open') ?? false); // its parts come with the first use
    assert.deepEqual(await outside(), []);
    assert.ok(await page.call('tall', () => [...document.querySelectorAll('#palette-list li')].every((row) => row.getBoundingClientRect().height >= 44)));
    await page.clickElement('#palette form button');
    await page.clickElement('#more');
    await page.clickElement('#keys');
    await page.until('the sheet', () => document.querySelector('#help')?.hasAttribute('open') ?? false);
    assert.deepEqual(await outside(), []);
    await page.clickElement('#help button[type=submit]');
  }
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @type {[string, (visit: Visit) => Promise<void>][]} */
export const PALETTE_SCENARIOS = [
  ['the palette finds and runs commands by keyboard alone', byKeyboard],
  ['keys do what the sheet says, on the stage and beside it, and numbers can still be typed', keysWork],
  ['the sheet lists every key once, and single keys can be turned off', sheet],
  ['on narrow screens nothing in header, menu, palette or sheet is cut off', narrow],
];
