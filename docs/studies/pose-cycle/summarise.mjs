// SPDX-License-Identifier: MIT
// The table of docs/search.md, "Pose cycles", from the result files beside this one:
//   node docs/studies/pose-cycle/summarise.mjs build/release/shell/gaitsmith
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const PROBLEMS = ['star-man-travel', 'beryl-travel', 'fred-travel', 'inchworm-travel', 'hopper-jump'];
const [, , gaitsmith = ''] = process.argv;
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

/** The two-sided rank test between two files: effect size and p. @param {string[]} names */
function test(names) {
  const folder = mkdtempSync(join(tmpdir(), 'pose-cycle-'));
  const [first = '', second = ''] = names.map((name) => readFileSync(path(`${name}.csv`), 'utf8'));
  const rows = second.split('\n').slice(2).join('\n');
  writeFileSync(join(folder, 'both.csv'), first + rows);
  const pairs = execFileSync(gaitsmith, ['compare', '--summary', join(folder, 'both.csv')], { encoding: 'utf8' }).split('\n\n')[1] ?? '';
  rmSync(folder, { recursive: true });
  return rowsOf(pairs)[0] ?? {};
}

console.log('| | pose-cycle, 4,000 | SPHC, 40,000 | ratio of medians | passes SPHC after | p, alone |\n|---|---|---|---|---|---|');
for (const sense of ['physical', 'timer']) {
  for (const problem of PROBLEMS) {
    const names = ['pose-cycle', 'sphc'].map((search) => `${problem}-${sense}-${search}`);
    if (!names.every((name) => existsSync(path(`${name}.csv`)))) continue;
    const [ours, theirs] = names.map(bests);
    const [mine, goal] = [quantile(ours ?? [], 0.5), quantile(theirs ?? [], 0.5)];
    const { p } = test(names);
    console.log(`| ${problem}, ${sense} | ${cell(ours ?? [])} | ${cell(theirs ?? [])} | ${(mine / goal).toFixed(2)} | ${passes(names[0] ?? '', goal)} | ${p} |`);
  }
}
