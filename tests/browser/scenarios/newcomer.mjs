// SPDX-License-Identifier: MIT
// What a newcomer reaches, and with how many presses: by mouse, by finger and by keys. The page is used only as a person
// would use it. Each scenario opens its own pages in a new profile.
import assert from 'node:assert/strict';
import { ONE_BROWSER, PageDriver, RARELY } from '../page_driver.mjs';
import { Fingers, Mouse } from '../pointers.mjs';

/** @typedef {import('./all.mjs').Visit} Visit */
/** @typedef {'mouse' | 'finger' | 'keys'} Means */
/** Opens the page, or a link, as a new visitor. @typedef {(link?: string) => Promise<PageDriver>} Door */

const MEANS = /** @type {const} */ (['keys', 'mouse', 'finger']);
const TAB_STOPS = 80;

/** A person who counts the presses. A drag is one press; by keys, Enter is. */
class Newcomer {
  presses = 0;

  /** @param {PageDriver} page @param {Means} means */
  constructor(page, means) {
    this.page = page;
    this.means = means;
    this.pointer = means === 'finger' ? new Fingers(page) : new Mouse(page);
  }

  /** @param {Door} door @param {Means} means */
  static async arrive(door, means) {
    const page = await door();
    if (means === 'finger') await page.becomePhone();
    await page.frames(10);
    return new Newcomer(page, means);
  }

  /** Presses a control of the canvas; one that has no room is in the menu "More". @param {string} id @returns {Promise<void>} */
  async press(id) {
    const { page } = this;
    const there = () => page.widgets().then((all) => all.find((widget) => widget.id === id));
    const widget = await there();
    if (!widget) {
      const label = LABELS[id];
      assert.ok(label, `no ${id}, and no place where it may be`);
      await this.press('stage/more');
      await page.until(label, `window.gaitsmith.widgets().some(({ role, label }) => role === 'option' && label === ${JSON.stringify(label)})`);
      const option = (await page.widgets()).find((one) => one.role === 'option' && one.label === label);
      assert.ok(option);
      return this.press(option.id);
    }
    this.presses++;
    if (this.means === 'keys') await this.#enter(`[data-id="${id}"]`);
    else if (this.means === 'mouse') await page.click(id);
    else {
      await this.#rest(id);
      await this.#largeEnough(id);
      await this.pointer.tap(await this.pointer.centre(id));
    }
    await page.frames(6);
  }

  /** Presses a control of the page. @param {string} selector */
  async pressElement(selector) {
    this.presses++;
    await this.page.until(selector, `document.querySelector(${JSON.stringify(selector)})?.checkVisibility() ?? false`);
    if (this.means === 'keys') return this.#enter(selector);
    // A dialog that just opened may still be laid out: press where the element rests and is on top.
    await this.page.until(`${selector} on top`, `(() => {
      const pressed = document.querySelector(${JSON.stringify(selector)}), { left, top, width, height } = pressed.getBoundingClientRect();
      const place = [left, top, width, height].join(), rests = pressed.dataset.place === place;
      pressed.dataset.place = place;
      return rests && pressed.contains(document.elementFromPoint(left + width / 2, top + height / 2));
    })()`);
    const box = await (await this.page.page.$(selector))?.boundingBox();
    assert.ok(box, `no visible ${selector}`);
    await this.pointer.tap({ x: box.x + box.width / 2, y: box.y + box.height / 2 });
  }

  /** Chooses a figure of the row by its name. @param {string} name */
  async choose(name) {
    const tile = (await this.page.widgets()).find(({ id, label }) => id.startsWith('figures/') && label === name);
    assert.ok(tile, `${name} is in the row of figures`);
    await this.press(tile.id);
    await this.page.until(name, `window.gaitsmith.document().figure.name === ${JSON.stringify(name)}`);
  }

  /** @param {import('../pointers.mjs').Point} from @param {import('../pointers.mjs').Point} to */
  async drag(from, to) {
    this.presses++;
    await this.pointer.drag(from, to);
  }

  /** Teaches, and waits for the motion. @param {number} [results] */
  async teach(results = 1) {
    const ids = (await this.page.widgets()).map(({ id }) => id);
    await this.press(['stage/teach', 'draw/teach'].find((id) => ids.includes(id)) ?? 'stage/another');
    await this.page.until('the end of the search', `window.gaitsmith.results().length >= ${results}`);
    await this.page.until('it can be used', () => window.gaitsmith.widgets().some(({ id }) => id === 'stage/another'));
  }

  /** @param {number} presses  at most so many were needed @param {string} what  they were for */
  spent(presses, what) { assert.ok(this.presses <= presses, `${this.presses} presses by ${this.means} ${what}, at most ${presses}`); }

  async leave() {
    assert.deepEqual(this.page.complaints, []);
    await this.page.close();
  }

