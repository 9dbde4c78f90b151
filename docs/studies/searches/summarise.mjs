// SPDX-License-Identifier: MIT
// The tables of docs/search.md from the result files beside this one:
//   node docs/studies/searches/summarise.mjs build/release/shell/gaitsmith
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const PROBLEMS = ['star-man-travel', 'beryl-travel', 'fred-travel', 'inchworm-travel', 'hopper-jump'];
const SEARCHES = ['rgt', 'gga', 'ssga', 'shc', 'sphc', 'gga:genetic.rates=per-component', 'ssga:genetic.rates=per-component'];
const [, , gaitsmith] = process.argv;
const path = (/** @type {string} */ name) => fileURLToPath(new URL(`${name}.csv`, import.meta.url));
const short = (/** @type {string} */ search) => search.replace(':genetic.rates=per-component', ' per component');

/** Lines of a CSV as fields. @param {string} text */
const fields = (text) => text.trim().split('\n').slice(1).map((line) => line.split(','));

/**
 * What `compare --summary` says of a file.
 * @param {string} name @returns {{median: Record<string, number[]>, p: Record<string, number>}} by search: n, median, quartiles; by pair
 */
function summary(name) {
  const [some, pairs] = execFileSync(gaitsmith, ['compare', '--summary', path(name)], { encoding: 'utf8' }).split('\n\n');
  return {
    median: Object.fromEntries(fields(some).map(([, search, ...numbers]) => [search, numbers.map(Number)])),
    p: Object.fromEntries(fields(pairs).flatMap(([, a, b, , , , p]) => [[`${a}|${b}`, Number(p)], [`${b}|${a}`, Number(p)]])),
  };
}
const cell = (/** @type {number[] | undefined} */ numbers) =>
  (numbers ? `${numbers[1].toFixed(2)} (${numbers[2].toFixed(2)}–${numbers[3].toFixed(2)})${numbers[0] < 20 ? ` n ${numbers[0]}` : ''}` : '');

for (const sense of ['physical', 'timer']) {
  const shown = sense === 'physical' ? SEARCHES : SEARCHES.slice(0, 5);
  console.log(`\n| ${sense} | ${shown.map(short).join(' | ')} |\n|---${'|---'.repeat(shown.length)}|`);
  for (const problem of PROBLEMS) {
    if (!existsSync(path(`${problem}-${sense}`))) continue;
    const { median } = summary(`${problem}-${sense}`);
    console.log(`| ${problem} | ${shown.map((search) => cell(median[search])).join(' | ')} |`);
  }
}

console.log('\nBest first; `>`: better than the next with p < 0.05 (Holm over all pairs of the problem), `≈`: not to be told apart.\n');
for (const sense of ['physical', 'timer']) {
  for (const problem of PROBLEMS) {
    if (!existsSync(path(`${problem}-${sense}`))) continue;
    const { median, p } = summary(`${problem}-${sense}`);
    const order = Object.keys(median).sort((a, b) => median[b][1] - median[a][1]);
    const words = order.map((search, i) =>
      short(search) + (i + 1 < order.length ? (p[`${search}|${order[i + 1]}`] < 0.05 ? ' > ' : ' ≈ ') : ''));
    console.log(`- ${problem}, ${sense}: ${words.join('')}`);
  }
}

for (const name of ['few', 'others', 'parallel-ga', 'as-long']) {
  if (!existsSync(path(`star-man-travel-${name}`))) continue;
  const { median } = summary(`star-man-travel-${name}`);
  console.log(`\n| ${name} | median (quartiles) |\n|---|---|`);
  for (const [search, numbers] of Object.entries(median)) console.log(`| \`${search}\` | ${cell(numbers)} |`);
}

if (existsSync(path('star-man-travel-refined'))) {
  // Each problem of this file is one of SPHC's twenty documents; the first search's best cannot be below its start.
  const start = Object.fromEntries(fields(readFileSync(path('star-man-travel-physical'), 'utf8')).slice(1)
    .filter(([, search]) => search === 'sphc').map(([, , seed, , best]) => [`sphc-${seed}`, Number(best)]));
  /** @type {Record<string, number[]>} */
  const gains = {};
  for (const [problem, search, , , best] of fields(readFileSync(path('star-man-travel-refined'), 'utf8')).slice(1))
    (gains[search] ??= []).push(Number(best) / start[problem] - 1);
  console.log('\n| refiner | median gain | least, greatest | n |\n|---|---|---|---|');
  for (const [search, all] of Object.entries(gains)) {
    all.sort((a, b) => a - b);
    const percent = (/** @type {number} */ share) => `${(100 * share).toFixed(1)} %`;
    const median = (all[Math.floor((all.length - 1) / 2)] + all[Math.ceil((all.length - 1) / 2)]) / 2;
    console.log(`| \`${search}\` | ${percent(median)} | ${percent(all[0])}, ${percent(all[all.length - 1])} | ${all.length} |`);
  }
}
