// SPDX-License-Identifier: MIT
// Tooltips of the canvas: every control has a sentence, and it appears for pointer, keyboard and finger. Each scenario
// opens its own pages.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { activate, active, reached, settle } from '../assistive.mjs';
import { ROOT } from '../browsers.mjs';
import { Mouse } from '../pointers.mjs';
import { ONE_BROWSER, PageDriver, sleep } from '../page_driver.mjs';

/** @typedef {import('./all.mjs').Visit} Visit */

const TEXTS = new Set(['note', 'heading', 'paragraph', 'tooltip']);

/** @returns {Promise<Record<string, string>>} */
const tableOf = async (code = 'en') => JSON.parse(await readFile(join(ROOT, `shell/words/hints/${code}.json`), 'utf8'));

/** The sentence of a control, as in shell/words/hints.cpp. @param {Record<string, string>} table @param {string} id */
function sentenceFor(table, id) {
  const fits = (/** @type {string} */ family) => {
    const [before, after] = family.split('*');
    return after === undefined ? family === id
      : id.endsWith('!') === family.endsWith('!') && id.length + 1 >= family.length && id.startsWith(before) && id.endsWith(after);
  };
  const family = Object.keys(table).find(fits);
  return family === undefined ? '' : table[family];
}

/** The controls' elements in the mirror, with the sentences that assistive tools get. @param {PageDriver} page */
const mirrored = (page) => page.call('mirror', () => [...document.querySelectorAll('#mirror [data-id]')].map((node) => ({
  id: /** @type {HTMLElement} */ (node).dataset.id ?? '',
  role: node.getAttribute('role') ?? node.tagName,
  off: node.getAttribute('aria-disabled') === 'true',
  said: node.getAttribute('aria-description') ?? '',
})));

/** @param {PageDriver} page */
const tooltip = async (page) => (await page.widgets()).find(({ role }) => role === 'tooltip');

/** @param {PageDriver} page */
async function untilTooltip(page) {
  await page.until('a tooltip', () => window.gaitsmith.widgets().some(({ role }) => role === 'tooltip'));
  return await tooltip(page) ?? assert.fail('it has gone');
}

/** @param {PageDriver} page */
const untilHints = (page) => page.until('the sentences', () => document.querySelector('#mirror [data-id^="stage/"][aria-description]') !== null);

/** Collects controls without a sentence. */
class Census {
  /** @type {Set<string>} */
  seen = new Set();
  /** @type {Set<string>} */
  missing = new Set();

  /** @param {Record<string, string>} table */
  constructor(table) { this.table = table; }

  /** @param {PageDriver} page @param {string} where */
  async take(page, where) {
    await settle(page);
    for (const { id, role, off, said } of await mirrored(page)) {
      if (TEXTS.has(role) || id.startsWith('text/')) continue;
      this.seen.add(id);
      const sentence = sentenceFor(this.table, id);
      const shown = sentence.replace(/^.*\{[12]\}[ :.]*/, '').slice(-20);
      if (!sentence || !said.includes(shown)) this.missing.add(`${id} (${where}): "${said}"`);
      else if (off && said.endsWith(sentence)) this.missing.add(`${id}! (${where}), the reason: "${said}"`);
    }
    // Scroll bars have no element.
    for (const { id, role } of await page.widgets()) if (!TEXTS.has(role) && !sentenceFor(this.table, id)) this.missing.add(id);
  }
}

