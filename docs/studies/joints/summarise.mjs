// SPDX-License-Identifier: MIT
// The table of docs/physics.md from travel.csv: for each kind of joints the median distance, and how many motions get as
// far as with free joints, within 5 %.
import { readFileSync } from 'node:fs';

const rows = readFileSync(new URL('travel.csv', import.meta.url), 'utf8').trim().split('\n').slice(1).map((line) => {
  const [motion, strength, stiffness, travel, broke] = line.split(',');
  return { motion, kind: `${strength} ${stiffness}`, travel: Number(travel), broke: broke === '1' };
});
const free = new Map(rows.filter(({ kind }) => kind === 'free 0').map(({ motion, travel }) => [motion, travel]));
const median = (/** @type {number[]} */ numbers) => {
  const sorted = numbers.toSorted((a, b) => a - b);
  return (sorted[(sorted.length - 1) >> 1] + sorted[sorted.length >> 1]) / 2;
};
for (const kind of new Set(rows.map((row) => row.kind))) {
  const these = rows.filter((row) => row.kind === kind);
  const same = these.filter(({ motion, travel }) => Math.abs(travel - (free.get(motion) ?? NaN)) <= 0.05 * Math.abs(free.get(motion) ?? NaN));
  console.log(`${kind}: ${these.length} motions, median distance ${median(these.map(({ travel }) => Math.abs(travel))).toFixed(1)} m, ${same.length} as far as free ones, ${these.filter(({ broke }) => broke).length} void`);
}
