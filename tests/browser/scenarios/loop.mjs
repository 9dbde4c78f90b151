// SPDX-License-Identifier: MIT
// The whole loop - a figure, senses, a search, watching, editing, a push, and back - without pointing: by roles and
// names, and only with the keyboard. Each scenario opens its own page.
import assert from 'node:assert/strict';
import { activate, active, byRole, reached, scrubbed, setValue, settle } from '../assistive.mjs';
import { PageDriver } from '../page_driver.mjs';

/** @typedef {import('./all.mjs').Visit} Visit */

/** The parts of the document that the scenarios check. @param {PageDriver} page */
const documentOf = (page) => page.call('document', () => {
  const { figure, senses, search, pushes = [], timeline = [] } = /** @type {any} */ (window.gaitsmith.document());
  return { figure: figure.name, senses: senses?.kind, seed: search?.seed, evaluations: search?.evaluations, pushes: pushes.length, clips: timeline.length };
});

/** @param {PageDriver} page */
const searchDone = (page) => page.until('the end of the search', () => /^Search done/.test(document.querySelector('#status')?.textContent ?? ''));

/** @param {Visit} visit */
async function loopByRoles({ browser, address }) {
  const page = await PageDriver.open(browser, address, { plays: true });
  await activate(page, 'tab', 'Figure');
  const all = (await page.widgets()).find(({ id }) => id === 'figure/gallery');
  await activate(page, 'button', all?.label ?? '');
  await activate(page, 'radio', 'Beryl Biped');
  assert.equal((await documentOf(page)).figure, 'Beryl Biped');
  await activate(page, 'tab', 'Controller');
  await activate(page, 'radio', 'Timer');
  assert.equal((await documentOf(page)).senses, 'timer');
  await activate(page, 'tab', 'Search');
  await setValue(page, 'slider', 'Budget', '4000');
  await setValue(page, 'spinbutton', 'Seed', '11');
  const set = await documentOf(page);
  assert.deepEqual([set.seed, set.evaluations], [11, 4000]);
  await activate(page, 'button', 'Synthesize');
  await searchDone(page);
  assert.equal((await documentOf(page)).clips, 1);

  await activate(page, 'button', 'Pause');
  await setValue(page, 'slider', 'Time', '1.5');
  assert.ok(Math.abs(await scrubbed(page) - 1.5) < 0.011);
  await activate(page, 'tab', 'Controller');
  await activate(page, 'button', 'Rule 1');
  const before = await page.hash();
  const slider = (await page.widgets()).find(({ id }) => id === 'rule-edit/tau');
  await setValue(page, 'slider', 'Time constant τ', '0.45');
  assert.notEqual((await page.widgets()).find(({ id }) => id === 'rule-edit/tau')?.value ?? slider?.value, slider?.value);
  assert.notEqual(await page.hash(), before);
  const edited = await page.hash();

  await activate(page, 'button', 'World: push, slope, friction, gravity, ghost');
  await activate(page, 'combobox', 'Where');
  await activate(page, 'option', 'Endpoint 2');
  assert.equal((await page.widgets()).find(({ id }) => id === 'world/endpoint')?.value, 'Endpoint 2');
  await setValue(page, 'slider', 'Strength', '12');
  await activate(page, 'button', 'Push now');
  assert.equal((await documentOf(page)).pushes, 1);
  await activate(page, 'button', 'Undo');
  assert.equal((await documentOf(page)).pushes, 0);
  assert.equal(await page.hash(), edited);
  await activate(page, 'button', 'Redo');
  assert.equal((await documentOf(page)).pushes, 1);

  await activate(page, 'tab', 'Style');
  const poses = async () => (await page.widgets()).find(({ id }) => id === 'view/poses')?.state.checked;
  await activate(page, 'switch', 'Past poses');
  const off = await poses();
  await activate(page, 'switch', 'Past poses');
  assert.notEqual(await poses(), off ?? (await poses()));
  // A disabled button does nothing.
  const remove = await byRole(page, 'button', 'Remove the selected clip');
  await remove.evaluate((node) => /** @type {HTMLElement} */ (node).click());
  await settle(page);
  assert.equal((await documentOf(page)).clips, 1);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** Presses Tab until a widget has the focus. @param {PageDriver} page @param {string} id @param {string} [key] */
async function tabTo(page, id, key = 'Tab') {
  for (let i = 0; i < 60; i++) {
    if (await active(page) === id) return settle(page);
    await page.press(key);
  }
  assert.fail(`${key} does not come to ${id}`);
}

/** @param {Visit} visit */
async function loopByKeyboard({ browser, address }) {
  const page = await PageDriver.open(browser, address, { plays: true });
  const value = async (/** @type {string} */ id) => (await page.widgets()).find((widget) => widget.id === id)?.value ?? '';
  await page.page.focus('#copy-link');
  await tabTo(page, 'panels/3');
  await page.press('ArrowLeft', 3);
  await reached(page, 'panels/0');
  await page.press('Enter');
  await settle(page);
  await page.press('Tab');
  // The figures are one stop. Arrows move between them, and only the space bar chooses one.
  const figure = (await documentOf(page)).figure;
  await page.press('ArrowRight');
  assert.equal((await documentOf(page)).figure, figure);
  await page.press(' ');
  await settle(page);
  assert.notEqual((await documentOf(page)).figure, figure);
  await page.press('2');
  await settle(page);
  await reached(page, 'panels/1', 'when another panel comes by key, its tab has the keyboard');
  await page.press('Tab');
  await page.press('ArrowLeft');
  await page.press(' ');
  await settle(page);
  assert.equal((await documentOf(page)).senses, 'timer');
  await page.press('4');
  await settle(page);
  await tabTo(page, 'search/budget');
  await page.press('ArrowLeft', 2);
  const fewer = (await documentOf(page)).evaluations;
  await page.press('Home');
  await settle(page);
  assert.equal((await documentOf(page)).evaluations, 1000);
  assert.ok(fewer > 1000);
  await page.press('PageUp');
  await page.press('PageUp');
  await tabTo(page, 'search/seed');
  await page.page.keyboard.type('23');
  await page.press('Enter');
  await settle(page);
  assert.equal((await documentOf(page)).seed, 23);
  await page.press('ArrowUp');
  await settle(page);
  assert.equal((await documentOf(page)).seed, 24);
  await page.page.keyboard.type('5');
  await page.press('Escape');
  await settle(page);
  assert.equal((await documentOf(page)).seed, 24);
  await tabTo(page, 'search/start', 'Shift+Tab');
  await page.press('Enter');
  await searchDone(page);
  await settle(page);
  const successor = await active(page);
  assert.match(successor, /^search\//, `the keyboard is lost to ${successor} when a button goes`);

  await tabTo(page, 'transport/scrub', 'Shift+Tab');
  await page.press(' '); // plays or pauses
  await page.press('Home');
  await page.press('ArrowRight', 12);
  await settle(page);
  assert.ok(Math.abs(await scrubbed(page) - 0.12) < 0.011, `${await scrubbed(page)}`);

  await page.press('2');
  await tabTo(page, 'controller/rule/1');
  await page.press('Enter');
  await settle(page);
  const before = await page.hash();
  await tabTo(page, 'rule-edit/tau');
  const tau = await value('rule-edit/tau');
  assert.ok(tau, 'what has the keyboard is scrolled into sight');
  await page.press('ArrowRight', 5);
  await settle(page);
  assert.notEqual(await value('rule-edit/tau'), tau);
  const edited = await page.hash();

  await tabTo(page, 'world/open', 'Shift+Tab');
  await page.press('Enter');
  await settle(page);
  await tabTo(page, 'world/endpoint');
  await page.press('Enter');
  await settle(page);
  await reached(page, /^world\/endpoint\//, 'an open list has the keyboard');
  await page.press('ArrowDown');
  await page.press('Enter');
  await settle(page);
  assert.equal(await value('world/endpoint'), 'Endpoint 1');
  await reached(page, 'world/endpoint');
  await page.press('Enter');
  await reached(page, /^world\/endpoint\//, 'the list is open again');
  await page.press('Escape');
  await settle(page);
  await reached(page, 'world/endpoint');
  assert.equal(await value('world/endpoint'), 'Endpoint 1');
  await tabTo(page, 'world/strength');
  await page.press('End');
  await tabTo(page, 'world/push');
  await page.press(' ');
  await settle(page);
  assert.equal((await documentOf(page)).pushes, 1);
  await page.press('Control+z');
  assert.equal((await documentOf(page)).pushes, 0);
  assert.equal(await page.hash(), edited);
  assert.notEqual(edited, before);
  await page.press('Control+Shift+z');
  assert.equal((await documentOf(page)).pushes, 1);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @type {[string, (visit: Visit) => Promise<void>][]} */
export const LOOP_SCENARIOS = [
  ['the whole loop through the mirror, by roles and names', loopByRoles],
  ['the whole loop by keyboard alone', loopByKeyboard],
];
