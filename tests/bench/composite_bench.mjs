// SPDX-License-Identifier: MIT
// The cost of a change in a composite motion of 60 s in the page: moving a border, early and late, compared with
// simulating the whole motion again.
//   node tests/bench/composite_bench.mjs [folder of the site, default build/site]
import { join } from 'node:path';
import { PageDriver } from '../browser/page_driver.mjs';
import { ROOT, serve, startChromium, stopAll } from '../browser/browsers.mjs';

const CHANGES = 31;

/** @param {number[]} values */
const median = (values) => values.sort((a, b) => a - b)[Math.floor(values.length / 2)];

const address = await serve(process.argv[2] ?? join(ROOT, 'build/site'));
const browser = await startChromium();
try {
  if (!browser) throw new Error('Chromium is not here: ./dev setup browsers');
  const { page } = await PageDriver.open(browser, address, { plays: true });
  const times = await page.evaluate(async (changes) => {
    const { gaitsmith } = window;
    const document = /** @type {any} */ (gaitsmith.document());
    const first = document.timeline[0];
    /** Moves a border, or changes the ground. @param {number} clip @param {number} change */
    const composite = (clip, change) => ({ ...document, hash: undefined, duration_steps: 6000,
      environment: { ...document.environment, friction: clip === 0 ? 0.8 + 0.001 * change : 0.8 },
      timeline: Array.from({ length: 12 }, (_, i) => ({ ...first, start_step: 500 * i + (i > 0 && i === clip ? change : 0) })) });
    const frame = () => new Promise((resolve) => requestAnimationFrame(resolve));
    /** @param {number} clip */
    const measure = async (clip) => {
      const spent = [];
      gaitsmith.open(composite(clip, 0));
      for (let i = 1; i <= changes; i++) {
        await frame();
        const start = performance.now();
        gaitsmith.open(composite(clip, i));
        spent.push(performance.now() - start);
      }
      return spent;
    };
    return { 'all anew': await measure(0), 'first border moved': await measure(1), 'last border moved': await measure(11) };
  }, CHANGES);
  for (const [name, spent] of Object.entries(times)) console.log(`${name}: ${median(spent).toFixed(1)} ms, at most ${Math.max(...spent).toFixed(1)} ms`);
} finally {
  stopAll();
}
