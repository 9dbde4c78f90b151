// SPDX-License-Identifier: MIT
// The tables of question.md from robust.csv:   node docs/studies/transfer/robust/summarise.mjs
import { existsSync, readFileSync } from 'node:fs';
import { holm } from '../../holm.mjs';
import { median } from '../../quantiles.mjs';
import { ENGINES } from '../engines.mjs';

/** @param {string} file */
const table = (file) => readFileSync(new URL(file, import.meta.url), 'utf8').trim().split('\n').slice(1).map((row) => row.split(','));
/** @param {string} file @param {string} [kind]  in place of the number of worlds */
const motions = (file, kind) => table(file)
  .map(([figure, joints, worlds, seed, own, ...ways]) => ({ figure, joints, kind: kind ?? worlds, seed, own: Number(own), ways: ways.map(Number) }));
// The control was added after the first results.
const rows = [...motions('robust.csv'), ...motions('control.csv', '1, 4,000 evaluations')];
const KINDS = ['1', '1, 4,000 evaluations', '5'];

/** Whether a motion keeps half of its way in an engine. @param {{own: number, ways: number[]}} row @param {number} engine */
const keeps = ({ own, ways }, engine) => ways[engine] / own >= 0.5;
/** In at least two engines. @param {{own: number, ways: number[]}} row */
const travels = (row) => ENGINES.filter((_, engine) => keeps(row, engine)).length >= 2;

/** How far it comes in the second best engine. @param {{ways: number[]}} row */
const inSecondBest = ({ ways }) => [...ways].sort((a, b) => b - a)[1];

/** "12 of 30 (25 to 58 %)", with Wilson's interval. @param {number} count @param {number} n */
function share(count, n) {
  const z = 1.959964, p = count / n;
  const middle = (p + (z * z) / (2 * n)) / (1 + (z * z) / n);
  const half = (z / (1 + (z * z) / n)) * Math.sqrt((p * (1 - p)) / n + (z * z) / (4 * n * n));
  return `${count} of ${n} (${(100 * (middle - half)).toFixed(0)} to ${(100 * (middle + half)).toFixed(0)} %)`;
}

/** The chance of a split at least as uneven as a : b, if both sides are as likely. @param {number} a @param {number} b */
function signTest(a, b) {
  const n = a + b;
  let tail = 0, term = 0.5 ** n;
  for (let k = 0; k <= Math.min(a, b); k++) {
    tail += term;
    term *= (n - k) / (k + 1);
  }
  return Math.min(1, 2 * tail);
}

console.log(`| joints | worlds | found ≥ 1 m | median way | ${ENGINES.join(' | ')} | in two or more | way in the second best |`);
console.log(`|---|---|---|---|${ENGINES.map(() => '---|').join('')}---|---|`);
for (const joints of ['strong', 'limited']) {
  for (const kind of KINDS) {
    const all = rows.filter((row) => row.joints === joints && row.kind === kind);
    const found = all.filter(({ own }) => Math.abs(own) >= 1);
    const each = ENGINES.map((_, engine) => `${found.filter((row) => keeps(row, engine)).length}`);
    console.log(`| ${joints} | ${kind} | ${found.length} of ${all.length} | ${median(found.map(({ own }) => own)).toFixed(1)} m | ${each.join(' | ')} | ${share(found.filter(travels).length, found.length)} | ${median(found.map(inSecondBest)).toFixed(1)} m |`);
  }
}

