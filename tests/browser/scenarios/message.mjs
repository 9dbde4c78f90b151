// SPDX-License-Identifier: MIT
// Lost and repeated messages between page, coordinator and evaluators, each kind in each direction. The page's client
// runs many searches at a time, each with one such fault.
import assert from 'node:assert/strict';
import { faultySite } from '../faulty_site.mjs';
import { PageDriver } from '../page_driver.mjs';

/** @typedef {import('./all.mjs').Visit} Visit */
/** @typedef {import('../worker_faults.mjs').Fault} Fault */
/** how: an action during the search; end: its end, if not the usual one. @typedef {{faults: Fault[], how?: string, end?: string}} Case */

const AT_A_TIME = 12;

/** @type {[Fault['place'], string, Partial<Fault> & {how?: string, end?: string}][]} */
const KINDS = [
  ['from-page', 'stand-by', { how: 'stand by' }],
  ['from-page', 'coordinate', {}],
  ['from-page', 'evaluate', {}],
  ['from-page', 'add-evaluator', {}],
  ['from-page', 'remove-evaluator', { how: 'lose an evaluator' }],
  ['from-page', 'pause', { how: 'pause' }],
  ['from-page', 'resume', { how: 'pause' }],
  ['from-page', 'stop', { how: 'stop', end: 'stopped' }],
  ['to-page', 'loaded', {}],
  ['to-page', 'ready', { role: 'coordinate' }],
  ['to-page', 'ready', { role: 'evaluate' }],
  ['to-page', 'failed', { how: 'damage', end: 'failed' }],
  ['to-page', 'progress', { nth: 2 }],
  ['to-page', 'checkpoint', {}],
  ['to-page', 'silent', { how: 'mute an evaluator' }],
  ['to-page', 'finished', {}],
  ['to-port', 'score', { nth: 5 }],
  ['to-port', 'scored', { nth: 5 }],
];

/** @type {Case[]} */
const CASES = (/** @type {const} */ (['lose', 'double'])).flatMap((act) => KINDS.map(([place, type, { how, end, ...more }]) => {
  const id = `${act} ${type} ${more.role ?? ''} ${place}`;
  /** @type {Fault[]} */
  const faults = [{ id, place, type, act, ...more }];
  if (how === 'mute an evaluator') faults.push({ id: `${id}, mute`, place: 'to-port', type: 'scored', act: 'lose', nth: 5 });
  return { faults, how, end };
}));

/**
 * Runs in the page: one search with its faults. @param {Case} testCase @param {string} document  as bytes in base64
 * @returns {Promise<{found: string, met: number, live: number, incidents: number, ms: number}>}
 */
async function searchWith({ faults, how = '' }, document) {
  const [{ SearchClient }, { compiledEngine }, { scriptAddress }] = await Promise.all(
    ['search/search_client.js', 'search/compiled_engine.js', 'browser/trusted.js'].map((name) => import(new URL(name, location.href).href)));
  const ids = new Set(faults.map(({ id }) => id));
  let waiting = faults;
  let met = 0;
  const channel = new BroadcastChannel('faults');
  channel.onmessage = ({ data }) => {
    if (!ids.has(data.id)) return;
    met++;
    waiting = waiting.filter(({ id }) => id !== data.id);
  };
  const live = /** @type {Worker[]} */ ([]);
  let incidents = 0;
  const start = performance.now();
  const bytes = Uint8Array.from(atob(document), (letter) => letter.charCodeAt(0));
  if (how === 'damage') bytes[10] ^= 4;
  const engine = await compiledEngine();
  const found = await new Promise((resolve) => {
    let meddled = false;
    const client = new SearchClient({
      engine,
      createWorker: () => {
        const worker = new Worker(scriptAddress('search/worker.js'), { type: 'module', name: waiting.length > 0 ? JSON.stringify(waiting) : '' });
        const { terminate } = worker;
        worker.terminate = () => {
          live.splice(live.indexOf(worker), 1);
          terminate.call(worker);
        };
        live.push(worker);
        return worker;
      },
      listener: {
        progress: (/** @type {any} */ report) => {
          if (report.state === 'paused' && how === 'pause') setTimeout(() => client.resume(), 200);
          if (report.state === 'done' || report.state === 'stopped') {
            setTimeout(() => { client.close(); resolve(end(report)); }, 300); // time for a repeated message
          } else if (report.evaluations > 300 && !meddled) {
            meddled = true;
            if (how === 'pause') client.pause();
            if (how === 'stop') client.stop();
            if (how === 'lose an evaluator') live[1].onerror?.(new ErrorEvent('error'));
          }
        },
        incident: () => incidents++,
        failed: (/** @type {any} */ error) => { setTimeout(() => resolve(`failed: ${error.fault?.code ?? error.message}`), 300); },
      },
    });
    const end = (/** @type {any} */ { state, evaluations, bestFitness, bestGenome, curve }) =>
      state === 'stopped' ? state : JSON.stringify([state, evaluations, bestFitness, [...bestGenome], [...curve]]);
    if (how === 'stand by') client.standBy(1);
    setTimeout(() => client.start(bytes, 1), how === 'stand by' ? 300 : 0);
  });
  channel.close();
  return { found, met, live: live.length, incidents, ms: Math.round(performance.now() - start) };
}

