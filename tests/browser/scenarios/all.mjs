// SPDX-License-Identifier: MIT
// Scenarios for every browser. Each is an observation that a user could make. They share one page and build on each
// other, like a visit.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { ROOT } from '../browsers.mjs';
import { ONCE, PATIENCE_MS, PageDriver, RARELY, sleep } from '../page_driver.mjs';
import { AXE_SCENARIOS } from './axe.mjs';
import { BREED_SCENARIOS } from './breed.mjs';
import { EXPORT_SCENARIOS } from './export/dialog.mjs';
import { FAULT_SCENARIOS } from './fault.mjs';
import { FIGURE_SCENARIOS } from './figure.mjs';
import { FRONT_SCENARIOS } from './front.mjs';
import { GALLERY_SCENARIOS } from './gallery.mjs';
import { LIVE_SCENARIOS } from './live.mjs';
import { FINGER_SCENARIOS } from './finger.mjs';
import { FIRST_SCREEN_SCENARIOS } from './first_screen.mjs';
import { GRAPHICS_SCENARIOS } from './graphics.mjs';
import { HINT_SCENARIOS } from './hints.mjs';
import { HISTORY_SCENARIOS } from './history.mjs';
import { KEPT_WORK_SCENARIOS } from './kept_work.mjs';
import { LAB_SCENARIOS } from './lab.mjs';
import { LANGUAGE_SCENARIOS } from './language.mjs';
import { LOOP_SCENARIOS } from './loop.mjs';
import { MESSAGE_SCENARIOS } from './message.mjs';
import { MIRROR_SCENARIOS } from './mirror.mjs';
import { OFFLINE_SCENARIOS } from './offline.mjs';
import { OUTAGE_SCENARIOS } from './outage.mjs';
import { PALETTE_SCENARIOS } from './palette.mjs';
import { QUEUE_SCENARIOS } from './queue.mjs';
import { SECURITY_SCENARIOS } from './security.mjs';
import { SHARE_SCENARIOS, damagedLink } from './share.mjs';
import { STORED_SCENARIOS } from './stored.mjs';
import { STYLE_SCENARIOS } from './style.mjs';
import { SUITE_SCENARIOS } from './suite.mjs';
import { BEFORE_AFTER_SCENARIOS } from './book/before_after.mjs';
import { CLASSROOM_SCENARIOS } from './book/classroom.mjs';
import { EXPLORABLE_SCENARIOS } from './book/explorable.mjs';
import { LEARNING_SCENARIOS } from './book/learning.mjs';
import { NEW_LESSON_SCENARIOS } from './book/new_lesson.mjs';
import { REST_SCENARIOS } from './rest.mjs';
import { TEACH_SCENARIOS } from './teach.mjs';
import { TIMELINE_SCENARIOS } from './timeline.mjs';
import { WORLD_SCENARIOS } from './world.mjs';
import { RULE_SCENARIOS } from './rule.mjs';
import { THEME_SCENARIOS } from './theme.mjs';
import { DOOR_SCENARIOS } from './door.mjs';
import { NEWCOMER_SCENARIOS } from './newcomer.mjs';
import { TOUR_SCENARIOS } from './tour.mjs';
import { TYPING_SCENARIOS } from './typing.mjs';
import { VIEWER_SCENARIOS } from './viewer.mjs';
import { WALK_SCENARIOS } from './walk.mjs';
import { bytesUntilFirstMotion } from '../../bench/page_weight.mjs';
import { nativeHash } from '../native.mjs';

/** @typedef {import('../browsers.mjs').Browser} Browser */
/**
 * @typedef {object} Visit  shared by the scenarios of a browser
 * @property {string} name
 * @property {Browser} browser
 * @property {string} site      the served folder
 * @property {string} address
 * @property {PageDriver} page
 * @property {Record<string, string>} found  hashes that every browser must agree on
 * @property {string} link                   as Copy link gave it
 * @property {Record<string, number | string>} figures  measured
 */

