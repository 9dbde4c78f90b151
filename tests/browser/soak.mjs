// SPDX-License-Identifier: MIT
// Searches and edits without an end, in Chromium:  node tests/browser/soak.mjs [seconds, default 1800] [folder, default
// build/site] [--write file]. Every so often the page comes back to the same document, and is weighed. Fails when the page's own
// objects, its WebAssembly memory or its workers grow by more than a hundredth between the second and the last quarter (three in
// a run below 20 minutes), the whole heap by more than a tenth, when work or frames take twice as long, when workers are left, or
// when the browser complains of anything.
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
const MOST_RESULTS = 100; // that the page keeps
const MOST_GROWTH = seconds < 1200 ? 1.03 : 1.01; // a short run still meets what it had not used before
// The whole heap also has the browser's machine code, which it makes, improves and drops as it likes, for as long as it likes: the
// page's scripts and its 2.5 MB of WebAssembly are compiled piece by piece as they are used.
const MOST_WITH_CODE = 1.1;
const OWN = new Set(['array', 'string', 'concatenated string', 'sliced string', 'object', 'object shape', 'closure', 'regexp', 'number', 'symbol', 'bigint']);
const MOST_SLOWING = 2;
const EDITS = 6; // between two weighings

const browser = await startChromium();
if (!browser) throw new Error('Chromium is not installed (./dev setup browsers)');
const site = await faultySite(folder); // its workers tell of their memory
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
  const Kept = window.Worker;
  window.Worker = class extends Kept {
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
  const look = () => {
    const now = performance.now();
    state.testFrames.push(now - last);
    last = now;
    requestAnimationFrame(look);
  };
  requestAnimationFrame(look);
}

/** @param {number[]} numbers */
function median(numbers) {
  const sorted = [...numbers].sort((a, b) => a - b);
  return sorted.length === 0 ? NaN : (sorted[(sorted.length - 1) >> 1] + sorted[sorted.length >> 1]) / 2;
}

/** The machine's own pace, which others share. @returns {number} ms of a fixed piece of work */
function pace() {
  const start = performance.now();
  let sum = 0;
  for (let i = 0; i < 2e7; i++) sum = (sum * 31 + i) | 0;
  return performance.now() - start + (sum === 1 ? 1 : 0);
}

/** Where a widget is, if it is on the canvas. @param {string} id */
const place = async (id) => (await page.widgets()).find((widget) => widget.id === id)?.rect;

/** A drag of half a slider's length. @param {string} id */
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

/** What the page's own objects take: what a snapshot has beside the browser's code and its own parts, and what its buffers hold. @returns {Promise<number>} bytes */
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

/** What a person does while a search runs, and between two. @type {(() => Promise<unknown>)[]} */
const DOINGS = [
  async () => { await page.click('panels/2'); await drag('style/effort'); await drag('style/upright'); },
  async () => { await page.click('panels/1'); await page.click('controller/rule/1'); await drag('rule-edit/tau'); },
  async () => { await page.press('Control+z', 2); await page.press('Control+Shift+z'); },
  async () => { await page.click('panels/0'); await page.press(' '); await page.press(' '); },
  async () => { await drag('transport/scrub'); await page.press('k'); },
  async () => { await page.click('panels/3'); await page.press('Control+k'); await page.page.keyboard.type('theme'); await page.press('Escape'); },
];

/** @param {object} wish @returns {Promise<number>} evaluations per second */
const search = (wish) => page.call('search', `(async () => {
  const start = performance.now();
  const { report } = await window.gaitsmith.synthesize(${JSON.stringify({ workers: WORKERS, ...wish })});
  return report.evaluations / (performance.now() - start) * 1000;
})()`);

/** @param {number} round */
async function work(round) {
  const algorithm = ['sphc', 'gga', 'rgt', 'cma-es', 'map-elites', 'shc'][round % 6];
  const searching = search({ algorithm, seed: round, evaluations: 6000, sense: round % 2 ? 'timer' : 'physical' });
  for (let i = 0; i < EDITS; i++) await DOINGS[(round + i) % DOINGS.length]();
  if (round % 3 === 0) await page.call('stop', () => { window.gaitsmith.stop(); });
  await searching;
  if (round % 4 === 0) { // with workers of their own, which are sent home
    await page.terminateWorker(-1);
    await search({ algorithm, seed: round, evaluations: 1500, workers: WORKERS + 1 });
  }
}

