// SPDX-License-Identifier: MIT
// Complete searches in Chromium: by workers on an empty page, and in the real page with the best motion animated.

/** @typedef {import('../browser/browsers.mjs').Browser} Browser */
/** @typedef {import('../../web/search/messages.js').SearchReport} SearchReport */

/**
 * The cost of a search.
 * @typedef {object} Taken
 * @property {number} seconds     from the request to the last report
 * @property {number} evaluations counted as in the serial search
 * @property {number} simulated   including discarded look-ahead
 * @property {number} simulatedPerSecond  after the workers have started
 * @property {boolean} whole      false: stopped at the limit
 */
/**
 * framesPerSecond: frames offered by the browser. A page with ?fps= draws fewer.
 * @typedef {Taken & {framesPerSecond: number, longestStallMs: number}} Visited
 */

// Wait before searching: a browser that has just opened a page is still busy, and a user would look first.
export const SETTLED_MS = 2000;

/**
 * Searches on an empty page, where nothing else runs. Stops a search at the limit.
 * @param {Browser} browser @param {string} address
 * @param {object} document  with its search settings
 * @param {number} workers @param {number} limitMs
 * @returns {Promise<Taken>}
 */
export async function searchAlone(browser, address, document, workers, limitMs) {
  const page = await (await browser.createBrowserContext()).newPage();
  await page.goto(`${address}an-empty-page`);
  const taken = await page.evaluate(async (text, count, limit, settled) => {
    const { Engine } = await import(new URL('search/engine.js', location.href).href);
    const { SearchClient } = await import(new URL('search/search_client.js', location.href).href);
    const compiled = await WebAssembly.compileStreaming(fetch(new URL('search/engine_module.wasm', location.href)));
    const engine = await Engine.load(compiled);
    /** @type {{ms: number, simulated: number} | null} */
    let first = null;
    /** @type {SearchReport} */
    const last = await new Promise((resolve, reject) => {
      const client = new SearchClient({
        engine: compiled,
        createWorker: () => new Worker(new URL('search/worker.js', location.href), { type: 'module' }),
        listener: {
          progress: (/** @type {SearchReport} */ report) => {
            if (report.simulated > 0) first ??= { ms: performance.now(), simulated: report.simulated };
            if (['done', 'stopped'].includes(report.state)) resolve(report);
          },
          incident: console.error,
          failed: reject,
        },
      });
      client.standBy(count);
      setTimeout(() => {
        performance.mark('bench-start');
        client.start(engine.documentFromText(text), count);
        setTimeout(() => client.stop(), limit); // no effect on a finished search
      }, settled);
    });
    const seconds = performance.measure('bench', 'bench-start').duration / 1000;
    const { ms, simulated } = /** @type {{ms: number, simulated: number}} */ (/** @type {unknown} */ (first));
    return {
      seconds,
      evaluations: last.evaluations,
      simulated: last.simulated,
      simulatedPerSecond: (1000 * (last.simulated - simulated)) / (performance.now() - ms),
      whole: last.state === 'done',
    };
  }, JSON.stringify(document), workers, limitMs, SETTLED_MS);
  await page.browserContext().close();
  return taken;
}

/**
 * Searches in the real page, with the same limit.
 * @param {Browser} browser
 * @param {string} address  with the page's options
 * @param {object} document  with its search settings
 * @param {number} workers @param {number} limitMs
 * @returns {Promise<Visited>}
 */
export async function searchInPage(browser, address, document, workers, limitMs) {
  const page = await (await browser.createBrowserContext()).newPage();
  await page.goto(address);
  const taken = await page.evaluate(async (opened, options, limit, settled) => {
    await window.gaitsmith.ready;
    window.gaitsmith.open(opened);
    await new Promise((resolve) => setTimeout(resolve, settled));
    let frames = 0, ticked = performance.now(), longest = 0, running = true;
    const frame = () => {
      frames++;
      if (running) requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
    // A message from a thread to itself arrives when the thread is free. Browsers may delay timers.
    const { port1, port2 } = new MessageChannel();
    const pause = 4;
    port1.onmessage = () => {
      const now = performance.now();
      longest = Math.max(longest, now - ticked - pause);
      ticked = now;
      if (running) setTimeout(() => port2.postMessage(0), pause);
    };
    const start = performance.now();
    ticked = start;
    port2.postMessage(0);
    const stop = setTimeout(() => window.gaitsmith.stop(), limit);
    const { report } = await window.gaitsmith.synthesize(options);
    clearTimeout(stop);
    running = false;
    const seconds = (performance.now() - start) / 1000;
    return {
      seconds,
      evaluations: report.evaluations,
      simulated: report.simulated,
      simulatedPerSecond: report.simulated / seconds,
      whole: report.state === 'done',
      framesPerSecond: frames / seconds,
      longestStallMs: longest,
    };
  }, document, { workers }, limitMs, SETTLED_MS);
  await page.browserContext().close();
  return taken;
}
