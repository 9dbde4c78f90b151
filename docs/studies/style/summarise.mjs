// SPDX-License-Identifier: MIT
// The table of docs/style.md from the result files beside this one:  node docs/studies/style/summarise.mjs
import { readdirSync, readFileSync } from 'node:fs';
import { cartwheel, shuffle, travel } from './kinds.mjs';

const here = new URL('.', import.meta.url);
/** @type {Record<string, string[]>} */
const studies = {};
for (const file of readdirSync(here)) {
  const name = /^(.*)-(physical|timer)-(none|slip_sum|rotations|max_cm_height)\.csv$/.exec(file);
  if (name) (studies[`${name[1]},${name[2]}`] ??= []).push(name[3]);
}

/** The trials of one cell. @param {string} cell @param {string} term @returns {Record<string, number>[]} */
function trials(cell, term) {
  const [, columns, ...rows] = readFileSync(new URL(`${cell.replace(',', '-')}-${term}.csv`, here), 'utf8').trim().split('\n');
  const names = columns.split(',');
  return rows.map((row) => Object.fromEntries(row.split(',').map((value, i) => [names[i], Number(value)])));
}
/** @param {number[]} values */
function median(values) {
  const sorted = [...values].sort((a, b) => a - b);
  const middle = sorted.length / 2;
  return sorted.length % 2 ? sorted[Math.floor(middle)] : (sorted[middle - 1] + sorted[middle]) / 2;
}
console.log('| problem | senses | term | seeds that raise it | its median: without, with | travel: median with ÷ without | seeds of the kind asked for |');
console.log('|---|---|---|---|---|---|---|');
for (const [cell, terms] of Object.entries(studies)) {
  const plain = trials(cell, 'none');
  for (const term of terms) {
    if (term === 'none') continue;
    const styled = trials(cell, term);
    const usual = median(plain.map((trial) => trial[term]));
    const raised = styled.filter((trial) => trial[term] > usual).length;
    const kept = median(styled.map(travel)) / median(plain.map(travel));
    const kind = !cell.startsWith('star-man') ? ''
      : term === 'slip_sum' ? `${styled.filter(shuffle).length} shuffles`
      : term === 'rotations' ? `${styled.filter(cartwheel).length} cartwheels` : '';
    console.log(`| ${cell.replace(',', ' | ')} | ${term} | ${raised} of ${styled.length} | ${usual.toFixed(2)}, ` +
      `${median(styled.map((t) => t[term])).toFixed(2)} | ${kept.toFixed(2)} | ${kind} |`);
  }
  console.log(`| ${cell.replace(',', ' | ')} | none | | | ${median(plain.map(travel)).toFixed(1)} m | ` +
    `${plain.filter((t) => t.rotations < 0.25).length} hardly turn, ${plain.filter((t) => t.rotations >= 2).length} turn twice |`);
}

console.log('\n| Beryl, timer of | travel | turns | slip ÷ travel | endpoints that bear load | shuffles | turn over |');
console.log('|---|---|---|---|---|---|---|');
for (const period of ['0.5', '1', '12']) {
  const found = trials('beryl-travel,timer', `period-${period}`);
  console.log(`| ${period} s | ${median(found.map(travel)).toFixed(1)} m | ${median(found.map((t) => t.rotations)).toFixed(2)} | ` +
    `${median(found.map((t) => t.slip_sum / travel(t))).toFixed(2)} | ${median(found.map((t) => t.bearers))} | ` +
    `${found.filter(shuffle).length} of ${found.length} | ${found.filter((t) => t.rotations >= 0.5).length} of ${found.length} |`);
}
console.log('\n| Star-Man, seeds 21 to 40 | shuffles, slip weighed | cartwheels, rotations weighed |');
console.log('|---|---|---|');
for (const sense of ['physical', 'timer']) {
  const slipping = trials(`star-man-travel,${sense}`, 'fresh-slip_sum');
  const turning = trials(`star-man-travel,${sense}`, 'fresh-rotations');
  console.log(`| ${sense} | ${slipping.filter(shuffle).length} of ${slipping.length} | ${turning.filter(cartwheel).length} of ${turning.length} |`);
}