/** Short searches, because the claims do not depend on length. */
const EVALUATIONS = 8000;

/**
 * A claim, its test, and where it runs: a browser's name if no other can run it, ONCE. How often: RARELY or always.
 * @typedef {[string, (visit: Visit) => Promise<void>, string?, string?]} Scenario
 */
/**
 * Scenarios of the canvas, of searches, of our own workers and of plain pages, which run the same code in every browser. A
 * whole run does not repeat them in the second browser (docs/design.md, 59 and 84). BROWSER=firefox runs them there.
 * @param {Scenario[]} scenarios @returns {Scenario[]}
 */
const once = (scenarios) => scenarios.map(([claim, body, where = ONCE, how]) => [claim, body, where, how]);
/** @param {Scenario[]} scenarios @returns {Scenario[]} */
const rarely = (scenarios) => once(scenarios).map(([claim, body, where]) => [claim, body, where, RARELY]);
/** A whole visit in a few minutes. @type {Scenario[]} */
export const MAIN_SCENARIOS = [
  ['opens without a complaint, and draws', async (visit) => {
    visit.page = await PageDriver.open(visit.browser, visit.address);
    visit.figures['open to first frame, ms'] = await visit.page.call('mark', () =>
      Math.round(performance.getEntriesByName('gaitsmith-first-frame')[0].startTime));
    await sleep(500);
    const { spread } = await visit.page.stage();
    assert.ok(spread > 10, `the stage is blank: spread ${spread}`);
    assert.deepEqual(visit.page.complaints, []);
  }],
  ['what comes until the first motion is 450 KB at most, compressed', async (visit) => {
    const { gzip, files } = await bytesUntilFirstMotion(visit.browser, visit.address);
    visit.figures['first load, gzip (KB)'] = Math.round(gzip / 1000);
    assert.ok(gzip <= 450_000, `${gzip} bytes: ${JSON.stringify(files, null, 1)}`);
    assert.equal(files['/app/app_rest.wasm'], undefined, 'the door needs nothing of the rest (shell/host/later.txt)');
  }, 'Chromium'],

  ['a click on Synthesize starts a search, and the best improves', async (visit) => {
    const { page } = visit;
    await page.page.evaluate((evaluations) => {
      const document = window.gaitsmith.document();
      window.gaitsmith.open({ ...document, hash: undefined, search: { seed: 5, evaluations } });
      const bests = /** @type {number[]} */ ([]);
      Object.assign(window, { testBests: bests });
      window.gaitsmith.on('progress', ({ detail }) => bests.push(detail.bestFitness));
    }, EVALUATIONS);
    await page.click('panels/3');
    await watchFrames(page);
    await page.click('search/start');
    await page.until('a search', () => /** @type {any} */ (window).testBests.length > 2);
    assert.match(await page.status(), /Searching with SPHC/);
    await page.until('the end', () => document.querySelector('#status')?.textContent?.startsWith('Search done') ?? false);
    const stall = await longestFrame(page);
    visit.figures['longest gap between frames while searching, ms'] = stall;
    assert.ok(stall < 1500, `the page stood still for ${stall} ms`);
    const bests = await page.call('bests', () =>
      /** @type {number[]} */ (/** @type {any} */ (window).testBests).filter((best) => Number.isFinite(best)));
    assert.ok(bests[bests.length - 1] > bests[0], `best stayed at ${bests[0]}`);
    visit.found.physical = await page.hash();
  }],

  ['the found motion moves on the stage', async ({ page }) => {
    await page.play(true);
    const before = await page.stage();
    for (const start = Date.now(); (await page.stage()).sum === before.sum; await sleep(100))
      assert.ok(Date.now() - start < PATIENCE_MS, 'it does not move');
    await page.play(false);
    // On a slow machine frames of the moving figure may come after the answer.
    for (const start = Date.now(); (await page.stage()).sum !== (await page.stage()).sum; await sleep(100))
      assert.ok(Date.now() - start < PATIENCE_MS, 'a paused motion does not stand still');
  }],

  ['the timer, chosen by a click, gives another search and another motion', async (visit) => {
    const { page } = visit;
    await page.click('panels/1');
    await page.click('controller/senses/0');
    await page.until('the timer', () => window.gaitsmith.document().senses?.kind === 'timer');
    await page.click('panels/3');
    const before = await page.hash();
    await page.page.evaluate(() => window.gaitsmith.on('done', () => Object.assign(window, { testDone: true })));
    await page.click('search/start');
    await page.until('the end', () => /** @type {any} */ (window).testDone === true);
    visit.found.timer = await page.hash();
    assert.notEqual(visit.found.timer, before);
  }],

  ['Copy link puts the link on the clipboard, or in a box to copy from', async (visit) => {
    const { page } = visit;
    await page.clickElement('#copy-link');
    const boxed = await page.call('box', () => document.querySelector('textarea#link-text')?.closest('dialog')?.open);
    if (boxed) {
      visit.link = await page.call('link', () => /** @type {HTMLTextAreaElement} */ (document.querySelector('#link-text')).value);
      await page.clickElement('#link-dialog button');
    } else {
      assert.equal(await page.call('toast', () => document.querySelector('#toast')?.textContent), 'Link copied');
      // Read the clipboard like a person: paste it into a text box.
      await page.page.evaluate(() => addEventListener('paste', (event) =>
        Object.assign(window, { testPasted: event.clipboardData?.getData('text/plain') }), { capture: true, once: true }));
      await page.clickElement('#open');
      await page.page.keyboard.down('Control');
      await page.page.keyboard.press('v');
      await page.page.keyboard.up('Control');
      await sleep(300);
      visit.link = await page.call('pasted', () => /** @type {any} */ (window).testPasted);
      await page.call('closed', () => document.querySelector('dialog')?.close());
    }
    visit.figures['copied by'] = boxed ? 'box' : 'clipboard';
    assert.equal(visit.link, await page.link());
    assert.ok(visit.link.length < 1000, `${visit.link.length} characters`);
    assert.equal(await page.hash(), visit.found.timer);
  }],

  ['the link shows the same motion, bit for bit, in a fresh profile and natively', async (visit) => {
    const fresh = await PageDriver.open(visit.browser, visit.link);
    assert.equal(await fresh.hash(), visit.found.timer);
    assert.deepEqual(fresh.complaints, []);
    await fresh.close();
    const native = await nativeHash(visit.link);
    visit.figures['native hash of the link'] = native ?? 'not compared: the command line is not built';
    if (native) assert.equal(native, visit.found.timer);
  }],

  ['the address follows the document at rest', async ({ page }) => {
    await page.until('the address', () => location.href === window.gaitsmith.link());
  }],

  ['one worker and two find the same motion', async (visit) => {
    const { page } = visit;
    const hashes = [];
    for (const workers of [1, 2]) {
      hashes.push(await page.page.evaluate(async (options) => (await window.gaitsmith.synthesize(options)).hash,
        /** @type {const} */ ({ seed: 9, evaluations: EVALUATIONS, sense: 'physical', workers })));
    }
    assert.equal(hashes[0], hashes[1]);
    visit.found.workers = hashes[0];
  }],

  ['a search that another one replaces is stopped, and each tells its own end', async ({ page, found }) => {
    const [first, second] = await page.page.evaluate(async (evaluations) => {
      const { gaitsmith } = window;
      const long = gaitsmith.synthesize({ seed: 4, evaluations: 1000000, sense: 'physical', workers: 2 });
      await new Promise((resolve) => setTimeout(resolve, 700));
      const short = gaitsmith.synthesize({ seed: 9, evaluations, sense: 'physical', workers: 2 });
      const { report } = await long;
      const { report: { state, budget }, hash } = await short;
      return [{ state: report.state, budget: report.budget }, { state, budget, hash }];
    }, EVALUATIONS);
    assert.equal(first.state, 'stopped');
    assert.notEqual(first.budget, EVALUATIONS);
    assert.deepEqual(second, { state: 'done', budget: EVALUATIONS, hash: found.workers });
  }],

  ['a terminated evaluator is replaced, the status line says so, and nothing is lost', async (visit) => {
    await dieOnTheWay(visit, -1, /worker stopped/);
  }],

  ['a terminated coordinator is replaced, the status line says so, and nothing is lost', async (visit) => {
    await dieOnTheWay(visit, -3, /coordinator of the search stopped/);
  }],

  ['a damaged link says what is wrong and leaves the work alone', damagedLink],

  ['the motion is described in words', async ({ page }) => {
    await page.forward(50);
    await page.page.focus('#describe');
    assert.ok(await page.call('seen', () => {
      const box = document.querySelector('#describe')?.getBoundingClientRect();
      return box !== undefined && box.width > 20 && box.height > 20;
    }), 'a focused control must be visible');
    await page.page.keyboard.press('Enter');
    await page.frames();
    assert.match(await page.call('text', () => document.querySelector('#description')?.textContent ?? ''), / m to the (left|right) in .* s\. It makes /);
    await page.page.focus('#open');
  }],

  ...STYLE_SCENARIOS,
];

