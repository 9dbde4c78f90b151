// SPDX-License-Identifier: MIT
// The queue of searches, their results, and what survives a reload. Each scenario opens its own pages.
import assert from 'node:assert/strict';
import { ONCE, ONE_BROWSER, PageDriver, RARELY, sleep } from '../page_driver.mjs';
import { stateOf } from './history.mjs';
import { nativeHash } from '../native.mjs';

/** @typedef {import('./all.mjs').Visit} Visit */
/** @typedef {import('../../../web/app/app.js').FoundMotion} FoundMotion */

const EVALUATIONS = 800;

/** @param {PageDriver} page @param {string} id */
const widget = async (page, id) => (await page.widgets()).find((one) => one.id === id);
/** @param {PageDriver} page @returns {Promise<FoundMotion[]>} */
const results = (page) => page.call('results', () => window.gaitsmith.results());
/** @param {PageDriver} page @param {number} count */
const untilResults = (page, count) => page.until(`${count} results`, `window.gaitsmith.results().length >= ${count}`);

/**
 * Opens a page with the Search panel, with folded settings so that queue and results are visible.
 * @param {import('../browsers.mjs').Browser} browser @param {string} address @param {Parameters<typeof PageDriver.open>[2]} [options]
 */
async function openPanel(browser, address, options) {
  const page = await PageDriver.open(browser, address, options);
  await page.call('document', () => {
    const document = window.gaitsmith.document();
    window.gaitsmith.open({ ...document, hash: undefined, view: { panel: 3 } });
  });
  await page.frames(4);
  await page.click('search/settings');
  return page;
}

/** Scrolls the panel to the results at its end. @param {PageDriver} page */
async function toEnd(page) {
  const tab = (await widget(page, 'panels/3'))?.rect ?? { x: 0, y: 0 };
  await page.page.mouse.move(tab.x + 20, tab.y + 300);
  await page.page.mouse.wheel({ deltaY: 5000 });
  await page.frames(4);
}

/** The problems of the queue, with different figures. */
const PROBLEMS = /** @type {const} */ ([
  { name: 'First', length: 0.5, seed: 5, algorithm: 'sphc' },
  { name: 'Second', length: 0.4, seed: 6, algorithm: 'shc' },
  { name: 'Third', length: 0.3, seed: 7, algorithm: 'gga' },
]);

/** Queues the three problems by clicks, and returns to the first document. @param {PageDriver} page @param {number} evaluations */
async function queueThree(page, evaluations = EVALUATIONS) {
  const before = await page.call('before', () => JSON.stringify(window.gaitsmith.document()));
  for (const problem of PROBLEMS) {
    await page.page.evaluate((problem, evaluations) => {
      const { gaitsmith } = window;
      const rods = (gaitsmith.document().figure.rods ?? []).map((rod) => ({ ...rod, length_m: problem.length }));
      gaitsmith.open({ title: problem.name, figure: { name: problem.name, rods }, view: { panel: 3 }, task: { duration_steps: 200 },
        search: { algorithm: problem.algorithm, seed: problem.seed, evaluations } });
    }, problem, evaluations);
    await page.frames();
    await page.click('queue/add');
  }
  await page.page.evaluate((text) => window.gaitsmith.open(text), before);
  await page.frames();
}