/** Five worlds against one, pair by pair of figure and seed. @param {string} joints @param {string} other */
function against(joints, other) {
  const of = (/** @type {string} */ kind) => new Map(rows.filter((row) => row.joints === joints && row.kind === kind && Math.abs(row.own) >= 1).map((row) => [`${row.figure} ${row.seed}`, row]));
  const [one, five] = [of(other), of('5')];
  const pairs = [...one].flatMap(([name, row]) => (five.has(name) ? [[row, /** @type {typeof row} */ (five.get(name))]] : []));
  const [gained, lost] = [pairs.filter(([a, b]) => !travels(a) && travels(b)).length, pairs.filter(([a, b]) => travels(a) && !travels(b)).length];
  return { joints, other, pairs: pairs.length, gained, lost, further: pairs.filter(([a, b]) => inSecondBest(b) > inSecondBest(a)).length, p: signTest(gained, lost) };
}
for (const other of ['1', '1, 4,000 evaluations']) {
  const tests = ['strong', 'limited'].map((joints) => against(joints, other));
  const adjusted = holm(tests.map(({ p }) => p));
  tests.forEach(({ joints, pairs, gained, lost, further }, i) =>
    console.log(`${joints}, 5 worlds against ${other}: of ${pairs} pairs gained ${gained}, lost ${lost}; p = ${adjusted[i].toPrecision(2)} (Holm); further in the second best engine: ${further}`));
}

console.log('\n| joints | worlds | friction | mass | slope | delay | all at once |\n|---|---|---|---|---|---|---|');
for (const joints of ['strong', 'limited']) {
  for (const worlds of ['1', '5']) {
    const all = table('noise.csv').filter((row) => row[1] === joints && row[2] === worlds);
    console.log(`| ${joints} | ${worlds} | ${[4, 5, 6, 7, 8].map((column) => `${(all.reduce((sum, row) => sum + Number(row[column]), 0) / all.length / 0.15).toFixed(0)} %`).join(' | ')} |`);
  }
}

// The second round.
if (existsSync(new URL('second.csv', import.meta.url))) {
  const second = motions('second.csv');
  console.log(`\n| joints | kind | found ≥ 1 m | median way | ${ENGINES.join(' | ')} | in two or more | way in the second best |`);
  console.log(`|---|---|---|---|${ENGINES.map(() => '---|').join('')}---|---|`);
  /** @type {{joints: string, other: string, pairs: number, gained: number, lost: number, p: number}[]} */
  const tests = [];
  for (const joints of ['limited', 'strong']) {
    const of = (/** @type {string} */ kind) => second.filter((row) => row.joints === joints && row.kind === kind);
    for (const kind of ['one', 'five', 'short', 'finer']) {
      const found = of(kind).filter(({ own }) => Math.abs(own) >= 1);
      if (found.length === 0) continue;
      const each = ENGINES.map((_, engine) => `${found.filter((row) => keeps(row, engine)).length}`);
      console.log(`| ${joints} | ${kind} | ${found.length} of ${of(kind).length} | ${median(found.map(({ own }) => own)).toFixed(1)} m | ${each.join(' | ')} | ${share(found.filter(travels).length, found.length)} | ${median(found.map(inSecondBest)).toFixed(1)} m |`);
      if (kind === 'finer') continue;
      const finer = new Map(of('finer').filter(({ own }) => Math.abs(own) >= 1).map((row) => [`${row.figure} ${row.seed}`, row]));
      const pairs = found.flatMap((row) => { const other = finer.get(`${row.figure} ${row.seed}`); return other ? [[row, other]] : []; });
      const gained = pairs.filter(([a, b]) => !travels(a) && travels(b)).length, lost = pairs.filter(([a, b]) => travels(a) && !travels(b)).length;
      tests.push({ joints, other: kind, pairs: pairs.length, gained, lost, p: signTest(gained, lost) });
    }
  }
  // Six tests were promised: those that are not there yet show nothing.
  const adjustedP = holm([...tests.map(({ p }) => p), ...Array.from({ length: 6 - tests.length }, () => 1)]);
  tests.forEach(({ joints, other, pairs, gained, lost }, i) =>
    console.log(`${joints}, finer steps against ${other}: of ${pairs} pairs gained ${gained}, lost ${lost}; p = ${(adjustedP[i] ?? 1).toPrecision(2)} (Holm over 6)`));
}
