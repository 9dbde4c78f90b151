// SPDX-License-Identifier: MIT
// Work that the browser stores between visits and tabs. Each scenario opens its own profiles.
import assert from 'node:assert/strict';
import { stateOf } from './history.mjs';
import { ONCE, PageDriver, RARELY, sleep } from '../page_driver.mjs';

/** @typedef {import('./all.mjs').Visit} Visit */

/** Changes the document. @param {PageDriver} page @param {string} title */
const work = (page, title) => page.page.evaluate((name) => {
  const document = window.gaitsmith.document();
  window.gaitsmith.open({ ...document, hash: undefined, title: name, environment: { friction: 0.1 + name.length / 100 } });
}, title);

/** @param {PageDriver} page @returns {Promise<string>} */
const title = (page) => page.call('title', () => window.gaitsmith.document().title ?? '');

/** Whether the line about the last work is visible. @param {PageDriver} page */
const offered = (page) => page.call('line', () => !document.querySelector('#kept')?.hasAttribute('hidden'));

/** Sends 'pagehide' to the page. @param {PageDriver} page @returns {Promise<number>} the number of stored works */
const leave = (page) => page.call('leave', () => {
  dispatchEvent(new Event('pagehide'));
  return Object.keys(localStorage).filter((key) => key.startsWith('gaitsmith-work/')).length;
});

/** Leaves the page like a person, so that it receives 'pagehide'. @param {PageDriver} page @param {string} address */
const leaveFor = (page, address) => page.arrive(() => page.page.goto(address));

