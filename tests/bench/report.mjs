// SPDX-License-Identifier: MIT
// Summarises the benchmarks' files in build/: goal, result, and whether it is met. Prints a table and writes
// build/bench-report.json. Omits benchmarks that have not run.
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { ROOT } from '../browser/browsers.mjs';
import { costs } from './cost_slopes.mjs';
import { keep } from './machine.mjs';

/** @typedef {{claim: string, what: string, goal: string, figure: string, met: boolean | null}} Row */

/** @param {string} name @returns {any} */
const load = (name) => {
  const path = join(ROOT, `build/bench-${name}.json`);
  return existsSync(path) ? JSON.parse(readFileSync(path, 'utf8')) : null;
};

const BUSY = 0.3; // cores

/** @type {Row[]} */
const rows = [];
/**
 * @param {string} claim @param {string} what
 * @param {number | null | undefined} value @param {'>=' | '<=' | ''} relation @param {number} goal
 * @param {string} unit @param {string} [note]
 */
function row(claim, what, value, relation, goal, unit, note = '') {
  if (value === null || value === undefined) return;
  const met = relation === '' ? null : relation === '>=' ? value >= goal : value <= goal;
  const sign = { '>=': '≥ ', '<=': '≤ ', '': '' }[relation];
  rows.push({
    claim, what, met,
    goal: relation === '' ? '' : `${sign}${goal}${unit}`,
    figure: `${Number(value.toPrecision(3))}${unit}${note && ` (${note})`}`,
  });
}

const rivals = load('rivals');
if (rivals) {
  const { peers } = rivals.motionsPerSecond;
  const best = rivals.overBox2d['wasm chromium'] ?? rivals.overBox2d['wasm node'];
  row('a', 'WASM ÷ Box2D native, peers’ scenario, Chromium', best, '>=', 25, '',
    `${peers['wasm chromium']?.median} against ${peers.box2d?.median}/s`);
  row('a', 'the same under Node', rivals.overBox2d['wasm node'], '', 0, '');
  row('a', 'the same, native gcc', rivals.overBox2d['native gcc'], '', 0, '', `${peers['native gcc']?.median}/s`);
  row('a', 'the same, native clang', rivals.overBox2d['native clang'], '', 0, '', `${peers['native clang']?.median ?? '-'}/s`);
  const limited = rivals.overBox2dLimited;
  row('a', 'WASM ÷ Box2D native, joints of limited strength, Chromium', limited['wasm chromium'] ?? limited['wasm node'], '>=', 10, '',
    `${rivals.motionsPerSecond['peers-limited']['wasm chromium']?.median} against ${rivals.motionsPerSecond['peers-limited'].box2d?.median}/s`);
  row('a', 'the same under Node', limited['wasm node'], '', 0, '');
  row('a', 'the same, native gcc', limited['native gcc'], '', 0, '');
  for (const [workload, { node, chromium }] of Object.entries(/** @type {Record<string, any>} */ (rivals.wasmOverFasterNative))) {
    row('b', `WASM ÷ faster native build, ${workload}`, chromium ?? node, '>=', 0.8, '', `Node ${node?.toFixed(2)}`);
  }
}