/** @param {Visit} visit */
async function eachMessage({ browser, name, figures }) {
  const page = await PageDriver.open(browser, (await faultySite()).address());
  // Checkpoints come once a second, so only their tests need a long search.
  const [short, long, endless] = await page.call('documents', async () => {
    const [{ Engine }, { compiledEngine }] = await Promise.all(['search/engine.js', 'search/compiled_engine.js'].map((name) => import(new URL(name, location.href).href)));
    const engine = await Engine.load(await compiledEngine());
    return [2500, 8000, 1000000].map((evaluations) => {
      const json = { ...window.gaitsmith.document(), hash: undefined, title: '', search: { seed: 9, evaluations } };
      return btoa(String.fromCharCode(...engine.documentFromText(JSON.stringify(json))));
    });
  });
  const documentOf = (/** @type {Case} */ { faults }) => (faults[0].type === 'stop' ? endless : faults[0].type === 'checkpoint' ? long : short);
  const run = (/** @type {Case} */ testCase) => page.page.evaluate(searchWith, testCase, documentOf(testCase));
  const undisturbed = new Map();
  for (const document of [short, long]) undisturbed.set(document, (await page.page.evaluate(searchWith, { faults: [] }, document)).found);
  assert.match(undisturbed.get(long), /^\["done",8000,/);

  const waiting = [...CASES]; // the longest first
  const wrong = /** @type {string[]} */ ([]);
  const times = /** @type {[number, string][]} */ ([]);
  await Promise.all(Array.from({ length: AT_A_TIME }, async () => {
    for (let testCase = waiting.shift(); testCase; testCase = waiting.shift()) {
      const { id } = testCase.faults[0];
      let timer;
      const late = new Promise((_, reject) => { timer = setTimeout(() => reject(new Error('has no end')), 60000); });
      try {
        const result = /** @type {any} */ (await Promise.race([run(testCase), late]));
        times.push([result.ms, id]);
        const should = testCase.end === 'stopped' ? 'stopped' : testCase.end === 'failed' ? 'failed: checksum' : undisturbed.get(documentOf(testCase));
        if (result.found !== should) wrong.push(`${id}: ended as ${result.found.slice(0, 60)}`);
        if (result.met < testCase.faults.length) wrong.push(`${id}: did not happen`);
        if (result.live > 0) wrong.push(`${id}: ${result.live} workers are left`);
      } catch (error) {
        wrong.push(`${id}: ${error}`);
      } finally {
        clearTimeout(timer);
      }
    }
  }));
  assert.deepEqual(wrong, []);
  times.sort(([a], [b]) => b - a);
  figures['messages lost or doubled'] = `${CASES.length}, at most ${(times[0][0] / 1000).toFixed(1)} s (${times[0][1].trim()})`;
  if (name === 'Chromium') assert.deepEqual(page.complaints, []); // Firefox reports every ended worker
  await page.close();
}

/** @type {typeof import('./all.mjs').SCENARIOS} */
export const MESSAGE_SCENARIOS = [
  ['a message that is lost or comes twice, of any kind, costs a search some time and nothing else', eachMessage],
];
