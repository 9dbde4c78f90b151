// SPDX-License-Identifier: MIT
// Undo, Redo, New, and files dropped on the page. Each scenario opens its own pages.
import assert from 'node:assert/strict';
import { ONE_BROWSER, PATIENCE_MS, PageDriver } from '../page_driver.mjs';

/** @typedef {import('./all.mjs').Visit} Visit */

/** The state that Undo must restore: the motion and the document without its view. @param {PageDriver} page @returns {Promise<string>} */
export function stateOf(page) {
  return page.call('state', () => JSON.stringify([window.gaitsmith.hash(), { ...window.gaitsmith.document(), view: null }]));
}

/** Shows where two states differ, because they are long. @param {string} now @param {string} before @param {string} what */
export function same(now, before, what) {
  if (now === before) return;
  const at = [...now].findIndex((letter, i) => letter !== before[i]);
  const around = (/** @type {string} */ text) => text.slice(Math.max(0, at - 60), at + 60);
  assert.fail(`${what}: another document, at letter ${at}: …${around(now)}… instead of …${around(before)}…`);
}

/** @param {PageDriver} page @param {string} id  of a button */
const buttonState = (page, id) => page.page.evaluate((selector) => {
  const button = /** @type {HTMLElement} */ (document.querySelector(selector));
  return { off: button.getAttribute('aria-disabled') === 'true', title: button.title };
}, id);

