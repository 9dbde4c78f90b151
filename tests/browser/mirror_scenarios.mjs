// SPDX-License-Identifier: MIT
// The canvas as those have it who do not see or point at it: by roles and names, by keyboard alone, and in words. Each
// opens pages of its own.
import assert from 'node:assert/strict';
import { PageDriver, sleep } from './page_driver.mjs';

/** @typedef {import('./scenarios.mjs').Visit} Visit */
/** @typedef {import('../../web/app.js').Widget} Widget */

/**
 * The element with this role and name, once it is there: as Chromium's accessibility tree has it; Firefox takes seconds
 * to build its own for each question, so there it is sought by what the page says.
 * @param {PageDriver} page @param {string} role @param {string} name
 */
async function byRole(page, role, name) {
  const tree = /chrome/i.test(await page.page.browser().version());
  for (const start = Date.now(); ; await sleep(100)) {
    const found = tree ? await page.page.$(`::-p-aria([name="${name}"][role="${role}"])`)
      : (await page.page.evaluateHandle(seek, role, name)).asElement();
    if (found) return found;
    assert.ok(Date.now() - start < 5000, `no ${role} "${name}"`);
  }
}

/** Runs in the page. @param {string} role @param {string} name */
function seek(role, name) {
  const implicit = /** @type {Record<string, string>} */ ({ BUTTON: 'button', INPUT: 'slider' });
  return [...document.querySelectorAll('button, input, [role]')].find((node) =>
    (node.getAttribute('role') ?? implicit[node.tagName]) === role &&
    (node.getAttribute('aria-label') ?? node.textContent) === name) ?? null;
}

/** As an assistive tool presses it: no pointer, no keys. @param {PageDriver} page @param {string} role @param {string} name */
async function activate(page, role, name) {
  await (await byRole(page, role, name)).evaluate((node) => /** @type {HTMLElement} */ (node).click());
  await settle(page);
}

/** As an assistive tool sets it. @param {PageDriver} page @param {string} role @param {string} name @param {string} value */
async function setValue(page, role, name, value) {
  await (await byRole(page, role, name)).evaluate((node, text) => {
    const input = /** @type {HTMLInputElement} */ (node);
    input.value = text;
    input.dispatchEvent(new Event('input', { bubbles: true }));
    input.dispatchEvent(new Event('change', { bubbles: true }));
  }, value);
  await settle(page);
}

/** Until the canvas has drawn what was asked and the mirror has it. @param {PageDriver} page */
async function settle(page) {
  await page.frames(5);
  await sleep(300);
}

/** @param {PageDriver} page */
const active = (page) => page.call('active', () => {
  const node = /** @type {HTMLElement} */ (document.activeElement);
  return node.dataset.id ?? (node.id || node.tagName.toLowerCase());
});

/** Has the keyboard on the canvas, and shows it. @param {PageDriver} page @returns {Promise<string | undefined>} */
const focusedWidget = async (page) => (await page.widgets()).find(({ state }) => state.focused)?.id;

