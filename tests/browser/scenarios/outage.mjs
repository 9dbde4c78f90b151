// SPDX-License-Identifier: MIT
// Events during a search: lost graphics, a frozen tab, jumping clocks, other tabs, storage that is full or cleared, a
// new version.
import assert from 'node:assert/strict';
import { cp, mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { execFile } from 'node:child_process';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { promisify } from 'node:util';
import { ROOT } from '../browsers.mjs';
import { countWorkers, liveWorkers, openFaulty } from '../faulty_site.mjs';
import { same, stateOf } from './history.mjs';
import { PageDriver, sleep } from '../page_driver.mjs';
import { PlainServer } from '../plain_server.mjs';

/** @typedef {import('./all.mjs').Visit} Visit */

const SITE = process.argv[2] ?? join(ROOT, 'build/site');
const SEARCH = { seed: 9, evaluations: 10000, sense: 'physical', workers: 2 };

/** Starts a search and waits for its middle. ended() waits for its end. @param {PageDriver} page @param {object} [options] */
async function begin(page, options = {}) {
  await page.page.evaluate((wish) => {
    const state = Object.assign(window, { testEnd: '', testEvaluations: 0 });
    window.gaitsmith.on('progress', ({ detail }) => { state.testEvaluations = detail.evaluations; });
    void window.gaitsmith.synthesize(wish).then(({ hash }) => { state.testEnd = hash; }, (error) => { state.testEnd = String(error); });
  }, /** @type {any} */ ({ ...SEARCH, ...options }));
  await page.until('its middle', () => /** @type {any} */ (window).testEvaluations > 400);
  assert.equal(await page.call('end', () => /** @type {any} */ (window).testEnd), '', 'too soon at its end for this test');
}

/** @param {PageDriver} page @returns {Promise<string>} the hash of the found motion */
async function ended(page) {
  await page.until('the end', () => /** @type {any} */ (window).testEnd !== '');
  return page.call('end', () => /** @type {any} */ (window).testEnd);
}

/** The result of an undisturbed search. @type {Promise<string> | null} */
let undisturbed = null;
/** @param {Visit} visit */
function expected({ browser, address }) {
  undisturbed ??= (async () => {
    const page = await PageDriver.open(browser, address);
    await begin(page);
    const hash = await ended(page);
    await page.close();
    return hash;
  })();
  return undisturbed;
}

/** The state when nothing changes it any more: after a search the page shows its last improvements. @param {PageDriver} page */
async function stateAtRest(page) {
  let state = '';
  for (let turn = 0, now = await stateOf(page); now !== state; turn++, now = await stateOf(page)) {
    assert.ok(turn < 20, 'the document never rests');
    state = now;
    await sleep(1500);
  }
  return state;
}

/** @param {Visit} visit */
async function graphicsLost(visit) {
  const page = await PageDriver.open(visit.browser, visit.address, { before: countWorkers });
  await begin(page);
  await page.page.evaluate(() => {
    const canvas = document.querySelector('canvas');
    const extension = (canvas?.getContext('webgl2') ?? canvas?.getContext('webgl'))?.getExtension('WEBGL_lose_context');
    Object.assign(window, { testGraphics: extension });
    extension?.loseContext();
  });
  await page.until('a word about it', () => /graphics of this page were lost/.test(document.querySelector('#banner-text')?.textContent ?? ''));
  const hash = await expected(visit);
  await page.page.bringToFront();
  assert.equal(await ended(page), hash, 'the search ends right');
  const state = await stateAtRest(page);
  await page.page.evaluate(() => { /** @type {any} */ (window).testGraphics.restoreContext(); });
  await page.reload();
  same(await stateOf(page), state, 'after a reload');
  assert.ok((await page.stage()).spread > 10, 'drawn again');
  await begin(page);
  assert.equal(await ended(page), hash, 'a search there');
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** Sets all clocks of page and workers ahead. @param {PageDriver} page @param {number} ms */
const jump = (page, ms) => page.page.evaluate((jumpMs) => {
  for (const clock of [Date, performance]) {
    const now = clock.now.bind(clock);
    clock.now = () => now() + jumpMs;
  }
  new BroadcastChannel('faults').postMessage({ jumpMs });
}, ms);

/** @param {Visit} visit */
async function clocks(visit) {
  const hash = await expected(visit);
  const page = await openFaulty(visit.browser);
  for (const hours of [1, -2]) {
    await begin(page);
    await jump(page, 3600e3 * hours);
    assert.equal(await ended(page), hash, `${hours} h`);
    assert.match(await page.status(), /^Search done/);
    // Pause and resume use clocks, too.
    await begin(page, { evaluations: 6000 });
    await page.call('pause', () => { window.gaitsmith.pause(); });
    await page.until('a pause', () => /^Paused/.test(document.querySelector('#status')?.textContent ?? ''));
    await jump(page, -3600e3 * hours);
    await page.call('resume', () => { window.gaitsmith.resume(); });
    await ended(page);
    assert.match(await page.status(), /after 6,000 tries/, `${hours} h, paused`);
  }
  assert.ok(await liveWorkers(page) <= 3);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function frozen(visit) {
  const hash = await expected(visit);
  const page = await openFaulty(visit.browser);
  const statusLines = () => page.call('said', () => /** @type {any} */ (window).testSaid.join('\n'));
  await begin(page, { evaluations: 20000 });
  await page.page.evaluate(() => {
    const lines = /** @type {string[]} */ ([]);
    const status = /** @type {Element} */ (document.querySelector('#status'));
    new MutationObserver(() => lines.push(status.textContent ?? '')).observe(status, { childList: true, characterData: true, subtree: true });
    Object.assign(window, { testSaid: lines });
  });
  const session = await page.page.createCDPSession();
  await session.send('Page.setWebLifecycleState', { state: 'frozen' });
  await sleep(6500); // longer than any timeout of a search
  await session.send('Page.setWebLifecycleState', { state: 'active' });
  await jump(page, 3600e3);
  await ended(page);
  assert.doesNotMatch(await statusLines(), /stopped/, 'nobody is taken for dead');
  await begin(page);
  assert.equal(await ended(page), hash, 'and searches find what they found');
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function twoTabs(visit) {
  const hash = await expected(visit);
  const one = await PageDriver.open(visit.browser, visit.address);
  const two = await PageDriver.open(visit.browser, visit.address, { beside: one });
  await begin(two, { evaluations: 15000 });
  await one.page.bringToFront();
  await begin(one);
  const [first, second] = [await ended(one), await ended(two)];
  assert.equal(first, hash);
  // The storage is cleared during the next search, as a person could do.
  await begin(one, { seed: 10 });
  await two.page.evaluate(() => { localStorage.clear(); });
  const third = await ended(one);
  const state = await stateOf(one);
  await one.reload();
  same(await stateOf(one), state, 'the first tab');
  const results = await one.call('results', () => window.gaitsmith.results().map((result) => result.hash));
  assert.ok(results.includes(third), 'what was found after it is kept');
  await two.page.bringToFront();
  assert.equal(await two.hash(), second);
  assert.deepEqual([one.complaints, two.complaints], [[], []]);
  await one.close();
}

/** @param {Visit} visit */
async function storageFills(visit) {
  const hash = await expected(visit);
  const page = await PageDriver.open(visit.browser, visit.address);
  await begin(page);
  const room = await page.call('fill', () => {
    let size = 1 << 20;
    for (let i = 0; size > 0; i++) {
      try {
        localStorage.setItem(`full-${i}`, 'x'.repeat(size));
      } catch {
        size >>= 1;
      }
    }
    return Object.values(localStorage).join('').length;
  });
  assert.ok(room > 2e6, `the storage is full with ${room} characters`);
  assert.equal(await ended(page), hash);
  await page.until('a word about it', () => /no room for more results|does not let the page keep your work/.test(document.querySelector('#status')?.textContent ?? ''));
  await page.until('the address', () => location.href === window.gaitsmith.link());
  assert.equal((await page.call('results', () => window.gaitsmith.results())).length, 1);
  const state = await stateOf(page);
  await page.reload();
  assert.ok(await stateOf(page) === state, 'the address has it');
  await page.call('room', () => { localStorage.clear(); });
  await begin(page, { seed: 11 });
  await ended(page);
  await page.reload();
  assert.equal((await page.call('results', () => window.gaitsmith.results())).length, 1, 'there is room again');
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** The browser has no room to store the site. @param {Visit} visit */
async function quota(visit) {
  const hash = await expected(visit);
  await onCopy(async (server) => {
    const context = await visit.browser.createBrowserContext();
    const blank = await context.newPage();
    const session = await blank.createCDPSession();
    await blank.goto(`${server.address()}page/naming.js`);
    await session.send('Storage.overrideQuotaForOrigin', { origin: new URL(server.address()).origin, quotaSize: 1000 });
    const page = await PageDriver.open(visit.browser, `${server.address()}?open=star-man-shuffle`, { beside: new PageDriver(blank) });
    await begin(page);
    assert.equal(await ended(page), hash);
    const state = await page.call('worker', async () => {
      const registration = await navigator.serviceWorker.getRegistration();
      const coming = registration?.installing;
      if (coming) await new Promise((resolve) => coming.addEventListener('statechange', resolve, { once: true }));
      return registration?.active?.state ?? 'none';
    });
    assert.equal(state, 'none', 'half a copy is none');
    await page.reload();
    assert.equal(await page.hash(), hash);
    assert.deepEqual(page.complaints, []);
    await page.close();
  });
}

/** @param {(server: PlainServer) => Promise<void>} body */
async function onCopy(body) {
  const folder = await mkdtemp(join(tmpdir(), 'site-'));
  await cp(SITE, folder, { recursive: true });
  const server = new PlainServer(folder, '/');
  await server.start();
  try {
    await body(server);
  } finally {
    server.close();
    await rm(folder, { recursive: true });
  }
}

/** @param {Visit} visit */
async function newVersion(visit) {
  const hash = await expected(visit);
  await onCopy(async (server) => {
    const page = await PageDriver.open(visit.browser, server.address());
    await page.until('the service worker', `(async () => (await navigator.serviceWorker.ready).active?.state === 'activated')()`);
    await page.reload(); // now through the service worker
    for (const script of ['search/worker.js', 'page/page.js']) {
      const path = join(server.folder, script);
      await writeFile(path, `${await readFile(path, 'utf8')}\nself.testNew = true;\n`);
    }
    await promisify(execFile)(process.execPath, [join(ROOT, 'web/build/seal.mjs'), server.folder]);

    await begin(page, { evaluations: 6000 });
    await page.call('update', async () => { await (await navigator.serviceWorker.ready).update(); return true; });
    await page.until('the offer', () => document.querySelector('#update')?.hasAttribute('hidden') === false);
    await ended(page);
    assert.match(await page.status(), /^Search done/, 'a new version stops no search');

    // An update during a search keeps the best motion.
    await begin(page, { seed: 12, evaluations: 1000000 });
    const before = await page.call('undo', () => window.gaitsmith.canUndo());
    assert.equal(before, true);
    await page.call('pause', () => { window.gaitsmith.pause(); });
    await page.until('a pause', () => /^Paused/.test(document.querySelector('#status')?.textContent ?? ''));
    // Wait for the last improvement: until the state no longer changes.
    const best = await stateAtRest(page);
    await page.arrive(() => page.clickElement('#update-go'));
    assert.equal(await page.call('version', () => /** @type {any} */ (window).testNew), true);
    same(await stateOf(page), best, 'the best');
    await begin(page);
    assert.equal(await ended(page), hash);
    await page.close();
  });
}

/** @type {typeof import('./all.mjs').SCENARIOS} */
export const OUTAGE_SCENARIOS = [
  ['graphics lost in the middle of a search: it ends right, and a reload has what it found', graphicsLost],
  ['clocks that jump by hours change nothing in a search, running or paused', clocks],
  ['a tab frozen in the middle of a search goes on when it thaws', frozen, 'Chromium'], // the only one that can be frozen by a test
  ['two tabs search at a time, and storage is emptied meanwhile: each keeps its own', twoTabs],
  ['storage that fills in the middle of a search is reported, and the address has the work', storageFills],
  ['where there is no room for a copy of the site, it works without one', quota, 'Chromium'], // the only one with a quota for tests
  ['a new version that comes in the middle of a search waits, and takes over what was found', newVersion],
];
