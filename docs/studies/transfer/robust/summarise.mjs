// SPDX-License-Identifier: MIT
// The tables of question.md from robust.csv:   node docs/studies/transfer/robust/summarise.mjs
import { readFileSync } from 'node:fs';
import { holm } from '../../holm.mjs';
import { median } from '../../quantiles.mjs';
import { ENGINES } from '../engines.mjs';

const rows = readFileSync(new URL('robust.csv', import.meta.url), 'utf8').trim().split('\n').slice(1).map((row) => row.split(','))
  .map(([figure, joints, worlds, seed, own, ...ways]) => ({ figure, joints, worlds: Number(worlds), seed, own: Number(own), ways: ways.map(Number) }));

/** Whether a motion keeps half of its way in an engine. @param {{own: number, ways: number[]}} row @param {number} engine */
const keeps = ({ own, ways }, engine) => ways[engine] / own >= 0.5;
/** In at least two engines. @param {{own: number, ways: number[]}} row */
const travels = (row) => ENGINES.filter((_, engine) => keeps(row, engine)).length >= 2;

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

console.log(`| joints | worlds | found ≥ 1 m | median way | ${ENGINES.join(' | ')} | in two or more |`);
console.log(`|---|---|---|---|${ENGINES.map(() => '---|').join('')}---|`);
for (const joints of ['strong', 'limited']) {
  for (const worlds of [1, 5]) {
    const all = rows.filter((row) => row.joints === joints && row.worlds === worlds);
    const found = all.filter(({ own }) => Math.abs(own) >= 1);
    const each = ENGINES.map((_, engine) => `${found.filter((row) => keeps(row, engine)).length}`);
    console.log(`| ${joints} | ${worlds} | ${found.length} of ${all.length} | ${median(found.map(({ own }) => own)).toFixed(1)} m | ${each.join(' | ')} | ${share(found.filter(travels).length, found.length)} |`);
  }
}

const tests = ['strong', 'limited'].map((joints) => {
  const kept = (/** @type {number} */ worlds) => new Map(rows.filter((row) => row.joints === joints && row.worlds === worlds && Math.abs(row.own) >= 1)
    .map((row) => [`${row.figure} ${row.seed}`, travels(row)]));
  const [one, five] = [kept(1), kept(5)];
  const pairs = [...one].filter(([name]) => five.has(name)).map(([name, kind]) => [kind, five.get(name)]);
  const [gained, lost] = [pairs.filter(([a, b]) => !a && b).length, pairs.filter(([a, b]) => a && !b).length];
  return { joints, pairs: pairs.length, gained, lost, p: signTest(gained, lost) };
});
const adjusted = holm(tests.map(({ p }) => p));
tests.forEach(({ joints, pairs, gained, lost }, i) => console.log(`${joints}: of ${pairs} pairs five worlds gain ${gained}, lose ${lost}; p = ${adjusted[i].toPrecision(2)} (Holm)`));
