// SPDX-License-Identifier: MIT
// Workers, and a page, that die, hang, trap or run out of memory. A search ends correctly or the page reports why, the
// best motion is kept, and the document does not change.
import assert from 'node:assert/strict';
import { countWorkers, expectFaults, liveWorkers, openFaulty } from '../faulty_site.mjs';
import { PageDriver } from '../page_driver.mjs';
import { same } from './history.mjs';

/** @typedef {import('./all.mjs').Visit} Visit */
/** @typedef {import('../worker_faults.mjs').Fault} Fault */

/** The motion and the document, without its view and its search, which Undo does not change. @param {PageDriver} page @returns {Promise<string>} */
const workOf = (page) => page.call('work', () => JSON.stringify([window.gaitsmith.hash(), { ...window.gaitsmith.document(), view: null, search: null }]));

// Long enough for all accidents of a row, whichever worker comes first to its own.
const SEARCH = { seed: 9, evaluations: 12000, sense: /** @type {const} */ ('physical'), workers: 2 };

/** @param {PageDriver} page @param {object} [options] @returns {Promise<{hash: string, error: string}>} how it ends */
const search = (page, options = {}) => page.call('search', `(async () => {
  try {
    return { hash: (await window.gaitsmith.synthesize(${JSON.stringify({ ...SEARCH, ...options })})).hash, error: '' };
  } catch (error) {
    return { hash: window.gaitsmith.hash(), error: String(error) };
  }
})()`);

/** Records all sentences of the status line. @param {PageDriver} page */
const recordStatus = (page) => page.page.evaluate(() => {
  const messages = /** @type {string[]} */ ([]);
  const status = /** @type {Element} */ (document.querySelector('#status'));
  new MutationObserver(() => messages.push(status.textContent ?? '')).observe(status, { childList: true, characterData: true, subtree: true });
  Object.assign(window, { testSaid: messages });
});
/** @param {PageDriver} page @returns {Promise<string>} the sentences since the last call */
const messages = (page) => page.call('said', () => /** @type {any} */ (window).testSaid.splice(0).join('\n'));

/** @param {Partial<Fault> & Pick<Fault, 'act' | 'nth'>} fault */
const inBatch = (fault) => /** @type {Fault} */ ({ id: `${fault.act} ${fault.nth}`, place: 'to-port', type: 'scored', ...fault });
/** @type {[string, Fault[], RegExp[]][]} */
const ACCIDENTS = [
  ['one after another traps or hangs', [inBatch({ act: 'trap', nth: 6 }), inBatch({ type: 'score', act: 'trap', nth: 12, id: 'coordinator' }),
    inBatch({ act: 'hang', nth: 14 }), inBatch({ type: 'score', act: 'hang', nth: 30, id: 'coordinator, again' })],
  [/A search worker stopped/, /coordinator of the search stopped/]],
  ['all die at once', [], [/coordinator of the search stopped/]],
];

/** Kills all workers at the first progress. In the page, because the search may end before a test can react. @param {PageDriver} page */
const killAll = (page) => page.page.evaluate(() => {
  const workers = /** @type {any} */ (window).testWorkers;
  let dead = false;
  window.gaitsmith.on('progress', ({ detail }) => {
    if (dead || detail.evaluations === 0) return;
    dead = true;
    for (const worker of workers) worker.terminate();
  });
});

/** @param {Visit} visit */
async function survived({ browser, name }) {
  const page = await openFaulty(browser);
  const before = await workOf(page);
  const { hash } = await search(page);
  const after = await workOf(page);
  await recordStatus(page);
  for (const [what, faults, sentences] of ACCIDENTS) {
    await page.page.evaluate(() => { window.gaitsmith.undo(); });
    same(await workOf(page), before, `${what}: Undo`);
    await expectFaults(page, faults);
    await messages(page);
    if (faults.length === 0) await killAll(page);
    assert.equal(JSON.stringify(await search(page)), JSON.stringify({ hash, error: '' }), what);
    same(await workOf(page), after, `${what}: the document`);
    const words = await messages(page);
    for (const sentence of sentences) assert.match(words, sentence, what);
    assert.equal(await page.call('left', () => JSON.stringify(/** @type {any} */ (window).testFaults)), '[]', `${what}: what did not happen`);
    assert.ok(await liveWorkers(page) <= 3, `${what}: workers are left`);
  }
  if (name === 'Chromium') assert.deepEqual(page.complaints, []); // Firefox also reports errors in workers
  await page.close();
}

