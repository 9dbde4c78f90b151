// SPDX-License-Identifier: MIT
// The answers of docs/physics.md from found.csv: how many clear the step, and how far controllers get on rubble that no search saw.
import { readFileSync } from 'node:fs';

const STEP_AT_M = 2, BEHIND_M = 1;
const rows = readFileSync(new URL('found.csv', import.meta.url), 'utf8').trim().split('\n').slice(1).map((line) => {
  const [searched, seed, on, travel] = line.split(',');
  return { searched, seed, on, metres: Math.abs(Number(travel)) };
});
const median = (/** @type {number[]} */ numbers) => {
  const sorted = numbers.toSorted((a, b) => a - b);
  return (sorted[(sorted.length - 1) >> 1] + sorted[sorted.length >> 1]) / 2;
};
const unseen = (/** @type {string} */ on) => Number(on.split(':')[1]) > 900;
for (const searched of new Set(rows.map((row) => row.searched))) {
  const own = rows.filter((row) => row.searched === searched && !unseen(row.on)).map(({ metres }) => metres);
  const bySeed = Map.groupBy(rows.filter((row) => row.searched === searched && unseen(row.on)), ({ seed }) => seed);
  const abroad = [...bySeed.values()].map((of) => median(of.map(({ metres }) => metres)));
  console.log(`${searched}: ${own.length} searches, median ${median(own).toFixed(2)} m there (${Math.min(...own).toFixed(2)} to ${Math.max(...own).toFixed(2)}); `
    + `on ten rubbles not seen, median of medians ${median(abroad).toFixed(2)} m`);
}
const step = rows.filter(({ searched, on }) => searched === 'step' && on === 'step');
console.log(`the step is cleared by ${step.filter(({ metres }) => metres >= STEP_AT_M + BEHIND_M).length} of ${step.length}`);
