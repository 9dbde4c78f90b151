// SPDX-License-Identifier: MIT
// Repeats searches and edits for a long time, in Chromium:
//   node tests/browser/soak.mjs [seconds, default 1800] [folder, default build/site] [--write file]
// Regularly returns to the same document and measures the page. Fails if the page's own objects, its WebAssembly memory
// or its workers grow by more than 1 % between the second and the last quarter (3 % in a run below 20 minutes), if the
// whole heap grows by more than 10 %, if work or frames take twice as long, if workers are left, or if the browser
// reports an error.
import { writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { ROOT, startChromium } from './browsers.mjs';
import { faultySite, liveWorkers } from './faulty_site.mjs';
import { PageDriver, sleep } from './page_driver.mjs';

/** @typedef {Record<string, number>} Sample */

const seconds = Number(process.argv[2] ?? 1800);
const folder = !process.argv[3] || process.argv[3].startsWith('--') ? join(ROOT, 'build/site') : process.argv[3];
const file = process.argv.includes('--write') ? process.argv[process.argv.indexOf('--write') + 1] : '';
const LINE_MS = 30000;
const WORKERS = 2;
const MAX_RESULTS = 100; // the page's limit
const MAX_GROWTH = seconds < 1200 ? 1.03 : 1.01; // in a short run some features are used for the first time
// The whole heap also contains machine code. The browser compiles, optimizes and drops it at any time, as parts of the
// scripts and of the 2.5 MB of WebAssembly are used.
const MAX_GROWTH_WITH_CODE = 1.1;
const OWN = new Set(['array', 'string', 'concatenated string', 'sliced string', 'object', 'object shape', 'closure', 'regexp', 'number', 'symbol', 'bigint']);
const MAX_SLOWDOWN = 2;
const EDITS = 6; // between two measurements
const CYCLE = 6; // rounds in which every search and every action comes once
const LEAST_ROUNDS = 2 * CYCLE; // measured, however slow the machine
const MORE_ROUNDS = 3 * CYCLE; // at most, after bytes have grown

const browser = await startChromium();
if (!browser) throw new Error('Chromium is not installed (./dev setup browsers)');
const site = await faultySite(folder); // its workers report their memory
const page = await PageDriver.open(browser, site.address(), { before: soaked, plays: true });
const session = await page.page.createCDPSession();
const home = await page.call('home', () => JSON.stringify({ ...window.gaitsmith.document(), hash: undefined,
  search: { ...window.gaitsmith.document().search, algorithm: 'sphc', seed: 1, evaluations: 3000 } }));

/** Runs in the page before its scripts. */
function soaked() {
  const { instantiate } = WebAssembly;
  const state = Object.assign(window, { testMemory: /** @type {any} */ (null), testFrames: /** @type {number[]} */ ([]), testLive: new Set() });
  /** @type {any} */ (WebAssembly).instantiate = async (/** @type {any} */ code, /** @type {any} */ imports) => {
    const made = /** @type {any} */ (await instantiate(code, imports));
    state.testMemory ??= Object.values((made.instance ?? made).exports).find((part) => part instanceof WebAssembly.Memory);
    return made;
  };
  const RealWorker = window.Worker;
  window.Worker = class extends RealWorker {
    /** @param {string | URL} url @param {WorkerOptions} [options] */
    constructor(url, options) {
      super(url, options);
      state.testLive.add(this);
    }

    terminate() {
      state.testLive.delete(this);
      super.terminate();
    }
  };
  let last = performance.now();
  const measureFrame = () => {
    const now = performance.now();
    state.testFrames.push(now - last);
    last = now;
    requestAnimationFrame(measureFrame);
  };
  requestAnimationFrame(measureFrame);
}

/** @param {number[]} numbers */
function median(numbers) {
  const sorted = [...numbers].sort((a, b) => a - b);
  return sorted.length === 0 ? NaN : (sorted[(sorted.length - 1) >> 1] + sorted[sorted.length >> 1]) / 2;
}

/** The machine's speed, which depends on other programs. @returns {number} ms for a fixed amount of work */
function pace() {
  const start = performance.now();
  let sum = 0;
  for (let i = 0; i < 2e7; i++) sum = (sum * 31 + i) | 0;
  return performance.now() - start + (sum === 1 ? 1 : 0);
}

/** A widget's rectangle, if it is on the canvas. @param {string} id */
const place = async (id) => (await page.widgets()).find((widget) => widget.id === id)?.rect;

/** Drags along half a slider. @param {string} id */
async function drag(id) {
  const rect = await place(id);
  if (!rect) return;
  const y = rect.y + rect.height / 2;
  await page.page.mouse.move(rect.x + 0.3 * rect.width, y);
  await page.page.mouse.down();
  for (let i = 1; i <= 8; i++) {
    await page.page.mouse.move(rect.x + (0.3 + 0.05 * i) * rect.width, y);
    await page.frames(1);
  }
  await page.page.mouse.up();
  await page.frames(2);
}

/** The size of the page's own objects in a heap snapshot, with buffers, without code and the browser's own objects. @returns {Promise<number>} bytes */
async function objects() {
  const chunks = /** @type {string[]} */ ([]);
  const take = (/** @type {{chunk: string}} */ { chunk }) => { chunks.push(chunk); };
  session.on('HeapProfiler.addHeapSnapshotChunk', take);
  await session.send('HeapProfiler.takeHeapSnapshot', { reportProgress: false });
  session.off('HeapProfiler.addHeapSnapshotChunk', take);
  const { snapshot: { meta: { node_fields: fields, node_types: [types] } }, nodes } = JSON.parse(chunks.join(''));
  const [type, size] = [fields.indexOf('type'), fields.indexOf('self_size')];
  let bytes = (await session.send('Runtime.getHeapUsage')).backingStorageSize;
  for (let node = 0; node < nodes.length; node += fields.length) if (OWN.has(types[nodes[node + type]])) bytes += nodes[node + size];
  return bytes;
}

/** A person's actions during and between searches. @type {(() => Promise<unknown>)[]} */
const ACTIONS = [
  async () => { await page.click('panels/2'); await drag('style/effort'); await drag('style/upright'); },
  async () => { await page.click('panels/1'); await page.click('controller/rule/1'); await drag('rule-edit/tau'); },
  async () => { await page.press('Control+z', 2); await page.press('Control+Shift+z'); },
  async () => { await page.click('panels/0'); await page.press(' '); await page.press(' '); },
  async () => { await drag('transport/scrub'); await page.press('k'); },
  async () => {
    await page.click('panels/3');
    await page.press('Control+k');
    await page.page.keyboard.type('theme');
    await page.press('Escape');
  },
];

/** @param {object} options @returns {Promise<number>} evaluations per second */
const search = (options) => page.call('search', `(async () => {
  const start = performance.now();
  const { report } = await window.gaitsmith.synthesize(${JSON.stringify({ workers: WORKERS, ...options })});
  return report.evaluations / (performance.now() - start) * 1000;
})()`);

/** @param {number} round */
async function work(round) {
  const algorithm = ['sphc', 'gga', 'rgt', 'cma-es', 'map-elites', 'shc'][round % 6];
  const searching = search({ algorithm, seed: round, evaluations: 6000, sense: round % 2 ? 'timer' : 'physical' });
  for (let i = 0; i < EDITS; i++) await ACTIONS[(round + i) % ACTIONS.length]();
  if (round % 3 === 0) await page.call('stop', () => { window.gaitsmith.stop(); });
  await searching;
  if (round % 4 === 0) { // with a worker that dies
    await page.terminateWorker(-1);
    await search({ algorithm, seed: round, evaluations: 1500, workers: WORKERS + 1 });
  }
}

/** Returns to the same document, runs the same search, and measures the page at rest. @returns {Promise<Sample>} */
async function weigh() {
  await page.page.evaluate((text) => {
    window.gaitsmith.open(text);
    const state = /** @type {any} */ (window);
    state.testFrames.length = 0;
    const created = state.testWorkers; // the test's own list must not keep dead workers
    created.splice(0, Infinity, ...created.filter((/** @type {Worker} */ worker) => state.testLive.has(worker)));
  }, home);
  await page.click('panels/3');
  const slow = pace();
  const rate = await search({ seed: 1, workers: WORKERS + 1 }); // always as many: a worker's heap depends on its share
  const frames = await page.call('frames', () => /** @type {any} */ (window).testFrames.splice(0));
  await page.page.evaluate((text) => { window.gaitsmith.open(text); }, home);
  await page.frames(10);
  await sleep(600); // for timers that wait until the document rests
  const heapOf = async (/** @type {any} */ to) => {
    await to.send('HeapProfiler.enable');
    for (let i = 0; i < 2; i++) await to.send('HeapProfiler.collectGarbage');
    const { usedSize, backingStorageSize } = await to.send('Runtime.getHeapUsage');
    return usedSize + backingStorageSize;
  };
  const pageWorkers = page.page.workers();
  const sizes = await Promise.all(pageWorkers.map((worker) => worker.evaluate(() => /** @type {any} */ (self).testMemory?.buffer.byteLength ?? 0)));
  const heaps = await Promise.all(pageWorkers.map((worker) => heapOf(worker.client)));
  return {
    'page heap, bytes': await heapOf(session),
    'page objects, bytes': await objects(),
    'page WASM, bytes': await page.call('memory', () => /** @type {any} */ (window).testMemory.buffer.byteLength),
    'worker heap, bytes': median(heaps),
    'worker WASM, bytes': Math.max(0, ...sizes),
    'evaluations/s': rate,
    'frame, ms': median(frames),
    'machine, ms': slow,
    workers: await liveWorkers(page),
    threads: pageWorkers.length,
  };
}

/** @param {Sample} sample */
const formatted = (sample) => Object.entries(sample).map(([name, value]) => (name.endsWith(', bytes')
  ? `${name.replace(', bytes', '')} ${(value / 2 ** 20).toFixed(2)} MB` : `${name} ${value < 100 ? value.toFixed(1) : Math.round(value)}`)).join(', ');

// Fill the limited lists and use every feature before the first measurement.
let round = 1;
const full = Date.now();
for (; round <= MAX_RESULTS + 20; round++) await search({ algorithm: 'rgt', seed: round, evaluations: 40 });
for (const first = round; round < first + CYCLE; round++) await work(round);
await weigh();
console.log(`warm after ${Math.round((Date.now() - full) / 1000)} s, with ${await page.call('results', () => window.gaitsmith.results().length)} results`);

/** @type {Sample[]} */
const samples = [];
const start = Date.now();
for (let line = start + LINE_MS; Date.now() - start < seconds * 1000 || samples.length < LEAST_ROUNDS; round++) {
  await work(round);
  samples.push(await weigh());
  if (Date.now() < line) continue;
  console.log(`${String(Math.round((Date.now() - start) / 1000)).padStart(5)} s, round ${samples.length}: ${formatted(samples[samples.length - 1])}`);
  line += LINE_MS * Math.max(1, Math.ceil((Date.now() - line) / LINE_MS));
}

// A quarter, or a whole cycle, because rounds of different kinds hold different memory.
function compared() {
  const part = Math.max(CYCLE, Math.floor(samples.length / 4));
  const from = Math.min(Math.floor(samples.length / 4), samples.length - 2 * part);
  return { second: samples.slice(from, from + part), last: samples.slice(-part) };
}
// A leak raises the least of the rounds too. The median also rises with memory that is free but not yet collected: copies
// of the hundred results, 277 KB each, of which two rounds of the same kind held three and four.
const of = (/** @type {Sample[]} */ part, /** @type {string} */ name) => {
  const values = part.map((sample) => sample[name]);
  return name.endsWith('bytes') ? Math.min(...values) : median(values);
};
const grew = (/** @type {string} */ name, /** @type {number} */ ratio) => name.endsWith('bytes')
  && !(ratio <= (name === 'page heap, bytes' ? MAX_GROWTH_WITH_CODE : MAX_GROWTH));
// By chance all rounds of a cycle may hold four. Then it goes on: what has leaked never comes back.
for (let more = 0; more < MORE_ROUNDS; more++, round++) {
  const { second, last } = compared();
  if (!Object.keys(samples[0]).some((name) => grew(name, of(last, name) / of(second, name)))) break;
  await work(round);
  samples.push(await weigh());
}
const { second, last } = compared();
const wrong = /** @type {string[]} */ ([]);
const lines = [`soak of ${Math.round((Date.now() - start) / 1000)} s: ${samples.length} rounds; medians, and least bytes, of the second and of the last quarter, or of whole cycles`];
const machine = of(last, 'machine, ms') / of(second, 'machine, ms');
for (const name of Object.keys(samples[0] ?? {})) {
  const [before, after] = [of(second, name), of(last, name)];
  const ratio = after / before;
  lines.push(`${name.padEnd(20)} ${before.toFixed(1).padStart(12)} ${after.toFixed(1).padStart(12)}  × ${ratio.toFixed(4)}`);
  if (grew(name, ratio)) wrong.push(`${name}: grew to ${ratio.toFixed(4)} times what it was`);
  // Other programs also use the machine, so the slowdown must show both in absolute terms and relative to its speed.
  if (name === 'evaluations/s' && Math.max(ratio, ratio * machine) < 1 / MAX_SLOWDOWN) wrong.push(`searches became slower: × ${ratio.toFixed(2)}, the machine × ${(1 / machine).toFixed(2)}`);
  if (name === 'frame, ms' && Math.min(ratio, ratio / machine) > MAX_SLOWDOWN) wrong.push(`frames became slower: × ${ratio.toFixed(2)}, the machine × ${machine.toFixed(2)}`);
}
const limit = Math.max(...samples.map(({ workers, threads }) => Math.max(workers, threads)));
const TEAM = WORKERS + 2; // the last search's evaluators and their coordinator
if (limit > TEAM) wrong.push(`${limit} workers live at rest`);
if (samples.some(({ workers }) => workers <= WORKERS)) wrong.push('workers are missing at rest');
for (const complaint of page.complaints) wrong.push(complaint);
lines.push(...wrong.map((text) => `FAILED  ${text}`), wrong.length === 0 ? 'passed' : `${wrong.length} failed`);
console.log(lines.join('\n'));
if (file) await writeFile(file, `${lines.join('\n')}\n`);
await browser.close();
process.exit(wrong.length === 0 ? 0 : 1);