/** @param {Visit} visit */
async function runsThrough({ browser, address }) {
  const page = await openPanel(browser, address);
  await queueThree(page);
  const before = await stateOf(page);
  assert.deepEqual((await page.call('queue', () => window.gaitsmith.queue())).map(({ title, seed }) => [title, seed]),
    [['First · travel', 5], ['Second · travel', 6], ['Third · travel', 7]]);
  assert.match((await widget(page, 'queue/2'))?.value ?? '', /SHC · seed 6 · 800 evaluations/);
  await page.click('queue/2/remove');
  await page.click('queue/bring-back');
  await page.click('queue/3/up');
  await page.click('queue/2/remove');
  assert.equal((await widget(page, 'queue'))?.value, '2 wait');
  await page.click('queue/run');
  await untilResults(page, 2);
  await page.until('the end', () => document.querySelector('#status')?.textContent?.startsWith('Third · travel: Search done') ?? false);
  assert.equal(await stateOf(page), before, 'the stage belongs to the document in hand');
  await page.until('an empty queue, as drawn', () =>
    window.gaitsmith.widgets().find(({ id }) => id === 'queue')?.value === 'empty');

  await toEnd(page);

  // A shown result is the same as that of the same search outside the queue, and of the command line.
  const found = (await results(page)).find(({ seed }) => seed === 5);
  assert.ok(found && found.origin === 'done' && found.evaluations === EVALUATIONS);
  const entry = await widget(page, `found/${found.id}`);
  assert.match(entry?.label ?? '', /^Show First · travel, 10 rules/);
  assert.match(entry?.value ?? '', /^SPHC · seed 5 · 800 evaluations · physical\. Score /);
  await page.click(`found/${found.id}`);
  assert.equal(await page.hash(), found.hash);
  const shown = await stateOf(page);
  assert.equal((await widget(page, `found/${found.id}`))?.state.selected, true);
  const again = await PageDriver.open(browser, found.link);
  assert.equal(await stateOf(again), shown);
  const by = await again.call('search', async () => {
    const { gaitsmith } = window;
    gaitsmith.open({ ...gaitsmith.document(), hash: undefined, title: 'Bare', controllers: [], timeline: [] });
    const { hash, link } = await gaitsmith.synthesize();
    return { hash, link: link.split('#')[1] };
  });
  assert.equal(by.hash, found.hash);
  assert.equal(by.link, found.link.split('#')[1]);
  assert.equal(await nativeHash(found.link) ?? found.hash, found.hash);
  await again.close();
  await page.press('Control+z');
  assert.equal(await stateOf(page), before);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function stopped({ browser, address }) {
  const page = await openPanel(browser, address);
  await queueThree(page, 1000000);
  await page.call('run', () => { window.gaitsmith.runQueue(); });
  await page.until('a beginning', () => /Queue: First · travel, SPHC/.test(document.querySelector('#status')?.textContent ?? ''));
  await page.until('progress', () => /^[1-9]/.test(document.querySelector('#count')?.textContent ?? ''));
  // Opening another document does not affect the queue.
  await page.call('new', () => { document.querySelector('#new')?.dispatchEvent(new MouseEvent('click', { bubbles: true })); });
  await page.frames();
  assert.ok(await widget(page, 'search/stop'), 'New ended a search of the queue');
  await sleep(300);
  await page.click('search/stop');
  await page.until('a result', () => window.gaitsmith.results().length === 1);
  await sleep(700); // time for another search to start by mistake
  const [result] = await results(page);
  assert.equal(result.origin, 'stopped');
  assert.match(result.title, /^First/);
  assert.ok(result.evaluations > 0 && result.evaluations < 1000000);
  assert.ok(await widget(page, 'search/start'), 'the next one began after Stop');
  assert.equal(await page.call('queue', () => window.gaitsmith.queue().length), 2);
  await page.call('run', () => { window.gaitsmith.runQueue(); });
  await page.until('the next one', () => /Queue: Second/.test(document.querySelector('#status')?.textContent ?? ''));
  await page.until('progress', () => /^[1-9]/.test(document.querySelector('#count')?.textContent ?? ''));
  await page.call('clear', () => { window.gaitsmith.clearQueue(); });
  await page.call('stop', () => { window.gaitsmith.stop(); });
  await page.until('its end', () => window.gaitsmith.results().length === 2);
  assert.equal(await page.call('queue', () => window.gaitsmith.queue().length), 0);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function afterReload({ browser, address }) {
  const page = await openPanel(browser, address);
  await page.call('search', async () => {
    for (const seed of [1, 2, 3]) await window.gaitsmith.synthesize({ seed, evaluations: 400, algorithm: 'rgt' });
  });
  const [third, second, first] = await results(page);
  assert.deepEqual([first.seed, second.seed, third.seed], [1, 2, 3]);
  await page.frames(4);
  await toEnd(page);
  await page.click(`found/${first.id}/keep`);
  await page.click(`found/${second.id}/delete`);
  await page.press('k'); // saves the third result, which is on the stage
  const before = await results(page);
  assert.deepEqual(before.map(({ seed, kept }) => [seed, kept]), [[3, true], [1, true]]);
  await page.reload();
  assert.deepEqual(await results(page), before);
  assert.ok(await page.page.evaluate((id) => window.gaitsmith.showResult(id), first.id));
  assert.equal(await page.hash(), first.hash);

  // Another tab has the results, too. Its own results survive changes in the first tab.
  const other = await PageDriver.open(browser, address, { beside: page });
  assert.equal((await results(other)).length, 2);
  await other.call('search', () => window.gaitsmith.synthesize({ seed: 9, evaluations: 400, algorithm: 'rgt' }));
  await page.page.bringToFront();
  await page.call('search', () => window.gaitsmith.synthesize({ seed: 8, evaluations: 400, algorithm: 'rgt' }));
  await page.reload();
  assert.deepEqual((await results(page)).map(({ seed }) => seed).sort(), [1, 3, 8, 9]);
  await page.call('damage', () => {
    const key = Object.keys(localStorage).find((name) => name.startsWith('gaitsmith-found/')) ?? '';
    localStorage.setItem(key, '{"link":"AZ4"}');
  });
  await page.reload();
  assert.equal((await results(page)).length, 3);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** The queue runs without frames, as in a hidden tab. @param {Visit} visit */
async function unseen({ browser, address }) {
  const page = await openPanel(browser, address);
  await queueThree(page);
  await page.call('run', () => {
    window.gaitsmith.runQueue();
    window.requestAnimationFrame = () => 0;
  });
  await untilResults(page, 3);
  assert.deepEqual((await results(page)).map(({ seed, origin }) => [seed, origin]), [[7, 'done'], [6, 'done'], [5, 'done']]);
  await page.close();
}

/** @param {Visit} visit */
async function oneFails({ browser, address }) {
  const page = await openPanel(browser, address, {
    // The first coordinator of the queue fails, as if core had refused the document.
    before: () => {
      Object.assign(window, { testFailing: false });
      const RealWorker = Worker;
      window.Worker = class extends RealWorker {
        /** @param {any} message @param {any} [transfer] */
        postMessage(message, transfer) {
          const state = /** @type {any} */ (window);
          if (message.type !== 'coordinate' || !state.testFailing) return super.postMessage(message, transfer);
          state.testFailing = false;
          const fault = { code: 'structure', where: '', what: 'made up by a test' };
          setTimeout(() => this.onmessage?.(new MessageEvent('message', { data: { type: 'failed', run: message.run, fault } })), 50);
        }
      };
    },
  });
  await queueThree(page);
  await page.call('run', () => {
    Object.assign(window, { testFailing: true });
    window.gaitsmith.runQueue();
  });
  await untilResults(page, 3);
  assert.deepEqual((await results(page)).map(({ seed, origin, score }) => [seed, origin, score !== null]),
    [[7, 'done', true], [6, 'done', true], [5, 'failed', false]]);
  assert.match(await page.text('#banner-text'), /made up by a test.*The queue continues/);
  await page.close();
}

/** @param {Visit} visit */
async function byScript({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  const outcome = await page.call('queue', async () => {
    const { gaitsmith } = window;
    const fault = (/** @type {() => unknown} */ request) => {
      try {
        request();
        return '';
      } catch (error) {
        return String(error);
      }
    };
    const ends = /** @type {{hash: string, link: string, evaluations: number}[]} */ ([]);
    const all = new Promise((resolve) => gaitsmith.on('done', ({ detail: { report, hash, link } }) => {
      if (ends.push({ hash, link, evaluations: report.evaluations }) === 3) resolve(true);
    }));
    const idle = gaitsmith.runQueue();
    const unknown = fault(() => gaitsmith.enqueue({ algorithm: 'anneal' }));
    const own = gaitsmith.synthesize({ seed: 1, evaluations: 300, algorithm: 'rgt' });
    gaitsmith.enqueue({ seed: 2 });
    gaitsmith.enqueue({ seed: 3, algorithm: 'sphc' });
    const waiting = gaitsmith.queue();
    const { hash } = await own;
    const stage = gaitsmith.hash();
    await all;
    for (let i = 0; i < 50; i++) gaitsmith.enqueue({ seed: i });
    const full = fault(() => gaitsmith.enqueue({ seed: 50 }));
    const kept = gaitsmith.keep();
    return { idle, unknown, waiting, full, own: hash, stage, after: gaitsmith.hash(), ends, results: gaitsmith.results(), kept };
  });
  assert.equal(outcome.idle, false);
  assert.match(outcome.unknown, /algorithm/);
  assert.match(outcome.full, /queue is full: 50/);
  assert.deepEqual(outcome.waiting.map(({ seed, algorithm }) => [seed, algorithm]), [[2, 'rgt'], [3, 'sphc']]);
  // The document's own search is on the stage. Those of the queue are in the results, and each event has its own link.
  assert.equal(outcome.stage, outcome.own);
  assert.equal(outcome.after, outcome.own);
  assert.deepEqual(outcome.results.map(({ seed }) => seed), [3, 2, 1]);
  assert.deepEqual(outcome.ends.map(({ hash }) => hash), outcome.results.map(({ hash }) => hash).reverse());
  assert.deepEqual(outcome.ends.slice(1).map(({ link }) => link), outcome.results.slice(0, 2).map(({ link }) => link).reverse());
  assert.deepEqual(outcome.ends.map(({ evaluations }) => evaluations), [300, 300, 300]);
  assert.equal(outcome.kept, true);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function spread({ browser, address }) {
  const page = await openPanel(browser, address);
  const messages = await page.call('search', async () => {
    const spreads = /** @type {any[]} */ ([]);
    window.gaitsmith.on('progress', ({ detail }) => spreads.push(detail.spread));
    await window.gaitsmith.synthesize({ seed: 4, evaluations: 3000, algorithm: 'sphc' });
    return spreads;
  });
  const last = messages[messages.length - 1];
  assert.equal(last.members, 10);
  assert.ok(last.least <= last.lowerQuartile && last.lowerQuartile <= last.median && last.median <= last.upperQuartile && last.upperQuartile <= last.best);
  await page.frames(6);
  assert.match((await widget(page, 'search/curve'))?.value ?? '', /^best (-?[\d.]+) after 3,000 evaluations; population of 10: median .*, quartiles .* and .*, from .* to \1$/);
  await page.call('search', () => window.gaitsmith.synthesize({ evaluations: 500, algorithm: 'rgt' }));
  await page.frames(6);
  assert.match((await widget(page, 'search/curve'))?.value ?? '', /^best -?[\d.]+ after 500 evaluations$/);
  await page.close();
}

/** @param {Visit} visit */
async function forbidden({ browser, address }) {
  const page = await openPanel(browser, address, {
    before: () => {
      for (const name of ['localStorage', 'sessionStorage']) {
        Object.defineProperty(window, name, { get() { throw new DOMException('no', 'SecurityError'); } });
      }
    },
  });
  const messages = await page.call('search', async () => {
    const messages = /** @type {string[]} */ ([]);
    const status = /** @type {Element} */ (document.querySelector('#status'));
    new MutationObserver(() => messages.push(status.textContent ?? '')).observe(status, { childList: true, characterData: true, subtree: true });
    for (const seed of [1, 2]) await window.gaitsmith.synthesize({ seed, evaluations: 200, algorithm: 'rgt' });
    return messages;
  });
  assert.equal(messages.filter((sentence) => /no room for more results/.test(sentence)).length, 1);
  assert.equal((await results(page)).length, 2);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @type {import('./all.mjs').Scenario[]} */
export const QUEUE_SCENARIOS = [
  ['a queue of searches runs by itself and leaves the stage alone; a result shown is what its seed finds', runsThrough],
  ['a queue waits after Stop, resumes on request, and can be cleared', stopped],
  ['a queue goes on where no frame is drawn', unseen, ONCE, RARELY],
  ['a queue goes on after one that fails', oneFails, ONE_BROWSER, RARELY],
  ['a queue by script: added to, full, and told of with links of its own', byScript],
  ['results outlive a reload, with marks and deletions, and two tabs do not lose each other\'s', afterReload, ONCE, RARELY],
  ['results where storage is forbidden: said once, and here until one leaves', forbidden],
  ['the spread of a population is described and drawn', spread, ONE_BROWSER],
];