/** @param {Visit} visit */
async function givenUp({ browser }) {
  const page = await openFaulty(browser);
  const { hash } = await search(page);
  await page.page.evaluate(() => { window.gaitsmith.undo(); });
  const before = await workOf(page);

  // After a while every evaluator traps.
  await page.page.evaluate(() => {
    const bests = /** @type {number[]} */ ([]);
    Object.assign(window, { testBests: bests });
    window.gaitsmith.on('progress', ({ detail }) => bests.push(detail.bestFitness));
  });
  await expectFaults(page, [{ id: 'start', place: 'to-port', type: 'scored', nth: 30, act: 'trap', always: true }]);
  const running = search(page, { evaluations: 1000000 });
  await page.until('something found', () => /** @type {any} */ (window).testBests.some((/** @type {number} */ best) => best > 0.5));
  await expectFaults(page, [{ id: 'always', place: 'to-page', type: 'ready', role: 'evaluate', act: 'trap', always: true }]);
  const failed = await running;
  assert.match(failed.error, /stopped too often/);
  assert.match(await page.text('#banner-text'), /^The search failed: the search workers stopped too often.*Its best motion is kept. You can start the search again\.$/);
  assert.equal(await liveWorkers(page), 0);
  assert.ok(await workOf(page) !== before, 'what was found is kept');
  const [result, shown, best] = await page.call('best', () => {
    const bests = /** @type {number[]} */ (/** @type {any} */ (window).testBests);
    return /** @type {const} */ ([window.gaitsmith.results()[0], window.gaitsmith.hash(), Math.max(...bests)]);
  });
  assert.deepEqual([result.origin, result.hash], ['failed', shown]);
  assert.ok(Math.abs((result.score ?? 0) - best) < 1e-5, `${result.score} is kept of ${best}`);
  assert.equal(await page.call('undo', () => window.gaitsmith.undo()), true);
  same(await workOf(page), before, 'after all');

  // A search that always runs out of memory.
  await page.clickElement('#banner-close');
  await expectFaults(page, [{ id: 'memory', place: 'start', act: 'no-memory', always: true }]);
  await page.page.evaluate(() => {
    const { gaitsmith } = window;
    gaitsmith.open({ ...gaitsmith.document(), hash: undefined, search: { algorithm: 'gga', genetic: { population: 10000 }, seed: 3, evaluations: 100000 } });
  });
  const small = await workOf(page);
  const starved = await page.call('search', () => window.gaitsmith.synthesize({ workers: 2 }).then(() => 'found', String));
  assert.match(starved, /not enough memory for this search/);
  assert.match(await page.text('#banner-text'), /^The search failed: there is not enough memory for this search/);
  assert.equal(await liveWorkers(page), 0);
  same(await workOf(page), small, 'nothing was found, nothing changed');

  await expectFaults(page, []);
  await page.page.evaluate(() => { window.gaitsmith.undo(); });
  same(await workOf(page), before, 'after all');
  assert.equal((await search(page)).hash, hash, 'the next search is as ever');
  await page.close();
}