/** @param {Visit} visit */
async function threeEdits({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  const states = [await stateOf(page)];
  assert.deepEqual(await buttonState(page, '#undo'), { off: true, title: 'Nothing to undo.' });

  // A whole drag of a slider is one step.
  await page.click('panels/2');
  await page.frames(6);
  const slider = (await page.widgets()).find(({ id, role }) => role === 'slider' && id.startsWith('style/'))?.rect;
  assert.ok(slider, 'no slider');
  const y = slider.y + 0.8 * slider.height;
  await page.page.mouse.move(slider.x + 0.5 * slider.width, y);
  await page.frames();
  await page.page.mouse.down();
  for (const share of [0.55, 0.6, 0.65, 0.7]) {
    await page.page.mouse.move(slider.x + share * slider.width, y);
    await page.frames();
  }
  await page.page.mouse.up();
  await page.frames();
  states.push(await stateOf(page));
  // A click on a button is another step. Looking at other panels is not.
  await page.click('panels/3');
  await page.click('search/seed/more');
  states.push(await stateOf(page));
  await page.click('panels/1');
  // Opening a document is a step.
  await page.call('open', () => {
    const document = window.gaitsmith.document();
    window.gaitsmith.open({ ...document, hash: undefined, environment: { friction: 0.2 } });
  });
  states.push(await stateOf(page));
  assert.equal(new Set(states).size, 4, 'an edit changed nothing');

  // Undo with a key on the stage, with the button, and by script.
  await page.page.focus('canvas');
  await page.press('Control+z');
  assert.equal(await stateOf(page), states[2]);
  await page.clickElement('#undo');
  assert.equal(await stateOf(page), states[1]);
  assert.equal(await page.call('undo', () => window.gaitsmith.undo()), true);
  assert.equal(await stateOf(page), states[0]);
  assert.deepEqual(await buttonState(page, '#undo'), { off: true, title: 'Nothing to undo.' });
  assert.equal(await page.call('undo', () => window.gaitsmith.canUndo() || window.gaitsmith.undo()), false);
  assert.match(await page.status(), /Nothing to undo/);
  // Redo.
  await page.press('Control+Shift+Z');
  assert.equal(await stateOf(page), states[1]);
  await page.clickElement('#redo');
  assert.equal(await stateOf(page), states[2]);
  await page.press('Control+y');
  assert.equal(await stateOf(page), states[3]);
  assert.deepEqual(await buttonState(page, '#redo'), { off: true, title: 'Nothing to redo.' });
  assert.equal(await page.call('redo', () => window.gaitsmith.canRedo() || window.gaitsmith.redo()), false);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function searchIsOneStep({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  const before = await page.hash();
  const found = await page.call('search', async () => (await window.gaitsmith.synthesize({ seed: 9, evaluations: 800, sense: 'physical' })).hash);
  assert.notEqual(found, before);
  await page.call('undo', () => window.gaitsmith.undo());
  assert.equal(await page.hash(), before);
  await page.call('redo', () => window.gaitsmith.redo());
  assert.equal(await page.hash(), found);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function newAsksNothing({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  const before = await stateOf(page);
  for (const selector of ['#new', '#home']) {
    await page.click('panels/4');
    await page.clickElement(selector);
    await page.until('the Search panel', () => window.gaitsmith.widgets().some(({ id }) => id === 'search/start'));
    assert.equal(await page.call('clips', () => /** @type {any} */ (window.gaitsmith.document()).controllers?.length ?? 0), 0);
    assert.match(await page.status(), /^This ostrich can’t move yet\. Undo restores/);
    await page.press('Control+z');
    assert.equal(await stateOf(page), before, selector);
  }
  await page.close();
}

/** @param {Visit} visit */
async function noStaleSentence({ browser, address }) {
  const page = await PageDriver.open(browser, address, { before: () => { HTMLAnchorElement.prototype.click = () => {}; } });
  await page.clickElement('#save');
  assert.match(await page.status(), /^Saved as .*\.json$/);
  await page.press('m');
  await page.until('the next sentence', () => document.querySelector('#status')?.textContent === 'Mirrored: clip 1 goes the other way.');
  await page.press('d');
  await page.until('an empty line', () => document.querySelector('#status')?.textContent === '');
  await page.press('Control+z');
  assert.equal(await page.status(), 'Undone: the timeline.');
  await page.page.evaluate(() => { document.dispatchEvent(new ClipboardEvent('copy', { clipboardData: new DataTransfer(), bubbles: true, cancelable: true })); });
  assert.equal(await page.status(), '', 'Copy link has its own confirmation');
  // While a search is paused, the line goes back to what the search does.
  await page.call('search', () => { void window.gaitsmith.synthesize({ evaluations: 1000000 }); });
  await page.until('a search', () => /^Searching/.test(document.querySelector('#status')?.textContent ?? ''));
  await page.call('pause', () => window.gaitsmith.pause());
  await page.until('the pause', () => /^Paused/.test(document.querySelector('#status')?.textContent ?? ''));
  await page.page.evaluate(() => { window.gaitsmith.run('view/world'); });
  await page.frames(4);
  await page.press('q');
  await page.until('a sentence', () => /^Added to the queue/.test(document.querySelector('#status')?.textContent ?? ''));
  await page.call('clear', () => window.gaitsmith.run('queue/clear'));
  await page.until('the pause again', () => /^Paused/.test(document.querySelector('#status')?.textContent ?? ''));
  await page.close();
}

/**
 * Drags files over the page and drops them.
 * @param {PageDriver} page @param {{name: string, text?: string, bytes?: number[]}[]} files
 * @returns {Promise<boolean>} whether the hint was visible
 */
async function drop(page, files) {
  const hinted = await page.page.evaluate(async (list, patience) => {
    const dataTransfer = new DataTransfer();
    for (const { name, text, bytes } of list) dataTransfer.items.add(new File([text ?? new Uint8Array(bytes ?? [])], name));
    const canvas = /** @type {Element} */ (document.querySelector('canvas'));
    const send = (/** @type {string} */ type) =>
      canvas.dispatchEvent(new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true }));
    // A drag sends these all the time, at first perhaps before the page has loaded what answers.
    let width = 0;
    for (const start = performance.now(); width <= 100 && performance.now() - start < patience;) {
      send('dragover');
      width = document.querySelector('#drop-hint')?.getBoundingClientRect().width ?? 0;
      await new Promise((resolve) => { setTimeout(resolve, 20); });
    }
    send('drop');
    return width > 100;
  }, files, PATIENCE_MS);
  await page.frames();
  return hinted;
}

/** @param {Visit} visit */
async function dropping({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  const before = await stateOf(page);
  const banner = () => page.call('banner', () =>
    (document.querySelector('#banner')?.hasAttribute('hidden') ? '' : document.querySelector('#banner-text')?.textContent ?? ''));
  const good = await page.call('text', () =>
    JSON.stringify({ ...window.gaitsmith.document(), title: 'Dropped', hash: undefined, environment: { friction: 0.2 } }));
  const bad = /** @type {[RegExp, {name: string, text?: string, bytes?: number[]}[]][]} */ ([
    [/“photo\.png” was not opened: it is not a Gaitsmith document/, [{ name: 'photo.png', bytes: [0x89, 0x50, 0x4e, 0x47, 0xff, 0] }]],
    [/“empty\.json” was not opened: it is empty/, [{ name: 'empty.json', text: ' \n' }]],
    [/“half\.json” was not opened: /, [{ name: 'half.json', text: good.slice(0, good.length / 2) }]],
    [/one file at a time/, [{ name: 'a.json', text: good }, { name: 'b.json', text: good }]],
  ]);
  for (const [sentence, files] of bad) {
    assert.ok(await drop(page, files), 'no hint');
    await page.until('a banner', () => !document.querySelector('#banner')?.hasAttribute('hidden'));
    assert.match(await banner(), sentence);
    assert.equal(await stateOf(page), before);
    await page.clickElement('#banner-close');
  }
  assert.equal(await page.call('undo', () => window.gaitsmith.canUndo()), false);
  await drop(page, [{ name: 'good.json', text: good }]);
  await page.until('the document', () => window.gaitsmith.document().title === 'Dropped');
  assert.equal(await banner(), '');
  assert.ok(await page.call('hint', () => document.querySelector('#drop-hint')?.hasAttribute('hidden')));
  await page.call('undo', () => window.gaitsmith.undo());
  assert.equal(await stateOf(page), before);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @type {import('./all.mjs').Scenario[]} */
export const HISTORY_SCENARIOS = [
  ['three edits undone and done again, by key, button and script, are the same documents and motions', threeEdits],
  ['a search is one step back and forth', searchIsOneStep, ONE_BROWSER],
  ['New asks nothing, says how to go back, and Undo does', newAsksNothing],
  ['the status line keeps no sentence of an earlier action', noStaleSentence, ONE_BROWSER],
  ['a dropped document opens; other files are refused, and change nothing', dropping],
];