/** What the page has in the mirror, as widgets() would say it. @param {PageDriver} page */
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
  for (const widget of widgets.filter(({ role }) => role !== 'scrollbar')) {
    const node = nodes.find(({ id }) => id === widget.id);
    const what = `${where}: ${widget.role} ${widget.id}`;
    assert.ok(node, `${what} has no element`);
    assert.equal(node.role, widget.role, what);
    assert.ok(node.name.startsWith(widget.label), `${what} is called "${node.name}", not "${widget.label}"`);
    if (['slider', 'spinbutton', 'combobox', 'button', 'option'].includes(widget.role)) assert.equal(node.value, widget.value, what);
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
  const page = await PageDriver.open(browser, address);
  await page.page.focus('canvas');
  await page.press(' ');
  const phone = name === 'Chromium'; // Firefox's window cannot be made so small
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

/** The document's parts that the loops below look at. @param {PageDriver} page */
const documentOf = (page) => page.call('document', () => {
  const { figure, senses, search, pushes = [], timeline = [] } = /** @type {any} */ (window.gaitsmith.document());
  return { figure: figure.name, senses: senses?.kind, seed: search?.seed, evaluations: search?.evaluations, pushes: pushes.length, clips: timeline.length };
});

/** @param {PageDriver} page */
const scrubbed = async (page) => Number.parseFloat((await page.widgets()).find(({ id }) => id === 'transport/scrub')?.value ?? '');

/** @param {PageDriver} page */
const searchDone = (page) => page.until('the end of the search', () => /^Search done/.test(document.querySelector('#status')?.textContent ?? ''));

/** @param {Visit} visit */
async function loopByRoles({ browser, address }) {
  const page = await PageDriver.open(browser, address);
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
  // What is grey does nothing.
  const remove = await byRole(page, 'button', 'Remove the selected clip');
  await remove.evaluate((node) => /** @type {HTMLElement} */ (node).click());
  await settle(page);
  assert.equal((await documentOf(page)).clips, 1);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** Presses Tab until something has the keyboard. @param {PageDriver} page @param {string} id @param {string} [key] */
async function tabTo(page, id, key = 'Tab') {
  for (let i = 0; i < 60; i++) {
    if (await active(page) === id) return settle(page);
    await page.press(key);
  }
  assert.fail(`${key} does not come to ${id}`);
}

/** @param {Visit} visit */
async function loopByKeyboard({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  const value = async (/** @type {string} */ id) => (await page.widgets()).find((widget) => widget.id === id)?.value ?? '';
  await page.page.focus('#copy-link');
  await tabTo(page, 'panels/3');
  await page.press('ArrowLeft', 3);
  assert.equal(await active(page), 'panels/0');
  await page.press('Enter');
  await settle(page);
  await page.press('Tab');
  // The figures are one stop; arrows go through them, and only the space bar takes one.
  const figure = (await documentOf(page)).figure;
  await page.press('ArrowRight');
  assert.equal((await documentOf(page)).figure, figure);
  await page.press(' ');
  await settle(page);
  assert.notEqual((await documentOf(page)).figure, figure);
  await page.press('2');
  await settle(page);
  await tabTo(page, 'panels/1');
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
  const heir = await active(page);
  assert.match(heir, /^search\//, `the keyboard is lost to ${heir} when a button goes`);

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
  assert.match(await active(page), /^world\/endpoint\//, 'an open list has the keyboard');
  await page.press('ArrowDown');
  await page.press('Enter');
  await settle(page);
  assert.equal(await value('world/endpoint'), 'Endpoint 1');
  assert.equal(await active(page), 'world/endpoint');
  await page.press('Enter');
  await settle(page);
  await page.press('Escape');
  await settle(page);
  assert.deepEqual([await active(page), await value('world/endpoint')], ['world/endpoint', 'Endpoint 1']);
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

/** @param {Visit} visit */
async function oneOrder({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  await activate(page, 'tab', 'Style');
  await page.page.focus('#copy-link');
  /** @type {string[]} */
  const forwards = [];
  for (let i = 0; i < 80 && forwards.at(-1) !== 'describe'; i++) {
    await page.press('Tab');
    forwards.push(await active(page));
    const id = forwards[i];
    if (id === 'describe') break;
    // The same on the canvas, and in sight.
    await page.frames(3);
    assert.equal(await focusedWidget(page), id);
  }
  assert.equal(forwards.at(-1), 'describe', 'Tab does not leave the canvas');
  assert.equal(new Set(forwards).size, forwards.length, `a stop twice: ${forwards}`);
  assert.ok(forwards.includes('view/forces') && forwards[0] === 'stage', `${forwards}`);
  const backwards = [];
  for (let i = 0; i < forwards.length && backwards.at(-1) !== 'copy-link'; i++) {
    await page.press('Shift+Tab');
    backwards.push(await active(page));
  }
  assert.deepEqual(backwards, [...forwards.slice(0, -1).reverse(), 'copy-link']);

  // From a click on the canvas the Tab key goes on; Escape and Tab leave.
  await page.click('transport/step');
  await page.press('Tab');
  assert.equal(await active(page), 'transport/scrub');
  await page.press('Escape');
  assert.equal(await active(page), 'body');
  await page.press('Tab');
  assert.equal(await active(page), 'describe');
  // Without the keyboard there, nothing on the canvas shows a ring.
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
  const page = await PageDriver.open(browser, address, { before: noteSaid });
  const said = () => page.call('said', () => /** @type {string[]} */ (/** @type {any} */ (window).testSaid));
  const description = () => page.text('#description');
  await sleep(2500);
  assert.deepEqual(await said(), [], 'a motion that plays is not talked about');
  await page.page.focus('[data-id=stage]');
  await page.press(' ');
  await sleep(1500);
  assert.match((await said()).join(), /^Paused at [\d.]+ s, [\d.]+ m to the (right|left)\. Rule \d+ acts\.$/);
  const before = await description();
  assert.match(before, /^Mr\. Star-Man has travelled [\d.]+ m to the (right|left) after [\d.]+ s of [\d.]+ s\. .* the ground\. Rule \d+ (acts|stays)/);
  assert.match(before, / Score /);
  assert.equal(await page.call('described', () => document.getElementById(document.querySelector('[data-id=stage]')
    ?.getAttribute('aria-describedby') ?? '')?.textContent), before);
  await page.press('.', 4);
  await sleep(1500);
  assert.notEqual(await description(), before);
  assert.equal((await said()).length, 2, `${await said()}`);
  const start = Date.now();
  await page.page.evaluate(() => { void window.gaitsmith.synthesize({ evaluations: 20000, seed: 5 }); });
  await page.until('the end', () => /^Search done/.test(document.querySelector('#status')?.textContent ?? ''));
  await sleep(2000);
  const search = (await said()).slice(2).filter((sentence) => !sentence.startsWith('Paused at'));
  assert.match(search[0], /^Searching with /);
  assert.match(search[search.length - 1], /^Search done: best [\d.]+( m)? after 20,000 evaluations\.?$/);
  assert.ok(search.length <= 3 + (Date.now() - start) / 9000, `a running commentary: ${search.join(' / ')}`);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** Runs in the page before its scripts: notes what its live region says. */
function noteSaid() {
  const said = /** @type {string[]} */ ([]);
  Object.assign(window, { testSaid: said });
  addEventListener('DOMContentLoaded', () => {
    const region = /** @type {Element} */ (document.querySelector('#spoken'));
    new MutationObserver((changes) => {
      for (const { addedNodes } of changes) for (const node of addedNodes) said.push(node.textContent ?? '');
    }).observe(region, { childList: true });
  });
}

/** @param {Visit} visit */
async function stillness({ browser, address, name }) {
  if (name === 'Firefox') return; // takes no such wish from a test
  const page = await PageDriver.open(browser, address);
  await page.page.emulateMediaFeatures([{ name: 'prefers-reduced-motion', value: 'reduce' }]);
  await page.reload();
  await sleep(500);
  const time = await scrubbed(page);
  await sleep(500);
  assert.equal(await scrubbed(page), time);
  assert.ok(time < 0.3, `${time}`);
  assert.equal(await page.call('transition', () => getComputedStyle(/** @type {Element} */ (document.querySelector('#toast'))).transitionDuration), '0s');
  // Whoever asks for it gets it.
  await activate(page, 'button', 'Play');
  await sleep(400);
  assert.ok(await scrubbed(page) > time);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function cheap({ browser, address, figures }) {
  const page = await PageDriver.open(browser, address, { before: timeMirror });
  await page.call('mark', () => { /** @type {any} */ (window).testMirrorMs.length = 0; });
  await sleep(4000);
  const times = await page.call('times', () => /** @type {number[]} */ (/** @type {any} */ (window).testMirrorMs));
  const sum = times.reduce((a, b) => a + b, 0);
  figures['mirror, ms a second while a motion plays'] = (sum / 4).toFixed(1);
  assert.ok(times.length >= 8 && times.length <= 20, `${times.length} looks in 4 s`);
  assert.ok(sum / 4 < 30, `${sum / 4} ms a second`);
  await page.close();
}

/** Runs in the page before its scripts: times what the quarter-second timers do. */
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
  ['the whole loop through the mirror, by roles and names', loopByRoles],
  ['the whole loop by keyboard alone', loopByKeyboard],
  ['there is one Tab order, which shows on the canvas, scrolls, and ends', oneOrder],
  ['what happens is said in words, at a pace to listen to', saidInWords],
  ['who wishes for less motion begins with a still one', stillness],
  ['the mirror costs little while a motion plays', cheap],
];
