// SPDX-License-Identifier: MIT
// How soon a person sees something, in Chromium: node tests/bench/live_bench.mjs [folder, default build/site] [runs]
// 1. From the press on a standing figure to its first gait, and to a good one: half of the median that 40,000 evaluations
//    of SPHC find (docs/studies/first-press). For every shipped figure, each in a new tab.
// 2. Live: from a change during a drag to the first preview for it, and the longest time between two frames, beside the
//    same drag without Live: what the machine needs for drawing alone.
// 3. The first press again, with workers at a quarter of their speed.
// Writes build/bench-live.json and prints the tables of docs/performance.md.
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { ROOT, serve, startChromium, stopAll } from '../browser/browsers.mjs';
import { keep, median } from './machine.mjs';
import { SETTLED_MS } from './page_search.mjs';
import { slowSite } from './slow_site.mjs';

/** @typedef {import('../browser/browsers.mjs').Browser} Browser */
/** @typedef {import('../browser/browsers.mjs').Page} Page */
/** Milliseconds; null: not within the limit. @typedef {{figure: string, firstMs: number | null, goodMs: number | null, endMs: number | null, best: number}} Press */
/** @typedef {{what: string, live: 'on' | 'off', previewMs: number | null, searches: number, frames: number, longestFrameMs: number, framesOver33: number, longestOwnMs: number}} Drag */

const STUDY = join(ROOT, 'docs/studies/first-press');
const LIMIT_MS = 15000;
const LEAST_M = 0.5; // less is a figure that falls over
const SHOWN_WITHIN_MS = 250; // after its end: previews follow one another no faster than 0.2 s

/** Half of SPHC's median [m], by figure. */
const GOOD = Object.fromEntries(readdirSync(STUDY).filter((name) => name.endsWith('-sphc-8001.csv')).map((name) => {
  const lines = readFileSync(join(STUDY, name), 'utf8').trim().split('\n').filter((line) => !line.startsWith('#'));
  const column = (lines[0] ?? '').split(',').indexOf('travel');
  return [name.slice(0, -'-sphc-8001.csv'.length), median(lines.slice(1).map((line) => Math.abs(Number(line.split(',')[column])))) / 2];
}));

/** @param {Browser} browser @param {string} address @returns {Promise<Page>} a new tab of a new visitor */
async function open(browser, address) {
  const page = await (await browser.createBrowserContext()).newPage();
  await page.goto(address);
  await page.evaluate((settled) => window.gaitsmith.ready.then(() => new Promise((resolve) => { setTimeout(resolve, settled); })), SETTLED_MS);
  return page;
}

/** The middle of a widget. @param {Page} page @param {string} id */
async function middle(page, id) {
  const rect = await page.evaluate((wanted) => window.gaitsmith.widgets().find((widget) => widget.id === wanted)?.rect, id);
  if (!rect) throw new Error(`no ${id} on the canvas`);
  return { x: rect.x + rect.width / 2, y: rect.y + rect.height / 2, width: rect.width };
}

/** Presses the large button with the mouse. @param {Browser} browser @param {string} address @param {string} figure @returns {Promise<Press>} */
async function press(browser, address, figure) {
  const page = await open(browser, `${address}?edit`);
  const shape = JSON.parse(readFileSync(join(ROOT, `examples/figures/${figure}.json`), 'utf8'));
  const standing = { figure: shape, task: { kind: 'travel-right', duration_steps: 800 }, search: { algorithm: 'pose-cycle', evaluations: 4000, seed: 4 } };
  await page.evaluate((document) => window.gaitsmith.open(document), standing);
  await new Promise((resolve) => { setTimeout(resolve, 500); });
  const { x, y } = await middle(page, 'stage/teach');
  const seen = page.evaluate((least, good, limit) => new Promise((resolve) => {
    let start = 0, best = 0;
    /** @type {Record<'firstMs' | 'goodMs' | 'endMs', number | null>} */
    const times = { firstMs: null, goodMs: null, endMs: null };
    const standing = JSON.stringify(window.gaitsmith.measures());
    addEventListener('pointerdown', () => { start = performance.now(); }, { once: true, capture: true });
    window.gaitsmith.on('done', () => { times.endMs ??= performance.now() - start; });
    const look = () => {
      const now = performance.now() - start;
      if (start > 0) {
        const measures = window.gaitsmith.measures();
        if (JSON.stringify(measures) !== standing) best = Math.max(best, Number(measures.distance ?? 0));
        if (best >= least) times.firstMs ??= now;
        if (best >= good) times.goodMs ??= now;
        if ((times.endMs !== null && now > times.endMs + 500) || now > limit) {
          resolve({ ...times, best });
          return;
        }
      }
      requestAnimationFrame(look);
    };
    requestAnimationFrame(look);
  }), LEAST_M, GOOD[figure] ?? Infinity, LIMIT_MS);
  // Slower than a frame: else the canvas has not seen what is under the pointer.
  await page.mouse.move(x, y);
  await new Promise((resolve) => { setTimeout(resolve, 100); });
  await page.mouse.click(x, y, { delay: 60 });
  const times = /** @type {Omit<Press, 'figure'>} */ (await seen);
  await page.browserContext().close();
  return { figure, ...times };
}

