// SPDX-License-Identifier: MIT
// Measures the built page in Chromium:  node tests/bench/browser_bench.mjs [folder, default build/site]
// Claims (c), (d), (f) and (g) of docs/performance.md. Writes build/bench-browser.json. Only one page is open at a time:
// a visible one is drawn in software, which takes a core.
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { ROOT, serve, startChromium, stopAll } from '../browser/browsers.mjs';
import { keep, median } from './machine.mjs';
import { searchAlone, searchInPage } from './page_search.mjs';
import { bytesUntilFirstMotion, memory, openToFirstFrame } from './page_weight.mjs';

const OPENINGS = 5;
const ROUNDS = 3;
const FRAMES = 10;
const LIMIT_MS = 15000; // the whole paper's search takes 5 s once the goal is met
const SHORT_LIMIT_MS = 5000;
const ALGORITHMS = ['sphc', 'rgt'];

const figure = JSON.parse(await readFile(join(ROOT, 'examples/figures/mr-star-man.json'), 'utf8'));
/** The paper's experiment: ten rules of physical senses, 10 s, 40,000 evaluations. */
const PAPER = { figure, task: { duration_steps: 1000 }, search: { seed: 1, evaluations: 40000 } };
/** Long enough to be busy, short enough to repeat. */
const SHORT = { figure, task: { duration_steps: 500 }, search: { seed: 1, evaluations: 20000 } };

const address = await serve(process.argv[2] ?? join(ROOT, 'build/site'));
const browser = await startChromium();
if (!browser) throw new Error('no Chromium: ./dev setup browsers');

const openings = [];
for (let i = 0; i < OPENINGS; i++) openings.push(await openToFirstFrame(browser, address));

/** Evaluations per second, of what was done. @param {import('./page_search.mjs').Taken} taken */
const pace = (taken) => taken.evaluations / taken.seconds;
/** @type {{one: import('./page_search.mjs').Taken, two: import('./page_search.mjs').Taken}[]} */
const pairs = [];
for (let i = 0; i < ROUNDS; i++) {
  pairs.push({
    one: await searchAlone(browser, address, SHORT, 1, SHORT_LIMIT_MS),
    two: await searchAlone(browser, address, SHORT, 2, SHORT_LIMIT_MS),
  });
}
const alone = await searchAlone(browser, address, PAPER, 2, LIMIT_MS);
const capped = await searchInPage(browser, `${address}?fps=${FRAMES}`, PAPER, 2, LIMIT_MS);
const animating = await searchInPage(browser, address, PAPER, 2, LIMIT_MS);

await keep('browser', {
  browser: await browser.version(),
  twoWorkersOverOne: {
    simulatedPerSecond: median(pairs.map(({ one, two }) => two.simulatedPerSecond / one.simulatedPerSecond)),
    wholeSearch: median(pairs.map(({ one, two }) => pace(two) / pace(one))),
    pairs,
  },
  paper: { alone, capped, animating },
  openToFirstFrameMs: { median: median(openings), all: openings },
  bytesUntilFirstMotion: await bytesUntilFirstMotion(browser, address),
  wasmMemoryBytes: await memory(browser, address, ALGORITHMS),
});
await browser.close();
stopAll();