/** Back to the same document, the same search, and a page at rest. @returns {Promise<Sample>} */
async function weigh() {
  await page.page.evaluate((text) => {
    window.gaitsmith.open(text);
    const state = /** @type {any} */ (window);
    state.testFrames.length = 0;
    const born = state.testWorkers; // a list of the test, which must not keep those that are gone
    born.splice(0, Infinity, ...born.filter((/** @type {Worker} */ worker) => state.testLive.has(worker)));
  }, home);
  await page.click('panels/3');
  const slow = pace();
  const rate = await search({ seed: 1 });
  const frames = await page.call('frames', () => /** @type {any} */ (window).testFrames.splice(0));
  await page.page.evaluate((text) => { window.gaitsmith.open(text); }, home);
  await page.frames(10);
  await sleep(600); // what waits for the document to rest has been done
  const heapOf = async (/** @type {any} */ to) => {
    await to.send('HeapProfiler.enable');
    for (let i = 0; i < 2; i++) await to.send('HeapProfiler.collectGarbage');
    const { usedSize, backingStorageSize } = await to.send('Runtime.getHeapUsage');
    return usedSize + backingStorageSize;
  };
  const crew = page.page.workers();
  const sizes = await Promise.all(crew.map((worker) => worker.evaluate(() => /** @type {any} */ (self).testMemory?.buffer.byteLength ?? 0)));
  const heaps = await Promise.all(crew.map((worker) => heapOf(worker.client)));
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
    threads: crew.length,
  };
}

/** @param {Sample} sample */
const told = (sample) => Object.entries(sample).map(([name, value]) => (name.endsWith(', bytes')
  ? `${name.replace(', bytes', '')} ${(value / 2 ** 20).toFixed(2)} MB` : `${name} ${value < 100 ? value.toFixed(1) : Math.round(value)}`)).join(', ');

// What the page keeps a limited number of is full before anything is compared.
let round = 1;
const full = Date.now();
for (; round <= MOST_RESULTS + 20; round++) await search({ algorithm: 'rgt', seed: round, evaluations: 40 });
await work(0);
await weigh();
console.log(`warm after ${Math.round((Date.now() - full) / 1000)} s, with ${await page.call('results', () => window.gaitsmith.results().length)} results`);

/** @type {Sample[]} */
const samples = [];
const start = Date.now();
for (let line = start + LINE_MS; Date.now() - start < seconds * 1000; round++) {
  await work(round);
  samples.push(await weigh());
  if (Date.now() < line) continue;
  console.log(`${String(Math.round((Date.now() - start) / 1000)).padStart(5)} s, round ${samples.length}: ${told(samples[samples.length - 1])}`);
  line += LINE_MS * Math.max(1, Math.ceil((Date.now() - line) / LINE_MS));
}

const quarter = samples.length / 4;
const second = samples.slice(Math.floor(quarter), Math.floor(2 * quarter));
const last = samples.slice(Math.floor(3 * quarter));
const wrong = /** @type {string[]} */ ([]);
const lines = [`soak of ${Math.round((Date.now() - start) / 1000)} s: ${samples.length} rounds; medians of the second and of the last quarter`];
const of = (/** @type {Sample[]} */ part, /** @type {string} */ name) => median(part.map((sample) => sample[name]));
const machine = of(last, 'machine, ms') / of(second, 'machine, ms');
for (const name of Object.keys(samples[0] ?? {})) {
  const [before, after] = [of(second, name), of(last, name)];
  const ratio = after / before;
  lines.push(`${name.padEnd(20)} ${before.toFixed(1).padStart(12)} ${after.toFixed(1).padStart(12)}  × ${ratio.toFixed(4)}`);
  const most = name === 'page heap, bytes' ? MOST_WITH_CODE : MOST_GROWTH;
  if (name.endsWith('bytes') && !(ratio <= most)) wrong.push(`${name}: grew to ${ratio.toFixed(4)} times what it was`);
  // Others use the machine, too: what is slower only as it is, or only beside its pace, is not ours.
  if (name === 'evaluations/s' && Math.max(ratio, ratio * machine) < 1 / MOST_SLOWING) wrong.push(`searches became slower: × ${ratio.toFixed(2)}, the machine × ${(1 / machine).toFixed(2)}`);
  if (name === 'frame, ms' && Math.min(ratio, ratio / machine) > MOST_SLOWING) wrong.push(`frames became slower: × ${ratio.toFixed(2)}, the machine × ${machine.toFixed(2)}`);
}
const most = Math.max(...samples.map(({ workers, threads }) => Math.max(workers, threads)));
if (samples.length < 8) wrong.push(`only ${samples.length} rounds: give it more time`);
if (most > WORKERS + 1) wrong.push(`${most} workers live at rest`);
if (samples.some(({ workers }) => workers < WORKERS)) wrong.push('workers are missing at rest');
for (const complaint of page.complaints) wrong.push(complaint);
lines.push(...wrong.map((text) => `FAILED  ${text}`), wrong.length === 0 ? 'passed' : `${wrong.length} failed`);
console.log(lines.join('\n'));
if (file) await writeFile(file, `${lines.join('\n')}\n`);
await browser.close();
process.exit(wrong.length === 0 ? 0 : 1);
