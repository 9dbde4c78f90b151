// SPDX-License-Identifier: MIT
// The size of the page: bytes and time until the first motion, and memory in use.
import { gzipSync } from 'node:zlib';

/** @typedef {import('../browser/browsers.mjs').Browser} Browser */

/** Milliseconds from opening to the first moving frame. @param {Browser} browser @param {string} address */
export async function openToFirstFrame(browser, address) {
  const page = await (await browser.createBrowserContext()).newPage();
  await page.goto(address);
  const ms = await page.evaluate(async () => {
    await window.gaitsmith.ready;
    return performance.getEntriesByName('gaitsmith-first-frame')[0].startTime;
  });
  await page.browserContext().close();
  return ms;
}

/** Every file that the page loads before its first frame, gzipped. @param {Browser} browser @param {string} address */
export async function bytesUntilFirstMotion(browser, address) {
  const page = await (await browser.createBrowserContext()).newPage();
  /** By path: plain and compressed size; null: its page was closed. @type {[string, Promise<[number, number] | null>][]} */
  const files = [];
  page.on('response', (response) => {
    if (response.status() !== 200) return;
    files.push([new URL(response.url()).pathname, response.buffer().then((body) => [body.length, gzipSync(body, { level: 9 }).length], () => null)]);
  });
  await page.goto(address);
  // By the page's own clock: on a busy machine much may have arrived by the time that we hear of the first frame.
  const first = new Set(await page.evaluate(() => window.gaitsmith.ready.then(() => {
    const [{ startTime: shown }] = performance.getEntriesByName('gaitsmith-first-frame');
    return [location.pathname, ...performance.getEntriesByType('resource').filter(({ startTime }) => startTime < shown).map(({ name }) => new URL(name).pathname)];
  })));
  const loaded = await Promise.all(files.filter(([path]) => first.has(path)).map(async ([path, sizes]) => {
    const [plain, gzip] = await sizes ?? fail(path);
    return { path, plain, gzip };
  }));
  await page.browserContext().close();
  return {
    gzip: loaded.reduce((sum, { gzip }) => sum + gzip, 0),
    plain: loaded.reduce((sum, { plain }) => sum + plain, 0),
    files: Object.fromEntries(loaded.map(({ path, gzip }) => [path, gzip])),
  };
}

/** @param {string} path @returns {never} */
function fail(path) { throw new Error(`${path} could not be read`); }

/**
 * WebAssembly memory by algorithm: of the page's application after a search, and of an engine in both roles of a
 * worker.
 * @param {Browser} browser @param {string} address @param {string[]} algorithms
 */
export async function memory(browser, address, algorithms) {
  const page = await (await browser.createBrowserContext()).newPage();
  await page.evaluateOnNewDocument(() => {
    const original = WebAssembly.instantiateStreaming;
    WebAssembly.instantiateStreaming = async (...options) => {
      const result = await original(...options);
      for (const value of Object.values(result.instance.exports)) {
        const kept = /** @type {any} */ (window); // the first memory is the application's
        if (value instanceof WebAssembly.Memory) kept.benchMemory ??= value;
      }
      return result;
    };
  });
  await page.goto(address);
  const bytes = await page.evaluate(async (names) => {
    await window.gaitsmith.ready;
    await window.gaitsmith.synthesize({ evaluations: 2000, seed: 1 });
    const { Engine } = await import(new URL('search/engine.js', location.href).href);
    const workers = /** @type {Record<string, number>} */ ({});
    const shown = /** @type {any} */ (window.gaitsmith.document());
    for (const algorithm of names) {
      const engine = await Engine.load();
      const text = JSON.stringify({ figure: shown.figure, search: { algorithm, evaluations: 100000 } });
      const document = engine.documentFromText(text);
      const search = engine.search(document);
      const evaluator = engine.evaluator(document);
      for (let i = 0; i < 12; i++) search.tell(evaluator.evaluate(search.ask(160)));
      workers[algorithm] = engine.memoryBytes;
    }
    return { page: /** @type {any} */ (window).benchMemory?.buffer.byteLength, workers };
  }, algorithms);
  const { JSHeapUsedSize } = await page.metrics();
  await page.browserContext().close();
  return { ...bytes, pageScriptHeap: JSHeapUsedSize };
}
