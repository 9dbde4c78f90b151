// SPDX-License-Identifier: MIT
// The table of docs/search.md, "Pose cycles", from the result files beside this one:
//   node docs/studies/pose-cycle/summarise.mjs
import { existsSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const PROBLEMS = ['star-man-travel', 'beryl-travel', 'fred-travel', 'inchworm-travel', 'hopper-jump'];
const path = (/** @type {string} */ name) => fileURLToPath(new URL(name, import.meta.url));
/** Lines of a CSV as objects. @param {string} text @returns {Record<string, string>[]} */
function rowsOf(text) {
  const [head = '', ...lines] = text.trim().split('\n').filter((line) => !line.startsWith('#'));
  const names = head.split(',');
  return lines.map((line) => Object.fromEntries(line.split(',').map((value, i) => [names[i], value])));
}

/** @param {string} name  of a result file */
const bests = (name) => rowsOf(readFileSync(path(`${name}.csv`), 'utf8')).map(({ best }) => Number(best)).sort((a, b) => a - b);
/** The value below which this share lies, between neighbours. @param {number[]} sorted @param {number} share */
function quantile(sorted, share) {
  const at = share * (sorted.length - 1), low = Math.floor(at);
  return (sorted[low] ?? 0) + (at - low) * ((sorted[Math.ceil(at)] ?? 0) - (sorted[low] ?? 0));
}
const cell = (/** @type {number[]} */ all) => `${quantile(all, 0.5).toFixed(2)} (${quantile(all, 0.25).toFixed(2)}–${quantile(all, 0.75).toFixed(2)})`;

/** Evaluations after which the median of the best so far is at least `goal`. @param {string} name @param {number} goal */
function passes(name, goal) {
  /** @type {Map<number, number[]>} */
  const at = new Map();
  for (const { evaluation, best } of rowsOf(readFileSync(path(`curves/${name}.csv`), 'utf8')))
    at.set(Number(evaluation), [...(at.get(Number(evaluation)) ?? []), Number(best)]);
  for (const [evaluation, all] of [...at].sort(([a], [b]) => a - b)) {
    if (quantile(all.sort((a, b) => a - b), 0.5) >= goal) return String(evaluation);
  }
  return 'not in 4000';
}

/** The chance that a run of the first kind ends better than one of the second [Vargha Delaney 2000]. @param {number[]} a @param {number[]} b */
function superiority(a, b) {
  const wins = a.flatMap((x) => b.map((y) => (x > y ? 1 : x === y ? 0.5 : 0)));
  return wins.reduce((/** @type {number} */ sum, one) => sum + one, 0) / wins.length;
}

console.log('| | pose-cycle, 4,000 | SPHC, 40,000 | ratio of medians | passes SPHC after | chance to be better |\n|---|---|---|---|---|---|');
for (const sense of ['physical', 'timer']) {
  for (const problem of PROBLEMS) {
    const names = ['pose-cycle', 'sphc'].map((search) => `${problem}-${sense}-${search}`);
    if (!names.every((name) => existsSync(path(`${name}.csv`)))) continue;
    const [ours, theirs] = names.map(bests);
    const [mine, goal] = [quantile(ours ?? [], 0.5), quantile(theirs ?? [], 0.5)];
    console.log(`| ${problem}, ${sense} | ${cell(ours ?? [])} | ${cell(theirs ?? [])} | ${(mine / goal).toFixed(2)} | ${passes(names[0] ?? '', goal)} | ${superiority(ours ?? [], theirs ?? []).toFixed(2)} |`);
  }
}
