// SPDX-License-Identifier: MIT
// The answers of docs/physics.md from found.csv: how many clear the step, how far controllers get on rubble that no search saw, and whether
// seeing the ground helps.
import { readFileSync } from 'node:fs';
import { holm } from '../holm.mjs';
import { rankSum } from '../rank_sum.mjs';

const STEP_AT_M = 2, BEHIND_M = 1;
const rows = readFileSync(new URL('found.csv', import.meta.url), 'utf8').trim().split('\n').slice(1).map((line) => {
  const [senses, searched, seed, on, travel] = line.split(',');
  return { arm: `${senses} on ${searched}`, seed, on, metres: Number(travel) };
});
const median = (/** @type {number[]} */ numbers) => {
  const sorted = numbers.toSorted((a, b) => a - b);
  return (sorted[(sorted.length - 1) >> 1] + sorted[sorted.length >> 1]) / 2;
};
const unseen = (/** @type {string} */ on) => Number(on.split(':')[1]) > 900;
/** @type {Map<string, {own: number[], abroad: number[]}>} */
const arms = new Map();
for (const arm of new Set(rows.map((row) => row.arm))) {
  const of = rows.filter((row) => row.arm === arm);
  const own = of.filter(({ on }) => !unseen(on)).map(({ metres }) => metres);
  const abroad = [...new Set(of.map(({ seed }) => seed))]
    .map((seed) => median(of.filter((row) => row.seed === seed && unseen(row.on)).map(({ metres }) => metres)));
  arms.set(arm, { own, abroad });
  console.log(`${arm}: ${own.length} searches, median ${median(own).toFixed(2)} m there (${Math.min(...own).toFixed(2)} to ${Math.max(...own).toFixed(2)}); `
    + `on ten rubbles not seen, median of medians ${median(abroad).toFixed(2)} m`);
}
for (const senses of ['physical', 'sight']) {
  const step = arms.get(`${senses} on step`)?.own ?? [];
  console.log(`the step is cleared by ${step.filter((metres) => metres >= STEP_AT_M + BEHIND_M).length} of ${step.length} with ${senses} senses`);
}
const pairs = [['step', 'own'], ['rubble', 'abroad']].map(([ground, which]) => {
  const of = (/** @type {string} */ senses) => arms.get(`${senses} on ${ground}`)?.[/** @type {'own' | 'abroad'} */ (which)] ?? [];
  return { ground, ...rankSum(of('sight'), of('physical')) };
});
const adjusted = holm(pairs.map(({ p }) => p));
pairs.forEach(({ ground, superiority }, at) => {
  console.log(`${ground}: a controller with sight gets further than one without with a chance of ${superiority.toFixed(2)}, p ${adjusted[at]?.toFixed(3)} (Holm)`);
});