/** @param {Visit} visit */
async function everyControl({ browser, address }) {
  const table = await tableOf();
  const census = new Census(table);
  const fresh = await PageDriver.open(browser, address, { newcomer: true });
  await untilHints(fresh);
  await census.take(fresh, 'first screen');
  await fresh.click('stage/teach');
  await fresh.until('a motion', () => window.gaitsmith.results().length > 0);
  await fresh.play(false);
  await census.take(fresh, 'found');
  for (const tab of [0, 1, 2]) {
    await fresh.click(`dock/${tab}`);
    await census.take(fresh, `dock ${tab}`);
  }
  assert.deepEqual(fresh.complaints, []);
  await fresh.close();

  const page = await PageDriver.open(browser, address);
  await page.page.setViewport({ width: 1280, height: 1500 });
  await untilHints(page);
  const pointer = new Mouse(page);
  for (const panel of ['Figure', 'Controller', 'Style', 'Search', 'Lab']) {
    await activate(page, 'tab', panel);
    await census.take(page, panel);
  }
  await activate(page, 'tab', 'Figure');
  await activate(page, 'combobox', 'Preset');
  await census.take(page, 'presets');
  await page.press('Escape');
  await activate(page, 'tab', 'Controller');
  await activate(page, 'button', 'Rule 2');
  await census.take(page, 'rule editor');
  await activate(page, 'button', 'Close the editor');
  await activate(page, 'tab', 'Style');
  await activate(page, 'button', 'How it is scored');
  await activate(page, 'combobox', 'Goal');
  await census.take(page, 'goals');
  await page.press('Escape');
  await activate(page, 'button', 'World: push, slope, friction, gravity, ghost');
  await activate(page, 'combobox', 'Where');
  await census.take(page, 'world');
  await page.press('Escape');
  await activate(page, 'button', 'Push now');
  await activate(page, 'combobox', 'With');
  await census.take(page, 'comparisons');
  await activate(page, 'option', 'Without your changes');
  await census.take(page, 'compared');
  await activate(page, 'button', 'Close the world card');

  // A search of each kind, the queue, the suite and the results.
  await activate(page, 'tab', 'Search');
  for (const fold of ['search/settings', 'suite', 'queue', 'found']) {
    if (!(await page.widgets()).find(({ id }) => id === fold)?.state.expanded) await pointer.press(fold);
  }
  await pointer.press('search/variation');
  await pointer.press('search/all-algorithms');
  await pointer.press('search/algorithm');
  const algorithms = (await page.widgets()).filter(({ id }) => id.startsWith('search/algorithm/')).length;
  assert.ok(algorithms > 12);
  await page.press('Escape');
  for (let next = 0; next < algorithms; next++) {
    await pointer.press('search/algorithm');
    await page.click(`search/algorithm/${next}`);
    await census.take(page, `algorithm ${next}`);
  }
  await page.call('a short one', () => {
    const document = window.gaitsmith.document();
    window.gaitsmith.open({ ...document, hash: undefined, search: { algorithm: 'map-elites', seed: 3, evaluations: 400 } });
  });
  await page.call('synthesize', () => window.gaitsmith.synthesize({}).then(() => true));
  await activate(page, 'tab', 'Search');
  await page.call('a front', () => {
    const document = window.gaitsmith.document();
    window.gaitsmith.open({ ...document, hash: undefined, search: { algorithm: 'nsga-ii', seed: 3, evaluations: 400, genetic: { population: 50 } } });
  });
  await page.call('synthesize', () => window.gaitsmith.synthesize({}).then(() => true));
  await activate(page, 'tab', 'Search');
  await census.take(page, 'front');
  await page.call('waiting', () => {
    for (const seed of [5, 6]) window.gaitsmith.enqueue({ seed, evaluations: 900000 });
  });
  await census.take(page, 'searching');
  await page.page.evaluate(() => window.gaitsmith.stop());
  await page.frames();
  if (!(await page.widgets()).find(({ id }) => id === 'elites')?.state.expanded) await pointer.press('elites');
  await census.take(page, 'stopped');

  await page.click('timeline/add');
  await page.click('timeline/mirror');
  await census.take(page, 'two clips');
  for (const [width, height] of [[390, 844], [844, 390]]) {
    await page.page.setViewport({ width, height });
    await census.take(page, `${width} by ${height}`);
  }
  const link = await page.link();
  assert.deepEqual(page.complaints, []);
  await page.close();
  const viewer = await PageDriver.open(browser, link, { newcomer: true });
  await untilHints(viewer);
  await census.take(viewer, 'viewer');
  await viewer.close();
  assert.deepEqual([...census.missing], []);
  assert.ok(census.seen.size > 150, `only ${census.seen.size} controls were seen`);
}

