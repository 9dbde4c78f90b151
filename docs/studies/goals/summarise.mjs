// SPDX-License-Identifier: MIT
// The table of docs/style.md, "Goals", and the counts below it, from the result files beside this one:
//   node docs/studies/goals/summarise.mjs
import { readFileSync } from 'node:fs';

const TO_OFFER = 16;
/** @param {string} name */
const rows = (name) => readFileSync(new URL(name, import.meta.url), 'utf8').trim().split('\n').slice(1)
  .map((line) => { const [figure = '', goal = '', strength = '', seeds, met] = line.split(','); return { figure, goal, strength, seeds: Number(seeds), met: Number(met) }; });
const goals = ['far', 'high-jump', 'cartwheel', 'glide', 'calm', 'head-up'];
const table = rows('table.csv'), tuning = rows('tuning-met.csv');
console.log(`| figure | ${goals.join(' | ')} |`);
console.log(`|${'---|'.repeat(goals.length + 1)}`);
for (const figure of new Set(table.map((row) => row.figure))) {
  const cells = goals.map((goal) => {
    const row = table.find((one) => one.figure === figure && one.goal === goal);
    return row ? `${row.met >= TO_OFFER ? row.met : `*${row.met}*`} (${row.strength})` : '';
  });
  console.log(`| ${figure} | ${cells.join(' | ')} |`);
}
const offered = table.filter(({ met }) => met >= TO_OFFER);
console.log(`\n${offered.length} of ${table.length} offered: ${goals.map((goal) => `${goal} ${offered.filter((row) => row.goal === goal).length}`).join(', ')}`);
/** @param {{seeds: number, met: number}[]} some */
const share = (some) => `${(100 * some.reduce((sum, { met }) => sum + met, 0) / some.reduce((sum, { seeds }) => sum + seeds, 0)).toFixed(0)} %`;
/** @param {{figure: string, goal: string, strength: string}} a */
const key = (a) => `${a.figure},${a.goal},${a.strength}`;
const chosen = new Set(table.map(key)), tuned = new Set(tuning.map(key));
console.log(`goals with a strength: ${share(tuning.filter((row) => chosen.has(key(row))))} of the tuning seeds, ${share(table.filter((row) => tuned.has(key(row))))} of the fresh ones`);
