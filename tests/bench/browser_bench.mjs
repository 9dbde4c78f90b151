// SPDX-License-Identifier: MIT
// Measures the built page in Chromium:  node tests/bench/browser_bench.mjs [folder, default build/site]
// Prints one JSON object. Compare figures of one machine at rest only.
import { execFileSync } from 'node:child_process';
import { readFile } from 'node:fs/promises';
import { cpus, loadavg } from 'node:os';
import { gzipSync } from 'node:zlib';
import { join } from 'node:path';
import { PageDriver } from '../browser/page_driver.mjs';
import { ROOT, serve, startChromium, stopAll } from '../browser/browsers.mjs';

/** @typedef {import('../browser/browsers.mjs').Browser} Browser */

const WARM_UP_MS = 2000; // the compiler's second pass is over by then
const MEASURE_MS = 6000;
const OPENINGS = 5;
// Mr. Star-Man, 10 rules, 5 s: the paper's own example.
const FIXED_SEARCH = { seed: 1, evaluations: 10000 };

/** @param {number[]} values */
const median = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];

/**
 * Motions that workers simulate per second, on an empty page: the canvas drawn in software would take a core.
 * @param {Browser} browser @param {string} address @param {string} document  JSON
 * @param {number} workers
 */
async function throughput(browser, address, document, workers) {
  const page = await (await browser.createBrowserContext()).newPage();
  await page.goto(`${address}an-empty-page`);
  const rate = await page.evaluate(async (options) => {
    const { Engine } = await import(new URL('engine.js', location.href).href);
    const { SearchClient } = await import(new URL('search_client.js', location.href).href);
    const compiled = await WebAssembly.compileStreaming(fetch(new URL('engine.wasm', location.href)));
    const engine = await Engine.load(compiled);
    /** @type {{ms: number, simulated: number}[]} */
    const seen = [];
    const client = new SearchClient({
      engine: compiled,
      createWorker: () => new Worker(new URL('worker.js', location.href), { type: 'module' }),
      listener: {
        progress: (/** @type {{simulated: number}} */ { simulated }) => seen.push({ ms: performance.now(), simulated }),
        incident: console.error,
        failed: console.error,
      },
    });
    client.start(engine.documentFromText(options.document), options.workers);
    await new Promise((resolve) => setTimeout(resolve, options.warmUp + options.measure));
    client.close();
    const last = seen[seen.length - 1];
    const first = seen.find(({ ms }) => ms > last.ms - options.measure) ?? seen[0];
    return Math.round((1000 * (last.simulated - first.simulated)) / (last.ms - first.ms));
  }, { document, workers, warmUp: WARM_UP_MS, measure: MEASURE_MS });
  await page.browserContext().close();
  return rate;
}

/** Seconds for a whole search in the page, as a visitor sees it. @param {PageDriver} driver @param {number} workers */
function wholeSearch(driver, workers) {
  return driver.page.evaluate(async (options) => {
    const start = performance.now();
    const { report } = await window.gaitsmith.synthesize(options);
    return { seconds: (performance.now() - start) / 1000, simulatedPerEvaluation: report.simulated / report.evaluations };
  }, /** @type {const} */ ({ ...FIXED_SEARCH, sense: 'physical', workers }));
}

/** Every file that the page loads until its first frame, gzipped. @param {Browser} browser @param {string} address */
async function bytesUntilFirstMotion(browser, address) {
  const page = await (await browser.createBrowserContext()).newPage();
  /** @type {Promise<[string, number, number]>[]} */
  const files = [];
  let counting = true;
  page.on('response', (response) => {
    if (!counting || response.status() !== 200) return;
    files.push(response.buffer().then((body) => [new URL(response.url()).pathname, body.length, gzipSync(body, { level: 9 }).length]));
  });
  await page.goto(address);
  await page.evaluate(() => window.gaitsmith.ready.then(() => true));
  counting = false;
  const loaded = await Promise.all(files);
  await page.browserContext().close();
  return {
    gzip: loaded.reduce((sum, [, , gzip]) => sum + gzip, 0),
    plain: loaded.reduce((sum, [, plain]) => sum + plain, 0),
    files: Object.fromEntries(loaded.map(([path, , gzip]) => [path, gzip])),
  };
}