/** @type {Scenario[]} */
export const SCENARIOS = [
  ...MAIN_SCENARIOS,
  ...once(LAB_SCENARIOS),
  ...once(FRONT_SCENARIOS),
  ...rarely(HINT_SCENARIOS),
  ...once(HISTORY_SCENARIOS),
  ...once(KEPT_WORK_SCENARIOS),
  ...once(PALETTE_SCENARIOS),
  ...once(QUEUE_SCENARIOS),
  ...once(TIMELINE_SCENARIOS),
  ...once(OFFLINE_SCENARIOS),
  ...rarely(STORED_SCENARIOS),
  ...SECURITY_SCENARIOS,
  ...rarely(MESSAGE_SCENARIOS),
  ...rarely(FAULT_SCENARIOS),
  ...rarely(OUTAGE_SCENARIOS),
  ...once(FIRST_SCREEN_SCENARIOS),
  ...GRAPHICS_SCENARIOS,
  ...once(SHARE_SCENARIOS),
  ...rarely(SUITE_SCENARIOS),
  ...once(MIRROR_SCENARIOS),
  ...rarely(LOOP_SCENARIOS),
  ...once(AXE_SCENARIOS),
  ...once(WORLD_SCENARIOS),
  ...once(EXPORT_SCENARIOS),
  ...once(FIGURE_SCENARIOS),
  ...once(GALLERY_SCENARIOS),
  ...once(BREED_SCENARIOS),
  ...once([...BEFORE_AFTER_SCENARIOS, ...CLASSROOM_SCENARIOS, ...EXPLORABLE_SCENARIOS, ...TEACH_SCENARIOS]),
  ...rarely([...LEARNING_SCENARIOS, ...NEW_LESSON_SCENARIOS]),
  ...once(REST_SCENARIOS),
  ...once(LIVE_SCENARIOS),
  ...once(RULE_SCENARIOS),
  ...rarely(WALK_SCENARIOS),
  ...once(FINGER_SCENARIOS),
  ...once(THEME_SCENARIOS),
  ...once(TYPING_SCENARIOS),
  ...once(DOOR_SCENARIOS),
  ...once(NEWCOMER_SCENARIOS),
  ...once(VIEWER_SCENARIOS),
  ...once(TOUR_SCENARIOS),
  ...once(LANGUAGE_SCENARIOS),

  ['Undo waits until there is something to undo', async ({ browser, address }) => {
    const fresh = await PageDriver.open(browser, address);
    const undo = () => fresh.call('undo', () => document.querySelector('#undo')?.getAttribute('aria-disabled') === 'true');
    assert.equal(await undo(), true);
    const before = await fresh.hash();
    await fresh.call('open', () => {
      const document = window.gaitsmith.document();
      window.gaitsmith.open({ ...document, hash: undefined, environment: { friction: 0.2 } });
    });
    assert.notEqual(await fresh.hash(), before);
    assert.equal(await undo(), false);
    await fresh.clickElement('#undo');
    assert.equal(await fresh.hash(), before);
    assert.deepEqual(fresh.complaints, []);
    await fresh.close();
  }],

  ['a motion that differs from the one its maker saw says so, as long as it is shown', async ({ browser, address }) => {
    const text = await readFile(join(ROOT, 'tests/golden/motions/star-man-physical.json'), 'utf8');
    const altered = JSON.stringify({ ...JSON.parse(text), hash: '0123456789abcdef' });
    const fresh = await PageDriver.open(browser, address);
    const note = async () => (await fresh.widgets()).find(({ id }) => id === 'stage/note')?.label;
    const show = async (/** @type {string} */ json) => {
      await fresh.page.evaluate((content) => window.gaitsmith.open(content), json);
      await fresh.frames(6);
    };
    await show(altered);
    const link = await fresh.link();
    assert.match(await note() ?? '', /differs from the one its maker saw/);
    assert.match(await fresh.status(), /differs from the one its maker saw: hash [0-9a-f]{16} here, 0123456789abcdef there/);
    await fresh.click('panels/1');
    assert.ok(await note(), 'the note must stay while the motion is the same');
    await show(text);
    assert.equal(await note(), undefined);
    assert.match(await fresh.status(), /^Opened /);
    await fresh.until('the address at rest', () => location.href === window.gaitsmith.link());
    await fresh.page.evaluate((hash) => { location.hash = hash; }, link.slice(link.indexOf('#')));
    await fresh.frames(6);
    assert.match(await note() ?? '', /differs from the one its maker saw/);
    await sleep(1500);
    assert.equal(await fresh.call('address', () => location.href), link, 'the maker\'s hash must stay in the address');
    await fresh.close();
  }],

  ['the whole visit passed without a complaint', async ({ page }) => {
    assert.deepEqual(page.complaints, []);
    await page.close();
  }],
];