  /**
   * Moves the focus with Tab, backwards to what stands before it, and by arrows within lists, until it is there, then
   * presses Enter. Forwards only, the way would lead round through the browser's own controls: Firefox leaves the page
   * there, and a script's keys do not bring it back.
   * @param {string} selector
   */
  async #enter(selector) {
    const { page } = this;
    const reached = () => page.call('focus', `document.activeElement?.matches(${JSON.stringify(selector)}) ?? false`);
    const within = () => page.call('list', `(() => {
      const list = document.querySelector(${JSON.stringify(selector)})?.closest('[role=tablist], [role=radiogroup], [role=listbox]');
      return Boolean(list?.contains(document.activeElement));
    })()`);
    const before = () => page.call('order', `(() => {
      const focused = document.activeElement, wanted = document.querySelector(${JSON.stringify(selector)});
      return Boolean(focused && wanted && focused !== document.body && focused.compareDocumentPosition(wanted) & Node.DOCUMENT_POSITION_PRECEDING);
    })()`);
    for (let stops = 0; !await reached(); stops++) {
      assert.ok(stops < TAB_STOPS, `the keys reach no ${selector}`);
      await page.press(await within() ? 'ArrowDown' : await before() ? 'Shift+Tab' : 'Tab');
    }
    await page.press('Enter');
  }

  /** What a finger presses is 44 px high and on the screen. @param {string} id */
  async #largeEnough(id) {
    const { x, width, height } = (await this.pointer.find(id))?.rect ?? assert.fail(`no ${id}`);
    const across = await this.page.call('width', () => innerWidth);
    assert.ok(height >= 44 && x >= 0 && x + width <= across, `${id} is ${height} px high, from ${x} to ${x + width} of ${across}`);
  }

  /** Waits until a widget no longer moves. @param {string} id */
  async #rest(id) {
    for (let last = '', tries = 0; tries < 100; tries++, await this.page.frames()) {
      const place = JSON.stringify((await this.pointer.find(id))?.rect);
      if (place === last) return;
      last = place;
    }
    assert.fail(`${id} does not rest`);
  }
}

/** Actions of the stage that may be in the menu. @type {Record<string, string>} */
const LABELS = { 'stage/push': 'Push it', 'stage/calmer': 'Calmer', 'stage/chain': 'Add to timeline', 'stage/share': 'Share', 'stage/export': 'Export' };

/** A bird that sprints, is pushed, shared and chained. @param {Door} door @param {Means} means */
async function bird(door, means) {
  const person = await Newcomer.arrive(door, means);
  const { page } = person;
  await person.teach();
  person.spent(1, 'to sprint');
  assert.ok((await page.call('metres', () => window.gaitsmith.results()[0].score ?? 0)) >= 16, '2 m/s for eight seconds');
  const hash = await page.hash();

  await person.press('stage/push');
  person.spent(2, 'to push');
  await page.until('pushed', () => (window.gaitsmith.document().pushes ?? []).length === 1);
  assert.notEqual(await page.hash(), hash);
  await page.press('Control+z'); // a push is a step of Undo
  await page.until('as before', `window.gaitsmith.hash() === '${hash}'`);

  person.presses = 1; // from the sprint on
  await person.press('stage/share');
  await page.until('the dialog', () => document.querySelector('#share-dialog[open]') !== null);
  const link = await page.call('link', () => /** @type {HTMLTextAreaElement} */ (document.querySelector('#share-link')).value);
  await person.pressElement('#share-copy');
  person.spent(3, 'to share');
  await page.until('it is copied, or selected to be copied', () => document.querySelector('#share-said')?.textContent !== '');
  await page.call('close', () => /** @type {HTMLDialogElement} */ (document.querySelector('#share-dialog')).close());

  person.presses = 1;
  await person.press('stage/chain');
  person.spent(means === 'finger' ? 3 : 2, 'to chain'); // a phone has it under "More"
  await page.until('two clips', () => (/** @type {{timeline?: unknown[]}} */ (window.gaitsmith.document()).timeline ?? []).length === 2);
  await person.leave();

  const friend = await door(link);
  assert.equal(await friend.hash(), hash, 'a friend sees the same motion');
  assert.ok((await friend.widgets()).some(({ id }) => id === 'stage/make'), 'in the viewer');
  await friend.close();
}

/** @param {Door} door @param {Means} means */
async function goals(door, means) {
  const acrobat = await Newcomer.arrive(door, means);
  await acrobat.choose('Acrobat');
  await acrobat.press('goal/cartwheel');
  await acrobat.teach();
  assert.ok(Number((await acrobat.page.call('measures', () => window.gaitsmith.measures())).rotations) >= 1, 'it turns over');
  acrobat.spent(3, 'for a cartwheel');
  await acrobat.leave();
  if (means === 'finger') return calmer(door); // a phone's row of figures has no room for the horse
  const horse = await Newcomer.arrive(door, means);
  await horse.choose('Horse');
  await horse.press('goal/calm');
  await horse.teach();
  const { effort } = await horse.page.call('measures', () => window.gaitsmith.measures());
  const joints = await horse.page.call('joints', () => (window.gaitsmith.document().figure?.rods?.length ?? 0) - 1);
  assert.ok(Number(effort) <= joints * 8, 'its joints turn by at most 1 rad/s for eight seconds');
  horse.spent(3, 'for a calm gait');
  await horse.leave();
}

