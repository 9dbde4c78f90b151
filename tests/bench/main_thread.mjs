// SPDX-License-Identifier: MIT
// The work of the page's main thread during a search. Measures its processor time too, because waiting time also
// depends on other threads, such as two workers on two cores.
import { mkdtemp, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

/** @typedef {{name: string, cat: string, ph: string, pid: number, tid: number, ts: number, dur?: number, tdur?: number, args?: any}} TraceEvent */

/**
 * The longest task of the page's main thread during a search, from the browser's trace.
 * @param {import('../browser/browsers.mjs').Browser} browser @param {string} address  with the page's options
 * @param {object} document  with its search settings
 * @param {number} workers @param {number} settledMs
 * @returns {Promise<{wallMs: number, processorMs: number}>} the largest of each, possibly of different tasks
 */
export async function longestTask(browser, address, document, workers, settledMs) {
  const folder = await mkdtemp(join(tmpdir(), 'gaitsmith-trace-'));
  const path = join(folder, 'trace.json');
  const page = await (await browser.createBrowserContext()).newPage();
  await page.goto(address);
  await page.evaluate((opened, settled) => window.gaitsmith.ready.then(() => {
    window.gaitsmith.open(opened);
    return new Promise((resolve) => { setTimeout(resolve, settled); });
  }), document, settledMs);
  await page.tracing.start({ path, categories: ['toplevel', 'blink.user_timing'] });
  await page.evaluate(async (options) => {
    performance.mark('bench-search');
    await window.gaitsmith.synthesize(options);
    performance.mark('bench-searched');
  }, { workers });
  await page.tracing.stop();
  await page.browserContext().close();

  /** @type {TraceEvent[]} */
  const events = JSON.parse(await readFile(path, 'utf8')).traceEvents;
  await rm(folder, { recursive: true });
  const begin = events.find(({ name }) => name === 'bench-search');
  const end = events.find(({ name }) => name === 'bench-searched');
  if (!begin || !end) throw new Error('the trace does not show the search');
  const tasks = events.filter(({ name, ph, pid, tid, ts }) => name.endsWith('RunTask') && ph === 'X' && pid === begin.pid
    && tid === begin.tid && ts > begin.ts && ts < end.ts);
  if (tasks.length === 0) throw new Error('the trace shows no task of the page');
  const longest = (/** @type {'dur' | 'tdur'} */ clock) => Math.max(...tasks.map((task) => (task[clock] ?? 0) / 1000));
  return { wallMs: longest('dur'), processorMs: longest('tdur') };
}
