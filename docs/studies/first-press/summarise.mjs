// SPDX-License-Identifier: MIT
// The table of docs/search.md, "The first press", from the result files beside this one:
//   node docs/studies/first-press/summarise.mjs
import { readdirSync, readFileSync } from 'node:fs';

const SECONDS = 8;
const BIRD_MPS = 2;
/** @param {string} name @returns {number[]} metres of every seed, ascending */
function metres(name) {
  const lines = readFileSync(new URL(`${name}.csv`, import.meta.url), 'utf8').trim().split('\n').filter((line) => !line.startsWith('#'));
  const travel = (lines[0] ?? '').split(',').indexOf('travel');
  return lines.slice(1).map((line) => Number(line.split(',')[travel])).sort((a, b) => a - b);
}
const median = (/** @type {number[]} */ sorted) => ((sorted[(sorted.length - 1) >> 1] ?? NaN) + (sorted[sorted.length >> 1] ?? NaN)) / 2;

console.log('| figure | SPHC, 40,000: median | fair bound | first press and *Try another*: least, median | seeds at the bound |');
console.log('|---|---|---|---|---|');
const names = readdirSync(new URL('.', import.meta.url)).filter((name) => name.endsWith('-sphc-8001.csv')).map((name) => name.slice(0, -'-sphc-8001.csv'.length));
for (const name of names) {
  const long = median(metres(`${name}-sphc-8001`)), bound = long / 2, quick = metres(`${name}-pose-cycle-4`);
  const met = quick.filter((distance) => distance >= bound).length;
  console.log(`| ${name} | ${long.toFixed(1)} m | ${bound.toFixed(1)} m | ${quick[0]?.toFixed(1)} m, ${median(quick).toFixed(1)} m | ${met} of ${quick.length} |`);
}
for (const first of [4, 13]) {
  const bird = metres(`ostrich-pose-cycle-${first}`);
  const met = bird.filter((distance) => distance >= BIRD_MPS * SECONDS).length;
  console.log(`\nostrich, seeds ${first} to ${first + bird.length - 1}: ${met} of ${bird.length} reach ${BIRD_MPS} m/s; least ${((bird[0] ?? 0) / SECONDS).toFixed(1)} m/s, median ${(median(bird) / SECONDS).toFixed(1)} m/s`);
}