/** A calm gait from a quick one. @param {Door} door */
async function calmer(door) {
  const person = await Newcomer.arrive(door, 'finger');
  const effort = () => person.page.call('effort', () => Number(window.gaitsmith.measures().effort));
  await person.teach();
  const before = await effort();
  await person.press('stage/calmer');
  await person.page.until('the calmer one', () => window.gaitsmith.results().length === 2);
  await person.page.until('it is shown', `Number(window.gaitsmith.measures().effort) < ${0.9 * before}`);
  person.spent(3, 'for a calmer gait');
  await person.leave();
}

/** @param {Door} door @param {Means} means */
async function own(door, means) {
  const person = await Newcomer.arrive(door, means);
  const { page } = person;
  await person.press('figures/draw');
  await page.until('the board', () => window.gaitsmith.widgets().some(({ id }) => id === 'figure/board'));
  const rods = () => page.call('rods', () => window.gaitsmith.document().figure.rods?.length ?? 0);
  const board = (await page.widgets()).find(({ id }) => id === 'figure/board');
  assert.ok(board);
  const { x, y, width, height } = board.rect;
  const at = (/** @type {number} */ right, /** @type {number} */ down) => ({ x: x + right * width, y: y + down * height });
  for (const foot of [0.35, 0.65]) { // two legs
    if (means === 'keys') await person.press('draw/grow');
    else await person.drag(at(0.5, 0.3), at(foot, 0.8));
  }
  if (means === 'keys') await person.press('draw/grow'); // the first one stands upright, and two in line only fall
  assert.equal(await rods(), means === 'keys' ? 3 : 2);
  await person.teach();
  const metres = Math.abs(await page.call('metres', () => window.gaitsmith.results()[0].score ?? 0));
  assert.ok(metres > 0.5, `it moves ${metres} m, drawn by ${means}`);
  person.spent(means === 'keys' ? 5 : 4, 'to draw');
  await person.leave();
}

/** Controls on the canvas and of the page that a person sees. @param {PageDriver} page */
async function controls(page) {
  const canvas = (await page.widgets()).filter(({ role, id }) => !['img', 'note', 'heading', 'paragraph', 'scrollbar'].includes(role) && id !== 'stage');
  const html = await page.call('controls', () => [...document.querySelectorAll('a[href], button, select, input, textarea')]
    .filter((node) => !node.closest('#mirror, #in-words, dialog') && node.checkVisibility()).length);
  return { canvas: canvas.map(({ id }) => id.replace(/[0-9a-f]{16}/, 'motion')), html };
}

/**
 * Later features enter through More, Advanced or a goal: the first screens must not grow.
 * @param {Visit} visit
 */
async function count({ browser, address }) {
  for (const [width, height, first, found] of /** @type {const} */ ([[1280, 720, [24, 13], [32, 13]], [390, 844, [13, 5], [20, 5]]])) {
    const page = await PageDriver.open(browser, address, { newcomer: true, plays: true });
    await page.page.setViewport({ width, height, deviceScaleFactor: 1 });
    await page.frames(10);
    const before = await controls(page);
    assert.deepEqual([before.canvas.length, before.html], first, `the first screen, ${width} by ${height}: ${before.canvas.join(' ')}`);
    await page.click('stage/teach');
    await page.until('the end of the search', () => window.gaitsmith.results().length > 0);
    await page.until('the actions', () => window.gaitsmith.widgets().some(({ id }) => id === 'stage/another'));
    await page.frames(10);
    const after = await controls(page);
    assert.deepEqual([after.canvas.length, after.html], found, `the found screen, ${width} by ${height}: ${after.canvas.join(' ')}`);
    assert.deepEqual(page.complaints, []);
    await page.close();
  }
}

/** What a newcomer does. @type {[string, (door: Door, means: Means) => Promise<void>][]} */
export const NEWCOMER_STORIES = [
  ['has a sprinting bird after one press, pushes and chains it with the second, shares it with the third', bird],
  ['has a cartwheel and a calm gait after three presses each', goals],
  ['draws a figure that moves, within four presses', own],
];

/** @type {import('./all.mjs').Scenario[]} */
export const NEWCOMER_SCENARIOS = [
  // Each story by one means in a whole run, by all of them in ./dev browsers.
  ...NEWCOMER_STORIES.flatMap(([claim, story], i) => MEANS.map((means, j) => /** @type {import('./all.mjs').Scenario} */ ([
    `a newcomer, by ${means}, ${claim}`,
    ({ browser, address }) => story((link = address) => PageDriver.open(browser, link, { newcomer: true, plays: true }), means),
    undefined, i === j ? 'always' : RARELY]))),
  ['the first screen and the screen of the first motion have no more controls than before', count, ONE_BROWSER],
];
