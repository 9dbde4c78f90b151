// SPDX-License-Identifier: MIT
// The table of docs/search.md, "Bodies that evolve", from the result files beside this one:
//   node docs/studies/bodies/summarise.mjs build/release/shell/gaitsmith
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { holm } from '../holm.mjs';

const [, , gaitsmith = 'gaitsmith'] = process.argv;
const path = (/** @type {string} */ name) => fileURLToPath(new URL(`${name}.csv`, import.meta.url));
/** @param {string} name @returns {Record<string, string>[]} */
function rowsOf(name) {
  const [head = '', ...lines] = readFileSync(path(name), 'utf8').trim().split('\n').filter((line) => !line.startsWith('#'));
  return lines.map((line) => Object.fromEntries(line.split(',').map((value, i) => [head.split(',')[i], value])));
}
/** @param {string} name */
const bests = (name) => rowsOf(name).map(({ best }) => Number(best)).sort((a, b) => a - b);
/** @param {number[]} sorted @param {number} share */
function quantile(sorted, share) {
  const at = share * (sorted.length - 1), low = Math.floor(at);
  return (sorted[low] ?? 0) + (at - low) * ((sorted[Math.ceil(at)] ?? 0) - (sorted[low] ?? 0));
}
/** @param {number[]} all */
const cell = (all) => `${quantile(all, 0.5).toFixed(2)} (${quantile(all, 0.25).toFixed(2)}–${quantile(all, 0.75).toFixed(2)})`;
/** The chance that a run of the first ends better, and p. @param {string} a @param {string} b */
function ranks(a, b) {
  const words = execFileSync(gaitsmith, ['compare', `--summary=${path(a)}`, `--summary=${path(b)}`], { encoding: 'utf8' });
  const [, , , , , a12, p] = (words.trim().split('\n').at(-1) ?? '').split(',');
  return { a12: Number(a12), p: Number(p) };
}

const PROBLEMS = ['star-man-travel', 'beryl-travel', 'fred-travel', 'inchworm-travel', 'hopper-jump'];
const rows = [4000, 40000].filter((evaluations) => existsSync(fileURLToPath(new URL(`hopper-jump-lot-${evaluations}.csv`, import.meta.url)))).flatMap((evaluations) => PROBLEMS.map((problem) => ({
  problem, evaluations, name: (/** @type {string} */ body) => `${problem}-${body}-${evaluations}` })));
const tests = rows.flatMap(({ name }) => ['little', 'lot'].map((body) => ranks(name(body), name('none'))));
const adjusted = holm(tests.map(({ p }) => p));
const seconds = rowsOf('seconds');
/** @param {string} body @param {number} evaluations @param {string} problem */
const secondsOf = (body, evaluations, problem) => Number(seconds.find((row) => row.body === body && Number(row.evaluations) === evaluations && row.problem === problem)?.seconds);

console.log('| evaluations, problem | as drawn | a little | A12, p | a lot | A12, p | times the seconds |\n|---|---|---|---|---|---|---|');
rows.forEach(({ problem, evaluations, name }, i) => {
  /** @param {number} k */
  const test = (k) => `${tests[2 * i + k]?.a12.toFixed(2)}, ${(adjusted[2 * i + k] ?? 1) < 0.001 ? '< 0.001' : adjusted[2 * i + k]?.toFixed(3)}`;
  const slower = ['little', 'lot'].map((body) => (secondsOf(body, evaluations, problem) / secondsOf('none', evaluations, problem)).toFixed(1)).join(', ');
  console.log(`| ${evaluations.toLocaleString('en')}, ${problem} | ${cell(bests(name('none')))} | ${cell(bests(name('little')))} | ${test(0)} | ${cell(bests(name('lot')))} | ${test(1)} | ${slower} |`);
});