/** A control to drag: steps that show it ('!' runs a command, else a widget is clicked), then its widget. */
const SLIDERS = [
  { what: 'gravity', ready: ['world/open'], id: 'world/gravity' },
  { what: 'slope', ready: ['world/open'], id: 'world/slope' },
  { what: 'a weight', ready: ['!panel/Style'], id: 'style/upright' },
  { what: 'length of a limb', ready: ['!panel/Figure'], id: 'figure/length' },
];

/**
 * Drags a slider for two seconds, ten steps a second, and holds it.
 * @param {Browser} browser @param {string} address @param {{what: string, id: string, ready: string[]}} slider
 * @param {'on' | 'off'} live
 * @returns {Promise<Drag>}
 */
async function drag(browser, address, { what, id, ready }, live) {
  const page = await (await browser.createBrowserContext()).newPage();
  await page.evaluateOnNewDocument(() => {
    const log = /** @type {any} */ (window).benchLog = {
      began: /** @type {number[]} */ ([]), ended: /** @type {number[]} */ ([]), moved: /** @type {number[]} */ ([]),
      frames: /** @type {[number, string][]} */ ([]), own: /** @type {number[]} */ ([]),
    };
    const original = Worker.prototype.postMessage;
    const coordinators = new WeakSet();
    Worker.prototype.postMessage = function postMessage(/** @type {any} */ message, /** @type {any} */ options) {
      if (message.type === 'coordinate') {
        log.began.push(performance.now());
        if (!coordinators.has(this)) this.addEventListener('message', ({ data }) => { if (data.type === 'finished') log.ended.push(performance.now()); });
        coordinators.add(this);
      }
      return original.call(this, message, options);
    };
    const { requestAnimationFrame: ask } = window;
    window.requestAnimationFrame = (work) => ask((ms) => {
      const start = performance.now();
      work(ms);
      log.own.push(performance.now() - start);
    });
    addEventListener('pointermove', () => log.moved.push(performance.now()), { capture: true });
  });
  await page.goto(`${address}?open=star-man-shuffle`);
  await page.evaluate((settled) => window.gaitsmith.ready.then(() => new Promise((resolve) => { setTimeout(resolve, settled); })), SETTLED_MS);
  await page.evaluate((switched) => window.gaitsmith.arrange({ live: switched }), live);
  for (const step of ready) {
    if (step.startsWith('!')) await page.evaluate((command) => window.gaitsmith.run(command), step.slice(1));
    else {
      const { x, y } = await middle(page, step);
      await page.mouse.click(x, y);
    }
    await new Promise((resolve) => { setTimeout(resolve, 300); });
  }
  for (let turn = 0; turn < 20 && !await shows(page, id); turn++) {
    await page.mouse.move(1100, 500);
    await page.mouse.wheel({ deltaY: 120 });
    await new Promise((resolve) => { setTimeout(resolve, 100); });
  }
  const at = await middle(page, id);
  await page.mouse.move(at.x, at.y);
  await page.mouse.down();
  await page.evaluate(() => {
    const log = /** @type {any} */ (window).benchLog;
    log.moved.length = log.began.length = log.ended.length = log.own.length = 0;
    const look = () => {
      log.frames.push([performance.now(), JSON.stringify(window.gaitsmith.measures())]);
      requestAnimationFrame(look);
    };
    requestAnimationFrame(look);
  });
  for (let i = 1; i <= 20; i++) {
    await page.mouse.move(at.x + 0.01 * at.width * i, at.y);
    await new Promise((resolve) => { setTimeout(resolve, 100); });
  }
  await new Promise((resolve) => { setTimeout(resolve, 1500); });
  const { began, ended, moved, frames, own } = await page.evaluate(() => /** @type {any} */ (window).benchLog);
  await page.mouse.up();
  await page.browserContext().close();
  const last = moved.at(-1);
  // The frame after the move takes it to the document, the next one begins a search.
  const taken = frames.filter((/** @type {[number, string]} */ [ms]) => ms > last)[1]?.[0] ?? Infinity;
  const search = began.find((/** @type {number} */ ms) => ms > taken) ?? Infinity;
  // The preview for the change: what this search put on the stage, or what stood there, if it found nothing better.
  const end = ended.find((/** @type {number} */ ms) => ms > search) ?? Infinity;
  const changed = frames.find((/** @type {[number, string]} */ [ms, text], /** @type {number} */ i) => i > 0 && ms > search && text !== frames[i - 1][1])?.[0] ?? Infinity;
  const shown = changed <= end + SHOWN_WITHIN_MS ? changed : end;
  const gaps = frames.slice(1).map((/** @type {[number, string]} */ [ms], /** @type {number} */ i) => ms - frames[i][0]);
  return {
    what,
    live,
    previewMs: Number.isFinite(shown) ? shown - last : null,
    searches: began.length,
    frames: frames.length,
    longestFrameMs: Math.max(...gaps),
    framesOver33: gaps.filter((/** @type {number} */ gap) => gap > 33.4).length,
    longestOwnMs: Math.max(...own),
  };
}