const browser = load('browser');
if (browser) {
  const { alone, capped, animating } = browser.paper;
  const rate = (/** @type {any} */ taken) => `${Math.round(taken.simulatedPerSecond)} motions/s`;
  const cut = (/** @type {any} */ taken) => (taken.whole ? '' : `, stopped at ${taken.evaluations}: the rest by its pace`);
  const whole = (/** @type {any} */ taken) => (taken.whole ? taken.seconds : (taken.seconds * 40000) / Math.max(1, taken.evaluations));
  const best = (/** @type {any} */ taken) => `shortest ${taken.shortestSeconds.toFixed(1)} s, ${rate(taken)}${cut(taken)}`;
  row('c', '40,000 evaluations, 2 workers, page at 10 frames/s', whole(capped), '<=', 5, ' s', best(capped));
  row('c', 'the same on an empty page', whole(alone), '<=', 5, ' s', best(alone));
  row('c', 'the same, the best animating', whole(animating), '<=', 3.5, ' s',
    `${animating.framesPerSecond.toFixed(0)} frames/s, ${rate(animating)}${cut(animating)}`);
  row('d', '2 workers ÷ 1, motions per second', browser.twoWorkersOverOne.simulatedPerSecond, '>=', 1.65, '');
  row('d', '2 workers ÷ 1, whole search', browser.twoWorkersOverOne.wholeSearch, '>=', 1.65, '');
  row('d', 'two native programs that share nothing ÷ one', browser.twoWorkersOverOne.coresAlone, '', 0, '');
}

for (const { what, value, relation, goal, unit, note } of costs(load('cost')?.benchmarks ?? [])) {
  row('e', what, value, relation, goal, unit, note);
}

if (browser) {
  row('f', 'first load until motion, gzip', browser.bytesUntilFirstMotion.gzip / 1000, '<=', 450, ' KB');
  row('f', 'open → first moving frame', browser.openToFirstFrameMs.median / 1000, '<=', 1, ' s');
  row('f', 'longest main-thread task while searching, its own work', browser.longestTask.processorMs, '<=', 33, ' ms');
  row('f', 'the same as a person waits for it', browser.paper.capped.longestStallMs, '<=', 33, ' ms',
    `${browser.paper.animating.longestStallMs.toFixed(0)} ms animating`);
  const mega = 1024 * 1024;
  for (const [algorithm, bytes] of Object.entries(/** @type {Record<string, number>} */ (browser.wasmMemoryBytes.workers))) {
    row('g', `a worker’s WASM memory, ${algorithm}`, bytes / mega, '<=', 16, ' MB');
  }
  row('g', 'the page’s WASM memory', browser.wasmMemoryBytes.page / mega, '<=', 64, ' MB');
}
const synthesize = load('synthesize');
row('g', 'gaitsmith synthesize, resident', synthesize?.residentBytes && synthesize.residentBytes / 1024 / 1024, '<=', 50, ' MB');

const python = load('python');
row('h', 'evaluate from Python ÷ native, medians of rounds in turn', python?.overNative, '>=', 0.9, '',
  python && `${Math.min(...python.rounds).toFixed(2)} to ${Math.max(...python.rounds).toFixed(2)}`);

/** @param {string} name @returns {[string, number][]} medians, or single results */
const native = (name) => (load(name)?.benchmarks ?? [])
  .filter((/** @type {any} */ one) => (one.aggregate_name ?? 'median') === 'median')
  .map((/** @type {any} */ one) => [one.run_name, one.items_per_second ?? one.cpu_time]);
await keep('report', {
  rows,
  motionsPerSecond: Object.fromEntries(native('evaluator')),
  nanosecondsPer64Motions: Object.fromEntries(native('cost')),
});
const mark = (/** @type {Row} */ { met }) => (met === null ? '' : met ? 'met' : 'NOT MET');
const table = [['', 'claim', 'goal', 'figure', ''], ...rows.map((one) => [one.claim, one.what, one.goal, one.figure, mark(one)])];
const widths = table[0].map((_, column) => Math.max(...table.map((line) => line[column].length)));
const machines = [rivals, browser, synthesize].filter(Boolean).map(({ machine }) => machine);
const busy = Math.max(0, ...machines.flatMap(({ busyCores }) => busyCores));
if (machines[0]) console.log(`${machines[0].cores} × ${machines[0].cpu}, commit ${machines[0].commit}`);
if (busy > BUSY) console.log(`Others kept ${busy.toFixed(1)} cores busy: only figures of rounds in turn, (a) and (b), mean something.`);
for (const line of table) console.log(line.map((cell, column) => cell.padEnd(widths[column])).join('  ').trimEnd());