/** @param {Visit} visit */
async function refusedWorkers({ browser, address }) {
  const page = await PageDriver.open(browser, address, { before: countWorkers });
  // Otherwise a slow machine could create them after the fault.
  await page.until('workers that stand by', () => /** @type {any} */ (window).testWorkers.length > 0);
  const before = await workOf(page);
  const error = await page.call('search', async () => {
    const RealWorker = window.Worker;
    let left = 1;
    for (const worker of /** @type {any} */ (window).testWorkers) worker.onerror?.(new ErrorEvent('error'));
    window.Worker = class extends RealWorker {
      /** @param {string | URL} url @param {WorkerOptions} [options] */
      constructor(url, options) {
        if (left-- === 0) throw new DOMException('no more workers', 'QuotaExceededError');
        super(url, options);
      }
    };
    const end = await window.gaitsmith.synthesize({ evaluations: 500, workers: 2 }).then(() => '', String);
    window.Worker = RealWorker;
    return end;
  });
  assert.match(error, /no more workers/);
  assert.match(await page.text('#banner-text'), /no more workers/);
  assert.equal(await liveWorkers(page), 0);
  same(await workOf(page), before, 'after all');
  assert.equal((await search(page)).error, '');
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function pageMemory({ browser, address }) {
  const page = await PageDriver.open(browser, address, { before: countWorkers });
  const before = await workOf(page);
  const faults = await page.call('open', () => {
    const { grow } = WebAssembly.Memory.prototype;
    WebAssembly.Memory.prototype.grow = () => { throw new RangeError('WebAssembly.Memory.grow(): out of memory'); };
    const outcomes = /** @type {string[]} */ ([]);
    for (const text of [`{"title": "${'a'.repeat(200e6)}"}`]) {
      try {
        window.gaitsmith.open(text);
        outcomes.push('opened');
      } catch (error) {
        outcomes.push(String(error));
      }
    }
    WebAssembly.Memory.prototype.grow = grow;
    return outcomes;
  });
  assert.match(faults[0], /not enough memory left in this page/);
  same(await workOf(page), before, 'after all');
  assert.equal((await search(page)).error, '');
  assert.ok(await workOf(page) !== before);
  await page.close();
}

/** The application traps, as it would because of a bug. @param {Visit} visit */
async function pageTraps({ browser, address }) {
  const page = await PageDriver.open(browser, address, { before: () => {
    const live = new Set();
    const RealWorker = window.Worker;
    const trap = new Uint8Array([0, 0x61, 0x73, 0x6d, 1, 0, 0, 0, 1, 4, 1, 0x60, 0, 0, 3, 2, 1, 0, 7, 5, 1, 1, 0x74, 0, 0, 0xa, 5, 1, 3, 0, 0, 0xb]);
    const { instantiate } = WebAssembly;
    Object.assign(window, { testTrap: false, testLive: live, Worker: class extends RealWorker {
      /** @param {string | URL} url @param {WorkerOptions} [options] */
      constructor(url, options) { super(url, options); live.add(this); }
      terminate() { live.delete(this); super.terminate(); }
    } });
    // The first call from WebAssembly to the browser after testTrap is set traps.
    /** @type {any} */ (WebAssembly).instantiate = (/** @type {WebAssembly.Module} */ code, /** @type {any} */ imports) => {
      for (const part of Object.values(imports)) {
        for (const [name, body] of Object.entries(part)) {
          if (typeof body !== 'function') continue;
          part[name] = (/** @type {any[]} */ ...values) => {
            if (/** @type {any} */ (window).testTrap) /** @type {any} */ (new WebAssembly.Instance(new WebAssembly.Module(trap)).exports).t();
            return body(...values);
          };
        }
      }
      return instantiate(code, imports);
    };
  } });
  await page.page.evaluate(() => {
    const document = window.gaitsmith.document();
    window.gaitsmith.open({ ...document, hash: undefined, title: 'Before the trap', environment: { friction: 0.2 } });
  });
  const before = await workOf(page);
  await page.until('the address', () => location.href === window.gaitsmith.link());
  const ended = page.call('search', () => {
    const search = window.gaitsmith.synthesize({ evaluations: 1000000, workers: 1 }).then(() => 'found', String);
    window.gaitsmith.on('progress', () => Object.assign(window, { testTrap: true }));
    return search;
  });
  assert.match(await ended, /unreachable/);
  await page.until('a word about it', () => /stopped working.*reload to continue/.test(document.querySelector('#banner-text')?.textContent ?? ''));
  assert.equal(await liveWorkers(page), 0);
  await page.reload();
  assert.ok(page.complaints.length < 10 && page.complaints.every((text) => /unreachable/.test(text)), page.complaints.join('\n'));
  page.complaints.length = 0;
  same(await workOf(page), before, 'after all');
  assert.equal((await search(page)).error, '');
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @type {typeof import('./all.mjs').SCENARIOS} */
export const FAULT_SCENARIOS = [
  ['workers that die, trap or hang in the middle of a batch cost a search nothing but time', survived],
  ['a search whose workers keep stopping, or have no memory, says why and keeps its best; the next one works', givenUp],
  ['where the browser gives no more workers the page says so, and leaves none', refusedWorkers],
  ['where the page has no memory for something, it says so and goes on', pageMemory],
  ['where the page itself traps it says so, ends its workers and keeps the work as it was', pageTraps],
];