/** @param {Visit} visit */
async function pointedAt({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  await untilHints(page);
  const table = await tableOf();
  const spot = (await page.widgets()).find(({ id }) => id === 'stage/calmer')?.rect ?? assert.fail('no button');
  await page.page.mouse.move(spot.x + spot.width / 2, spot.y + spot.height / 2);
  assert.equal(await tooltip(page), undefined, 'not at once');
  const shown = await untilTooltip(page);
  assert.equal(shown.label, table['stage/calmer']);
  assert.ok(shown.rect.y + shown.rect.height <= spot.y, 'it does not cover its control');
  // It stays while the pointer is on it, so that it can be read enlarged.
  await page.page.mouse.move(shown.rect.x + 20, shown.rect.y + shown.rect.height / 2, { steps: 4 });
  await sleep(700);
  assert.equal((await tooltip(page))?.label, table['stage/calmer']);
  // Escape hides it and does nothing else.
  await page.page.keyboard.press('Escape');
  await page.frames();
  assert.equal(await tooltip(page), undefined, 'Escape hides it');
  // The stage shows the motion, not a sentence.
  const stage = (await page.widgets()).find(({ id }) => id === 'stage')?.rect ?? assert.fail('no stage');
  await page.page.mouse.move(stage.x + stage.width / 2, stage.y + 100);
  await sleep(900);
  assert.equal(await tooltip(page), undefined);
  // A click hides it, too.
  await page.page.mouse.move(spot.x + spot.width / 2, spot.y + spot.height / 2);
  await untilTooltip(page);
  await page.click('transport/step');
  await sleep(900);
  assert.equal(await tooltip(page), undefined, 'a click ends it');
  // In German, too.
  await page.page.evaluate(() => window.gaitsmith.run('view/language/de'));
  const german = await tableOf('de');
  await page.until('German words', () => window.gaitsmith.widgets().some(({ id, label }) => id === 'stage/calmer' && label !== 'Calmer'));
  const place = (await page.widgets()).find(({ id }) => id === 'stage/calmer')?.rect ?? assert.fail('no button');
  await page.page.mouse.move(place.x + place.width / 2, place.y + place.height / 2);
  await page.until('German', `window.gaitsmith.widgets().some(({ role, label }) => role === 'tooltip' && label === ${JSON.stringify(german['stage/calmer'])})`);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** Every stop of the Tab key on a phone's screen. @param {Visit} visit */
async function focused({ browser, address, name }) {
  const page = await PageDriver.open(browser, address, { newcomer: true });
  await page.page.setViewport(name === 'Chromium' ? { width: 390, height: 844 } : { width: 800, height: 700 });
  await untilHints(page);
  const [width, height] = await page.call('canvas', () => {
    const { clientWidth, clientHeight } = /** @type {Element} */ (document.querySelector('canvas'));
    return [clientWidth, clientHeight];
  });
  await page.page.focus('#describe');
  let controls = 0;
  for (let stop = 0; stop < 40; stop++) {
    await page.press('Tab');
    const id = await active(page);
    if (id === 'footer' || !id.includes('/')) {
      if (controls > 0) break;
      continue;
    }
    const { rect, label } = await untilTooltip(page);
    assert.ok(rect.x >= 0 && rect.y >= 0 && rect.x + rect.width <= width + 0.5 && rect.y + rect.height <= height + 0.5, `${id}: ${JSON.stringify(rect)}`);
    assert.ok((await page.call('said', () => document.activeElement?.getAttribute('aria-description') ?? '')).endsWith(label), id);
    controls++;
    if (controls > 1) continue;
    await page.press('Escape');
    assert.equal(await tooltip(page), undefined, 'Escape hides it');
    await reached(page, id, 'and leaves the focus where it is');
  }
  assert.ok(controls >= 5, `${controls} controls`);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function heldByFinger({ browser, address }) {
  const page = await PageDriver.open(browser, address, { newcomer: true });
  await page.becomePhone();
  await untilHints(page);
  const teach = (await page.widgets()).find(({ id }) => id === 'stage/teach')?.rect ?? assert.fail('no button');
  const touch = await page.page.touchscreen.touchStart(teach.x + 40, teach.y + teach.height / 2);
  const shown = await untilTooltip(page);
  await touch.end();
  await page.frames(6);
  assert.ok(shown.rect.x >= 0 && shown.rect.x + shown.rect.width <= 390 && shown.rect.y >= 0);
  assert.equal((await tooltip(page))?.label, shown.label, 'it stays to be read');
  await sleep(500);
  assert.ok((await page.widgets()).some(({ id }) => id === 'stage/teach'), 'nothing was pressed');
  // A short touch presses it, as before.
  await page.page.touchscreen.tap(teach.x + 40, teach.y + teach.height / 2);
  await page.until('a search', () => !window.gaitsmith.widgets().some(({ id }) => id === 'stage/teach'));
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function disabledOne({ browser, address }) {
  const page = await PageDriver.open(browser, address, { newcomer: true });
  await untilHints(page);
  const grey = async () => (await page.widgets()).find(({ id, state }) => id.startsWith('goal/') && state.disabled);
  for (const { id } of (await page.widgets()).filter((widget) => /^figures\/\d+$/.test(widget.id))) {
    if (await grey()) break;
    await page.click(id);
    await page.frames(4);
  }
  const goal = await grey() ?? assert.fail('every figure reaches every goal');
  await page.page.focus('#mirror [data-id^="goal/"][tabindex="0"]');
  for (let step = 0; step < 7 && await active(page) !== goal.id; step++) await page.press('ArrowRight');
  await reached(page, goal.id, 'the keyboard gets to it');
  assert.match((await untilTooltip(page)).label, /Only \d+ of \d+ tries with this figure managed it\.$/);
  assert.match(await page.call('said', () => document.activeElement?.getAttribute('aria-description') ?? ''), /managed it\.$/);
  await page.press('Enter');
  await page.frames(4);
  assert.equal((await page.widgets()).find(({ id }) => id === goal.id)?.state.checked, false, 'it cannot be chosen');
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @type {[string, (visit: Visit) => Promise<void>, string?][]} */
export const HINT_SCENARIOS = [
  ['hints: every control of the canvas has a sentence, for assistive tools, too', everyControl, ONE_BROWSER],
  ['hints: a tooltip comes under a resting pointer, stays when pointed at, and Escape hides it', pointedAt],
  ['hints: a tooltip comes with the keyboard\'s focus, within the window', focused],
  ['hints: a finger that stays shows the tooltip and presses nothing', heldByFinger, 'Chromium'],
  ['hints: the keyboard reaches a disabled goal and its reason', disabledOne, ONE_BROWSER],
];