/**
 * Terminates a worker after a third of a search with two evaluators. The hash must be that of the undisturbed search.
 * @param {Visit} visit @param {number} which  of [coordinator, evaluator, evaluator], from the end
 * @param {RegExp} sentence
 */
async function dieOnTheWay({ page, found }, which, sentence) {
  const hash = page.page.evaluate(async (evaluations) => {
    const { gaitsmith } = window;
    const lines = /** @type {string[]} */ ([]);
    const status = /** @type {Element} */ (document.querySelector('#status'));
    new MutationObserver(() => lines.push(status.textContent ?? '')).observe(status, { childList: true });
    Object.assign(window, { testSaid: lines, testEvaluations: 0 });
    gaitsmith.on('progress', ({ detail }) => Object.assign(window, { testEvaluations: detail.evaluations }));
    return (await gaitsmith.synthesize({ seed: 9, evaluations, sense: 'physical', workers: 2 })).hash;
  }, EVALUATIONS);
  await page.until('a third', () => /** @type {any} */ (window).testEvaluations > 400);
  await page.terminateWorker(which);
  assert.equal(await hash, found.workers);
  assert.match((await page.call('said', () => /** @type {any} */ (window).testSaid)).join('\n'), sentence);
}

/** Starts measuring pauses of the page's thread. @param {PageDriver} page */
async function watchFrames(page) {
  await page.page.evaluate(() => {
    let last = performance.now();
    Object.assign(window, { testLongest: 0 });
    const look = () => {
      const now = performance.now();
      const state = /** @type {any} */ (window);
      if (state.testLongest === undefined) return;
      state.testLongest = Math.max(state.testLongest, now - last);
      last = now;
      requestAnimationFrame(look);
    };
    requestAnimationFrame(look);
  });
}

/** @param {PageDriver} page @returns {Promise<number>} ms */
function longestFrame(page) {
  return page.call('frames', () => {
    const state = /** @type {any} */ (window);
    const longest = Math.round(state.testLongest);
    state.testLongest = undefined;
    return longest;
  });
}