/** WebAssembly memory of the page's application, and of a worker's engine at work. @param {Browser} browser @param {string} address */
async function memory(browser, address) {
  const page = await (await browser.createBrowserContext()).newPage();
  await page.evaluateOnNewDocument(() => {
    const original = WebAssembly.instantiateStreaming;
    WebAssembly.instantiateStreaming = async (...options) => {
      const result = await original(...options);
      for (const value of Object.values(result.instance.exports)) {
        const kept = /** @type {any} */ (window); // the application's is the first
        if (value instanceof WebAssembly.Memory) kept.benchMemory ??= value;
      }
      return result;
    };
  });
  await page.goto(address);
  const bytes = await page.evaluate(async () => {
    await window.gaitsmith.ready;
    await window.gaitsmith.synthesize({ evaluations: 2000, seed: 1 });
    const { Engine } = await import(new URL('engine.js', location.href).href);
    const engine = await Engine.load();
    const document = engine.documentFromText(window.gaitsmith.link());
    const search = engine.search(document);
    const evaluator = engine.evaluator(document);
    for (let i = 0; i < 20; i++) search.tell(evaluator.evaluate(search.ask(160)));
    return { page: /** @type {any} */ (window).benchMemory?.buffer.byteLength, worker: engine.memoryBytes };
  });
  const { JSHeapUsedSize } = await page.metrics();
  await page.browserContext().close();
  return { ...bytes, pageScriptHeap: JSHeapUsedSize };
}

const load = loadavg()[0];
const address = await serve(process.argv[2] ?? join(ROOT, 'build/site'));
const browser = await startChromium();
if (!browser) throw new Error('no Chromium: ./dev setup browsers');

const openings = [];
for (let i = 0; i < OPENINGS; i++) {
  const driver = await PageDriver.open(browser, address);
  openings.push(await driver.page.evaluate(() => performance.getEntriesByName('gaitsmith-first-frame')[0].startTime));
  await driver.close();
}
const driver = await PageDriver.open(browser, address);
const figure = JSON.parse(await readFile(join(ROOT, 'examples/figures/mr-star-man.json'), 'utf8'));
const ask = (/** @type {string} */ kind, /** @type {number} */ workers) => throughput(browser, address,
  JSON.stringify({ figure, senses: { kind }, search: { seed: 1, evaluations: 1e8 } }), workers);
const physical = await ask('physical', 1);
const timer = await ask('timer', 1);
const physicalTwo = await ask('physical', 2);
const timerTwo = await ask('timer', 2);
await driver.page.evaluate((document) => window.gaitsmith.open(document), { figure });
const one = await wholeSearch(driver, 1);
const two = await wholeSearch(driver, 2);
await driver.close();

console.log(JSON.stringify({
  cpu: cpus()[0]?.model,
  cores: cpus().length,
  loadBefore: load,
  browser: await browser.version(),
  commit: execFileSync('git', ['rev-parse', '--short', 'HEAD'], { cwd: ROOT, encoding: 'utf8' }).trim(),
  simulationsPerSecond: { physical, timer },
  twoWorkersOverOne: {
    physicalSimulations: physicalTwo / physical,
    timerSimulations: timerTwo / timer,
    wholeSearch: one.seconds / two.seconds,
  },
  wholeSearch: { ...FIXED_SEARCH, one, two },
  openToFirstFrameMs: { median: Math.round(median(openings)), all: openings.map(Math.round) },
  bytesUntilFirstMotion: await bytesUntilFirstMotion(browser, address),
  wasmMemoryBytes: await memory(browser, address),
}, null, 2));
await browser.close();
stopAll();