/** @param {Page} page @param {string} id */
const shows = (page, id) => page.evaluate((wanted) => (window.gaitsmith.widgets().find((widget) => widget.id === wanted)?.rect.height ?? 0) >= 17, id);

/** @returns {never} */
function fail() { throw new Error('no Chromium: ./dev setup browsers'); }

const [folder = join(ROOT, 'build/site'), runs = '3', only = ''] = process.argv.slice(2);
const address = await serve(folder);
const browser = await startChromium() ?? fail();
const times = Array.from({ length: Number(runs) });
const figures = Object.keys(GOOD).filter((name) => name.includes(only));
const show = (/** @type {number | null} */ ms) => (ms === null ? '–' : (ms / 1000).toFixed(2));
const middleOf = (/** @type {(number | null)[]} */ values) => median(values.map((value) => value ?? Infinity));

/** @param {string[]} names @param {string} site */
async function presses(names, site) {
  /** @type {Press[]} */
  const rows = [];
  for (const figure of names) {
    /** @type {Press[]} */
    const all = [];
    for (const _ of times) all.push(await press(browser, site, figure));
    const row = { figure, firstMs: middleOf(all.map(({ firstMs }) => firstMs)), goodMs: middleOf(all.map(({ goodMs }) => goodMs)), endMs: middleOf(all.map(({ endMs }) => endMs)), best: all[0].best };
    rows.push(row);
    console.log(`| ${figure} | ${show(row.firstMs)} | ${show(row.goodMs)} | ${show(row.endMs)} | ${GOOD[figure].toFixed(1)} | ${row.best.toFixed(1)} |`);
  }
  console.log(`| median | ${show(middleOf(rows.map(({ firstMs }) => firstMs)))} | ${show(middleOf(rows.map(({ goodMs }) => goodMs)))} | ${show(middleOf(rows.map(({ endMs }) => endMs)))} | | |\n`);
  return rows;
}

console.log('| figure | first gait, s | good one, s | end, s | good from, m | found, m |\n|---|---|---|---|---|---|');
const pressed = await presses(figures, address);
console.log('Workers at a quarter of their speed:');
const slow = await presses(figures, await slowSite(folder));
console.log('| dragged | Live | preview, s | searches begun | longest frame, ms | frames over 33 ms | longest own work in a frame, ms |\n|---|---|---|---|---|---|---|');
/** @type {Drag[]} */
const dragged = [];
for (const slider of SLIDERS) {
  for (const _ of times) {
    for (const live of /** @type {const} */ (['on', 'off'])) {
      const row = await drag(browser, address, slider, live);
      dragged.push(row);
      console.log(`| ${row.what} | ${live} | ${show(row.previewMs)} | ${row.searches} | ${row.longestFrameMs.toFixed(0)} | ${row.framesOver33} of ${row.frames} | ${row.longestOwnMs.toFixed(0)} |`);
    }
  }
}
await keep('live', { browser: await browser.version(), pressed, slow, dragged });
await browser.close();
stopAll();
