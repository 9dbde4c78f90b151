// SPDX-License-Identifier: MIT
// How soon each rival showed a near motion, from tasters/*.json: node docs/studies/taste/summarise.mjs [--tune]
import { readdirSync, readFileSync } from 'node:fs';

const folder = new URL(process.argv.includes('--tune') ? 'tuning/' : 'tasters/', import.meta.url);
/** @type {{figure: string, yardstick: number, start: number, eye: number[], taste: number[], pairs: number[]}[]} */
const tasters = readdirSync(folder).filter((name) => name.endsWith('.json')).map((name) => JSON.parse(readFileSync(new URL(name, folder), 'utf8')));
const n = tasters.length;
/** Wilson's 95 % interval, in tasters. @param {number} met */
function interval(met) {
  const z = 1.96, p = met / n;
  const middle = (p + z * z / (2 * n)) / (1 + z * z / n);
  const half = (z * Math.sqrt(p * (1 - p) / n + z * z / (4 * n * n))) / (1 + z * z / n);
  return `${(n * (middle - half)).toFixed(0)}–${(n * (middle + half)).toFixed(0)}`;
}
/** @param {number[]} values */
const median = (values) => {
  const sorted = [...values].sort((a, b) => a - b);
  return ((sorted[Math.floor((sorted.length - 1) / 2)] ?? 0) + (sorted[Math.ceil((sorted.length - 1) / 2)] ?? 0)) / 2;
};
for (const rival of /** @type {const} */ (['eye', 'taste', 'pairs'])) {
  const steps = Math.max(...tasters.map((taster) => taster[rival].length));
  console.log(`\n| ${rival} | near, of ${n} | 95 % | median share of the way from the first motion to the yardstick |\n|---|---|---|---|`);
  for (let step = 1; step <= steps; step++) {
    const bests = tasters.map((taster) => ({ best: taster[rival][Math.min(step, taster[rival].length) - 1] ?? taster.start, ...taster }));
    const met = bests.filter(({ best, yardstick }) => best >= yardstick - 0.1 * Math.abs(yardstick)).length;
    const share = median(bests.map(({ best, yardstick, start }) => (best - start) / Math.max(1e-9, yardstick - start)));
    console.log(`| ${step} | ${met} | ${interval(met)} | ${share.toFixed(2)} |`);
  }
}
