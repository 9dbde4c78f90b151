// SPDX-License-Identifier: MIT
// The table of docs/controllers-and-trajectories.md from switches.csv (question.md):  node docs/studies/nearness/summarise.mjs
import { readFileSync } from 'node:fs';
import { interval } from '../draws.mjs';
import { line, table } from '../tables.mjs';

const GROUPS = 10;
const all = readFileSync(new URL('switches.csv', import.meta.url), 'utf8').trim().split('\n').slice(1).map((line) => {
  const [, to = '', , , , success, distance] = line.split(',');
  return { to, senses: to.split('.')[0] ?? '', success: success === '1', distance: Number(distance) };
});
/** How often a failure is further away than a success, and among how many pairs. @param {typeof all} of */
function further(of) {
  const order = [...of].sort((a, b) => a.distance - b.distance);
  let successes = 0, pairs = 0;
  for (const { success } of order) success ? successes++ : pairs += successes;
  return { pairs, of: successes * (order.length - successes) };
}

for (const senses of [...new Set(all.map((one) => one.senses))]) {
  const of = all.filter((one) => one.senses === senses).sort((a, b) => a.distance - b.distance);
  console.log(`\n${senses}: ${of.length} switches, ${of.filter(({ success }) => success).length} succeed`);
  table(['distance', 'succeed']);
  for (let group = 0; group < GROUPS; group++) {
    const part = of.slice((group * of.length) / GROUPS, ((group + 1) * of.length) / GROUPS);
    line([`${part[0]?.distance.toFixed(2)} to ${part.at(-1)?.distance.toFixed(2)}`, `${((100 * part.filter(({ success }) => success).length) / part.length).toFixed(0)} %`]);
  }
  // Failures and successes are compared within each receiving controller, so that a good one is not taken for a near one.
  const receivers = [...new Set(of.map(({ to }) => to))].map((to) => further(of.filter((one) => one.to === to)));
  const chance = (/** @type {typeof receivers} */ some) => some.reduce((sum, { pairs }) => sum + pairs, 0) / some.reduce((sum, one) => sum + one.of, 0);
  const [low, high] = interval(receivers, chance);
  console.log(`\nwithin a controller a switch that fails is further away than one that succeeds with a chance of ${chance(receivers).toFixed(2)}`
    + ` (${low.toFixed(2)} to ${high.toFixed(2)})`);
}
