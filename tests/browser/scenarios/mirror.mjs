// SPDX-License-Identifier: MIT
// The mirror of the canvas: it is complete, the Tab key has a consistent order, and announcements are right. Each
// scenario opens its own pages.
import assert from 'node:assert/strict';
import { activate, active, reached, scrubbed, settle } from '../assistive.mjs';
import { PageDriver, sleep } from '../page_driver.mjs';

/** @typedef {import('./all.mjs').Visit} Visit */
/** @typedef {import('../../../web/app/app.js').Widget} Widget */

/** The widget with a focus ring on the canvas. @param {PageDriver} page @returns {Promise<string | undefined>} */
const focusedWidget = async (page) => (await page.widgets()).find(({ state }) => state.focused)?.id;

/** The mirror's elements, in the format of widgets(). @param {PageDriver} page */
const mirrored = (page) => page.call('mirror', () => [...document.querySelectorAll('#mirror [data-id]')].map((node) => {
  const input = node instanceof HTMLInputElement ? node : null;
  const implicit = { BUTTON: 'button', INPUT: 'slider', H2: 'heading', P: 'paragraph' }[node.tagName] ?? '';
  const flag = (/** @type {string} */ name) => node.getAttribute(name) === 'true';
  const { x, y, width, height } = node.getBoundingClientRect();
  return {
    id: /** @type {HTMLElement} */ (node).dataset.id ?? '',
    role: node.getAttribute('role') ?? implicit,
    name: node.getAttribute('aria-label') ?? node.textContent ?? '',
    value: node.getAttribute('aria-valuetext') ?? input?.value ?? (node.getAttribute('role') === 'combobox' ? node.textContent : null)
      ?? node.getAttribute('aria-description') ?? '',
    disabled: flag('aria-disabled'), checked: flag('aria-checked'), selected: flag('aria-selected') || flag('aria-current'),
    expanded: flag('aria-expanded'), focused: node === document.activeElement, rect: { x, y, width, height },
  };
}));

/** @param {PageDriver} page @param {string} where */
async function assertMirrored(page, where) {
  await settle(page);
  const [widgets, nodes] = [await page.widgets(), await mirrored(page)];
  assert.ok(widgets.length > 12, `${widgets.length} widgets in ${where}`);
  for (const widget of widgets.filter(({ role }) => role !== 'scrollbar' && role !== 'tooltip')) {
    const node = nodes.find(({ id }) => id === widget.id);
    const what = `${where}: ${widget.role} ${widget.id}`;
    assert.ok(node, `${what} has no element`);
    assert.equal(node.role, widget.role, what);
    assert.ok(node.name.startsWith(widget.label), `${what} is called "${node.name}", not "${widget.label}"`);
    if (['slider', 'spinbutton', 'combobox'].includes(widget.role)) assert.equal(node.value, widget.value, what);
    // What it does comes after the value.
    if (['button', 'option'].includes(widget.role)) assert.ok(node.value.startsWith(widget.value.replace(/\.$/, '')), `${what}: ${node.value}`);
    for (const flag of /** @type {const} */ (['disabled', 'checked', 'selected', 'expanded'])) {
      assert.equal(node[flag], widget.state[flag] ?? false, `${what}: ${flag}`);
    }
    for (const side of /** @type {const} */ (['x', 'y', 'width', 'height'])) {
      assert.ok(Math.abs(node.rect[side] - widget.rect[side]) < 1, `${what}: ${side} is ${node.rect[side]}, not ${widget.rect[side]}`);
    }
  }
  const ids = new Set(widgets.map(({ id }) => id));
  const extra = nodes.filter(({ id, role }) => !ids.has(id) && !['paragraph', 'heading'].includes(role));
  const { bottom, top } = await page.call('canvas', () => {
    const box = /** @type {Element} */ (document.querySelector('canvas')).getBoundingClientRect();
    return { top: box.top, bottom: box.bottom };
  });
  for (const { id, rect } of extra) {
    assert.ok(rect.height <= 1.5 && rect.y >= top - 1 && rect.y <= bottom + 1, `${where}: ${id} is not on the canvas, yet has room in the mirror`);
  }
}