/** @param {Visit} visit */
async function reloadRestores({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  await work(page, 'Taken back');
  assert.equal(await leave(page), 1);
  await page.call('undo', () => window.gaitsmith.undo());
  assert.equal(await leave(page), 0, 'what was undone is not kept');
  await work(page, 'First');
  await page.reload();
  await work(page, 'Before the reload');
  const state = await stateOf(page);
  await page.reload(); // at once, before the timers of address and storage
  assert.equal(await stateOf(page), state);
  assert.equal(await leave(page), 1, 'a reload goes on with the same work');
  await page.call('undo', () => window.gaitsmith.undo());
  assert.equal(await title(page), 'First', 'Undo reaches back over the reload');
  await page.reload();
  await page.call('redo', () => window.gaitsmith.redo());
  assert.equal(await stateOf(page), state, 'Redo, too');
  await page.page.goto('about:blank');
  // Another tab, with the plain address, as after a crash or a closed tab.
  const next = await PageDriver.open(browser, address, { beside: page });
  assert.equal(await stateOf(next), state);
  assert.match(await next.status(), /^Restored your last work: Before the reload/);
  assert.equal(await offered(next), false);
  assert.deepEqual([page.complaints, next.complaints], [[], []]);
  await page.close();
}

/** The titles of the waiting searches. @param {PageDriver} page */
const queue = (page) => page.call('queue', () => window.gaitsmith.queue().map(({ title, seed }) => `${title}, ${seed}`));

/** @param {Visit} visit */
async function reloadKeepsQueue({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  await page.call('queue', () => { for (const seed of [5, 6, 7]) window.gaitsmith.enqueue({ seed, evaluations: 1000000 }); });
  const waiting = await queue(page);
  assert.equal(waiting.length, 3);
  await page.reload();
  assert.deepEqual(await queue(page), waiting);
  assert.match(await page.status(), /^3 searches wait until you press Run queue/);
  await page.call('run', () => window.gaitsmith.run('queue/run'));
  assert.equal((await queue(page)).length, 2, 'one runs');
  await page.reload();
  assert.deepEqual(await queue(page), waiting, 'a search that ran waits again');

  // Damaged data is ignored as a whole. A link to another document does not bring the queue along.
  const damaged = ['', 'null', '{}', '[1]', '{"undo":["AA"],"redo":[],"queue":[]}', '{"undo":[],"redo":[],"queue":[7]}', '{"undo":[]'];
  for (const visit of [...damaged, 7, null]) {
    // The page stores its state when it is left, so the damage comes after that.
    await page.page.evaluate((text) => addEventListener('pagehide', () => {
      const state = JSON.parse(sessionStorage.getItem('gaitsmith-here') ?? '{}');
      if (state.visit === text) throw new Error('not damaged');
      sessionStorage.setItem('gaitsmith-here', JSON.stringify({ ...state, visit: text }));
    }), visit);
    await page.reload();
    assert.deepEqual(await queue(page), [], String(visit));
    assert.equal(await page.call('undo', () => window.gaitsmith.canUndo()), false);
    await page.call('queue', () => { window.gaitsmith.enqueue({ seed: 5 }); });
  }
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** Firefox does so if the page replaces its address in the moment of the reload. @param {Visit} visit */
async function reloadWithOldAddress({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  await work(page, 'First');
  await page.until('its address', () => location.hash.length > 1 && location.href === window.gaitsmith.link());
  const old = await page.call('address', () => location.href);
  await work(page, 'Then another');
  const state = await stateOf(page);
  await page.until('its address', () => location.href === window.gaitsmith.link());
  await page.page.evaluate((href) => { history.replaceState(null, '', href); }, old);
  await page.reload();
  assert.equal(await stateOf(page), state);
  await page.until('its address again', () => location.href === window.gaitsmith.link());
  assert.equal(await leave(page), 1);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function reloadMidSearch({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  const before = await page.hash();
  await page.call('search', () => {
    const seen = Object.assign(window, { testBest: -Infinity, testPaused: false });
    window.gaitsmith.on('progress', ({ detail }) => Object.assign(seen, { testBest: detail.bestFitness, testPaused: detail.state === 'paused' }));
    void window.gaitsmith.synthesize({ seed: 4, evaluations: 1000000, sense: 'physical', workers: 1 });
  });
  await page.until('a better motion', () => /** @type {any} */ (window).testBest > -Infinity && window.gaitsmith.canUndo());
  await page.call('pause', () => window.gaitsmith.pause());
  // On a busy machine the last improvement comes to the stage long after the press.
  await page.until('the best motion on the stage', () => {
    const { testBest, testPaused } = /** @type {any} */ (window);
    const { travel, slip_sum: slip } = /** @type {Record<string, number>} */ (window.gaitsmith.measures());
    return testPaused && Math.abs(travel + 0.5 * slip - testBest) < 2e-6 * Math.abs(testBest); // single precision: the last two may be nearly as good
  });
  const state = await stateOf(page);
  assert.notEqual(await page.hash(), before);
  assert.notEqual(await page.call('address', () => location.href), await page.link(), 'the address must not follow a search');
  await page.reload();
  assert.equal(await stateOf(page), state);
  await page.until('the address', () => location.hash === '' || location.href === window.gaitsmith.link());
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function linkWins({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  await work(page, 'A linked motion');
  const link = await page.link();
  await page.close();

  const mine = await PageDriver.open(browser, address);
  await work(mine, 'Mine');
  const state = await stateOf(mine);
  await leaveFor(mine, `${address}?elsewhere`);
  const other = await PageDriver.open(browser, link, { beside: mine });
  assert.equal(await title(other), 'A linked motion');
  assert.equal(await other.call('address', () => location.href), link);
  assert.equal(await offered(other), true);
  assert.equal(await other.text('#kept-title'), 'Mine');
  await other.clickElement('#kept-open');
  assert.equal(await stateOf(other), state);
  assert.equal(await offered(other), false);
  await other.press('Control+z');
  assert.equal(await title(other), 'A linked motion');

  // If the offer is dismissed, it does not appear again, but the work is still stored. Looking at a link loses nothing.
  const third = await PageDriver.open(browser, link, { beside: mine });
  assert.equal(await offered(third), true);
  await third.clickElement('#kept-close');
  assert.equal(await offered(third), false);
  const fourth = await PageDriver.open(browser, link, { beside: mine });
  assert.equal(await offered(fourth), false);
  await fourth.openPalette();
  await fourth.page.keyboard.type('kept mine');
  await fourth.press('Enter');
  assert.equal(await stateOf(fourth), state);
  for (const { complaints } of [mine, other, third, fourth]) assert.deepEqual(complaints, []);
  await mine.close();
}

/** @param {Visit} visit */
async function twoTabs({ browser, address }) {
  const one = await PageDriver.open(browser, address);
  const two = await PageDriver.open(browser, address, { beside: one });
  await work(one, 'Tab one');
  await work(two, 'The second tab');
  await two.reload();
  await one.page.bringToFront();
  assert.equal(await title(one), 'Tab one');
  await one.reload();
  assert.equal(await title(one), 'Tab one');
  assert.equal(await title(two), 'The second tab');
  await two.page.bringToFront();
  await work(two, 'The second tab, later');
  await two.reload();
  const three = await PageDriver.open(browser, address, { beside: one });
  assert.equal(await title(three), 'The second tab, later');
  await one.close();
}

/** @param {Visit} visit */
async function forbidden({ browser, address }) {
  const page = await PageDriver.open(browser, address, {
    before: () => {
      for (const name of ['localStorage', 'sessionStorage']) {
        Object.defineProperty(window, name, { get() { throw new DOMException('no', 'SecurityError'); } });
      }
    },
  });
  await work(page, 'Not to be kept');
  await page.until('a sentence', () => /does not let the page keep your work/.test(document.querySelector('#status')?.textContent ?? ''));
  await work(page, 'Nor this one');
  assert.match(await page.status(), /^Opened Nor this one/);
  await sleep(2600); // longer than the page waits before it stores
  assert.match(await page.status(), /^Opened Nor this one/, 'said twice');
  await page.page.focus('#save');
  await page.press('Control+z');
  assert.equal(await title(page), 'Not to be kept');
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function full({ browser, address }) {
  const page = await PageDriver.open(browser, address, {
    before: () => { Storage.prototype.setItem = () => { throw new DOMException('full', 'QuotaExceededError'); }; },
  });
  await work(page, 'No room');
  await page.until('a sentence', () => /does not let the page keep your work/.test(document.querySelector('#status')?.textContent ?? ''));
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function embedded({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  await page.call('frame', async () => {
    const frame = document.createElement('iframe');
    frame.src = location.pathname;
    document.body.append(frame);
    await new Promise((resolve) => frame.addEventListener('load', resolve));
    const { gaitsmith } = /** @type {Window} */ (frame.contentWindow);
    await gaitsmith.ready;
    gaitsmith.open({ ...gaitsmith.document(), hash: undefined, title: 'Inside' });
    gaitsmith.enqueue({ seed: 5 });
    frame.contentWindow?.dispatchEvent(new Event('pagehide'));
  });
  await sleep(2600);
  assert.deepEqual(await page.call('works', () => Object.keys(localStorage).filter((key) => key.startsWith('gaitsmith-work'))), []);
  const frame = page.page.frames().at(-1);
  assert.equal(await frame?.evaluate(() => sessionStorage.getItem('gaitsmith-here')), await page.call('tab', () => sessionStorage.getItem('gaitsmith-here')));
  assert.doesNotMatch(await page.call('tab', () => sessionStorage.getItem('gaitsmith-here') ?? ''), /"queue\\":\[\\"/);
  await page.close();
}

/** @param {Visit} visit */
async function tabKilled({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  await work(page, 'Before the crash');
  const state = await stateOf(page);
  await sleep(2600); // the timer stores it, because a crash sends no event
  void page.page.goto('chrome://crash').catch(() => {});
  await sleep(1000);
  const next = await PageDriver.open(browser, address, { beside: page });
  assert.equal(await stateOf(next), state);
  assert.match(await next.status(), /^Restored your last work: Before the crash/);
  assert.deepEqual(next.complaints, []);
  await next.close();
}

/** @param {Visit} visit */
async function graphicsLost({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  await work(page, 'Before the loss');
  const state = await stateOf(page);
  await page.call('loss', () => {
    const canvas = document.querySelector('canvas');
    const context = canvas?.getContext('webgl2') ?? canvas?.getContext('webgl');
    context?.getExtension('WEBGL_lose_context')?.loseContext();
  });
  await page.until('a word about it', () => /graphics of this page were lost/.test(document.body.innerText));
  await page.reload();
  assert.equal(await stateOf(page), state);
  await page.frames(4);
  assert.ok((await page.stage()).spread > 10, 'drawn again');
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @type {import('./all.mjs').Scenario[]} */
export const KEPT_WORK_SCENARIOS = [
  ['a reload brings back the work, and so does the bare address in another tab', reloadRestores],
  ['a reload brings back the queue, and ignores a damaged one', reloadKeepsQueue, ONCE, RARELY],
  ['a reload with the address of a moment ago brings back the work, too', reloadWithOldAddress],
  ['a reload in the middle of a search brings back the best so far', reloadMidSearch, ONCE, RARELY],
  ['a link in the address wins, and the last work is one press away until dismissed', linkWins],
  ['two tabs keep their own work, and the next visit begins with the later one', twoTabs],
  ['forbidden storage is reported once, and all else works', forbidden],
  ['where storage is full, it is said', full, ONCE, RARELY],
  ['inside another page nothing is kept', embedded, ONCE, RARELY],
  ['a tab that is killed loses nothing', tabKilled, 'Chromium'], // Firefox has no way to kill a tab
  ['where the graphics are lost the page says so, and a reload goes on', graphicsLost, ONCE, RARELY],
];
