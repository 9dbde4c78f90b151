// SPDX-License-Identifier: MIT
// The tables of question.md from ways.csv and partings.csv:   node docs/studies/transfer/differences/summarise.mjs
import { readFileSync } from 'node:fs';
import { holm } from '../../holm.mjs';
import { line, table } from '../../tables.mjs';

/** @param {string} file @returns {Record<string, string>[]} */
function rows(file) {
  const [head = '', ...lines] = readFileSync(new URL(file, import.meta.url), 'utf8').trim().split('\n');
  const names = head.split(',');
  return lines.map((text) => Object.fromEntries(text.split(',').map((value, i) => [names[i], value])));
}
const ways = rows('ways.csv');
const columns = Object.keys(ways[0] ?? {}).slice(1);
/** How many come at least half as far as in another column. @param {string} column @param {string} as @param {typeof ways} [of] */
const kept = (column, as, of = ways) => of.filter((row) => Number(row[column]) / Number(row[as]) >= 0.5).length;

const last = columns.filter((name) => name.startsWith('own')).at(-1) ?? '';
// Added when the table was there: with fine steps here, what is left of a motion may be another one.
const lasting = ways.filter((row) => kept(last, 'own_1', [row]) === 1);
table(['', `of ${ways.length}: at least half of the way here`, `of the ${lasting.length} that keep it here with the finest steps`]);
for (const column of columns.slice(1)) line([column, `${kept(column, 'own_1')}`, `${kept(column, 'own_1', lasting)}`]);

/** The chance of at least so many heads of unequal coins. @param {number[]} coins @param {number} heads */
function atLeast(coins, heads) {
  let chances = [1];
  for (const p of coins) chances = Array.from({ length: chances.length + 1 }, (_, k) => (chances[k] ?? 0) * (1 - p) + (chances[k - 1] ?? 0) * p);
  return chances.slice(heads).reduce((sum, p) => sum + p, 0);
}
for (const [kind, what] of [['two_feet', 'a landing on two feet'], ['one_foot', 'a landing on one foot']]) {
  const tests = ['planck', 'rapier', 'mujoco'].map((engine) => {
    const parted = rows('partings.csv').filter((row) => row.engine === engine && row.step !== '');
    const coins = parted.map((row) => Number(row[`${kind}_share`])), found = parted.filter((row) => row[kind ?? ''] === '1').length;
    return { engine, parted: parted.length, found, expected: coins.reduce((sum, p) => sum + p, 0), p: atLeast(coins, found) };
  });
  const adjusted = holm(tests.map(({ p }) => p));
  table([`parted after ${what}`, 'of', 'expected', 'p (Holm over 3)']);
  tests.forEach(({ engine, parted, found, expected }, i) => line([`${engine}: ${found}`, `${parted}`, expected.toFixed(1), (adjusted[i] ?? 1).toPrecision(2)]));
}
for (const engine of ['planck', 'rapier', 'mujoco']) {
  const steps = rows('partings.csv').filter((row) => row.engine === engine && row.step !== '').map((row) => Number(row.step)).sort((a, b) => a - b);
  console.log(`${engine}: parted after ${(steps[steps.length >> 1] ?? 0) / 100} s (median of ${steps.length})`);
}