/** @param {Visit} visit */
async function equal({ browser, address, name }) {
  const page = await PageDriver.open(browser, address, { plays: true });
  await page.page.focus('canvas');
  await page.press(' ');
  const phone = name === 'Chromium'; // Firefox's window cannot be this small
  for (const size of [{ width: 1280, height: 720 }, ...(phone ? [{ width: 390, height: 844 }] : [])]) {
    await page.page.setViewport(size);
    for (const panel of ['Figure', 'Controller', 'Style', 'Search', 'Lab', ...(size.width < 700 ? ['Timeline'] : [])]) {
      await activate(page, 'tab', panel);
      await assertMirrored(page, `${panel}, ${size.width}`);
      if (panel !== 'Controller') continue;
      await activate(page, 'button', 'Rule 2');
      await assertMirrored(page, `the rule editor, ${size.width}`);
      await activate(page, 'button', 'Close the editor');
    }
    await activate(page, 'button', 'World: push, slope, friction, gravity, ghost');
    await assertMirrored(page, `the World card, ${size.width}`);
    await activate(page, 'combobox', 'Where');
    await assertMirrored(page, `an open list, ${size.width}`);
    await activate(page, 'option', 'Endpoint 2');
    await activate(page, 'button', 'Close the world card');
  }
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** Tab reaches every figure of the first screen, and the door to all others. @param {Visit} visit */
async function firstScreen({ browser, address }) {
  const page = await PageDriver.open(browser, address, { newcomer: true });
  await page.page.focus('#describe');
  const stops = /** @type {string[]} */ ([]);
  for (let i = 0; i < 40 && stops.at(-1) !== 'panel/split'; i++) {
    await page.press('Tab');
    stops.push(await active(page));
  }
  assert.ok(stops.includes('figures/draw') && stops.includes('figures/more'), `${stops}`);
  await page.page.focus('[data-id="figures/more"]');
  await page.press('Enter');
  await page.until('all figures', () => document.querySelectorAll('#mirror [data-id^="figure/gallery/"]').length >= 24);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function oneOrder({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  await activate(page, 'tab', 'Style');
  await page.page.focus('#copy-link');
  await page.press('Tab');
  await reached(page, 'describe', 'the words come right after the header');
  // One more Tab would go to the browser's own controls.
  const atEnd = () => page.call('end', () => [...document.querySelectorAll('#mirror [tabindex="0"]')].at(-1) === document.activeElement);
  /** @type {string[]} */
  const forwards = [];
  while (forwards.length < 80 && !await atEnd()) {
    await page.press('Tab');
    const id = await active(page);
    forwards.push(id);
    // The canvas has the same focus, in sight.
    await page.frames(3);
    assert.equal(await focusedWidget(page), id);
  }
  assert.ok(forwards.length < 80, 'Tab does not come to the end of the canvas');
  assert.equal(new Set(forwards).size, forwards.length, `a stop twice: ${forwards}`);
  assert.ok(['view/forces', 'stage/more'].every((id) => forwards.includes(id)) && forwards[0] === 'stage', `${forwards}`);
  const backwards = [];
  await page.page.focus('footer');
  for (let i = 0; i <= forwards.length && backwards.at(-1) !== 'describe'; i++) {
    await page.press('Shift+Tab');
    backwards.push(await active(page));
  }
  assert.deepEqual(backwards, [...forwards.reverse(), 'describe']);

  await page.page.focus('#copy-link'); // the words cover a part of the canvas while they have the focus
  // After a click on the canvas, Tab continues from there. Escape and Tab leave.
  await page.click('transport/step');
  await page.press('Tab');
  await reached(page, 'transport/scrub');
  await page.press('Escape');
  await reached(page, 'body');
  await page.press('Tab');
  await reached(page, 'footer');
  // Without the focus, the canvas shows no ring.
  await page.page.focus('#describe');
  await page.frames(4);
  const plain = await page.stage();
  await page.page.focus('[data-id=stage]');
  await page.frames(4);
  assert.notEqual((await page.stage()).sum, plain.sum);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function saidInWords({ browser, address }) {
  const page = await PageDriver.open(browser, address, { before: recordAnnouncements, plays: true });
  const announcements = () => page.call('said', () => /** @type {string[]} */ (/** @type {any} */ (window).testSaid));
  const description = () => page.text('#description');
  await sleep(2500);
  assert.deepEqual(await announcements(), [], 'a motion that plays is not talked about');
  await page.page.focus('[data-id=stage]');
  await page.press(' ');
  await sleep(1500);
  assert.match((await announcements()).join(), /^Paused at [\d.]+ s, [\d.]+ m to the (right|left)\. Rule \d+ is active\.$/);
  const before = await description();
  assert.match(before, /^Mr\. Star-Man travels [\d.]+ m to the (right|left) in [\d.]+ s\. It makes (no|\d+) full turns? and ends [a-z ]+\. After [\d.]+ s it has travelled [\d.]+ m to the (right|left)\. .* the ground\. Rule \d+ (stays|is) active/);
  assert.match(before, / Score /);
  assert.equal(await page.call('described', () => document.getElementById(document.querySelector('[data-id=stage]')
    ?.getAttribute('aria-describedby') ?? '')?.textContent), before);
  // A key reads it out.
  await page.press('w');
  await page.until('the words', `window.testSaid.some((words) => words.startsWith('Mr. Star-Man travels '))`);
  const asked = (await announcements()).length;
  await page.press('.', 4);
  await sleep(1500);
  assert.notEqual(await description(), before);
  // Four steps have one announcement. With slow frames there may be one more on the way.
  const steps = (await announcements()).length - asked;
  assert.ok(steps >= 1 && steps <= 2, `${await announcements()}`);
  const start = Date.now();
  await page.page.evaluate(() => { void window.gaitsmith.synthesize({ evaluations: 20000, seed: 5 }); });
  await page.until('the end', () => /^Search done/.test(document.querySelector('#status')?.textContent ?? ''));
  await sleep(2000);
  const search = (await announcements()).slice(asked + steps).filter((sentence) => !sentence.startsWith('Paused at'));
  assert.match(search[0], /^Searching with /);
  assert.match(search[search.length - 1], /^Search done: [\d.]+ m to the (right|left) after 20,000 tries$/);
  assert.ok(search.length <= 3 + (Date.now() - start) / 9000, `a running commentary: ${search.join(' / ')}`);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** Runs in the page before its scripts: records the texts of the live region. */
function recordAnnouncements() {
  const announcements = /** @type {string[]} */ ([]);
  Object.assign(window, { testSaid: announcements });
  addEventListener('DOMContentLoaded', () => {
    const region = /** @type {Element} */ (document.querySelector('#spoken'));
    new MutationObserver((changes) => {
      for (const { addedNodes } of changes) for (const node of addedNodes) announcements.push(node.textContent ?? '');
    }).observe(region, { childList: true });
  });
}

/** @param {Visit} visit */
async function stillness({ browser, address, name }) {
  if (name === 'Firefox') return; // a test cannot set this preference there
  const page = await PageDriver.open(browser, address, { plays: true });
  await page.page.emulateMediaFeatures([{ name: 'prefers-reduced-motion', value: 'reduce' }]);
  await page.reload();
  await sleep(500);
  const time = await scrubbed(page);
  await sleep(500);
  assert.equal(await scrubbed(page), time);
  assert.ok(time < 0.3, `${time}`);
  assert.equal(await page.call('transition', () => getComputedStyle(/** @type {Element} */ (document.querySelector('#toast'))).transitionDuration), '0s');
  // The person can still start it.
  await activate(page, 'button', 'Play');
  await sleep(400);
  assert.ok(await scrubbed(page) > time);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** Changes that a look may make in the mirror while only the motion plays: the time, and what moves with it. Measured: 9. */
const MOST_CHANGES = 12;

/** @param {Visit} visit */
async function cheap({ browser, address, figures }) {
  const page = await PageDriver.open(browser, address, { before: timeMirror, plays: true });
  await page.call('mark', () => {
    const state = /** @type {any} */ (window);
    state.testMirrorMs.length = state.testChanges = 0;
    new MutationObserver((changes) => { state.testChanges += changes.length; })
      .observe(/** @type {Element} */ (document.querySelector('#mirror')), { subtree: true, childList: true, attributes: true, characterData: true });
  });
  await sleep(4000);
  await page.until('eight looks', () => /** @type {any} */ (window).testMirrorMs.length >= 8);
  const { times, changes } = await page.call('times', () => ({
    times: /** @type {number[]} */ (/** @type {any} */ (window).testMirrorMs), changes: Number(/** @type {any} */ (window).testChanges),
  }));
  assert.ok(changes > 0 && changes <= MOST_CHANGES * times.length, `${changes} changes in ${times.length} looks`);
  // By the median, because a busy machine interrupts some of them, and against the least that each look must do.
  const median = (/** @type {number[]} */ all) => [...all].sort((a, b) => a - b)[all.length >> 1] ?? NaN;
  const reading = median(await page.call('reading', () => Array.from({ length: 15 }, () => {
    const start = performance.now();
    window.gaitsmith.widgets();
    return performance.now() - start;
  })));
  figures['mirror, ms a second while a motion plays'] = (median(times) * times.length / 4).toFixed(1);
  figures['a look of the mirror, in readings of the widgets'] = (median(times) / reading).toFixed(1);
  await page.close();
}

/** Runs in the page before its scripts: measures the timers of a quarter second. */
function timeMirror() {
  const times = /** @type {number[]} */ ([]);
  const { setInterval: plain } = window;
  Object.assign(window, {
    testMirrorMs: times,
    setInterval: (/** @type {() => void} */ body, /** @type {number} */ ms) => plain(() => {
      const start = performance.now();
      body();
      if (String(body).includes('update')) times.push(performance.now() - start);
    }, ms),
  });
}

/** @type {[string, (visit: Visit) => Promise<void>][]} */
export const MIRROR_SCENARIOS = [
  ['the mirror has every widget of every panel, with role, name, value, state and place', equal],
  ['Tab reaches the door to all figures', firstScreen],
  ['there is one Tab order, which shows on the canvas, scrolls, and ends', oneOrder],
  ['what happens is said in words, at a pace to listen to', saidInWords],
  ['reduced motion starts paused', stillness],
  ['the mirror changes little while a motion plays', cheap],
];
