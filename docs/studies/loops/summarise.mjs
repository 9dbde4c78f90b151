// SPDX-License-Identifier: MIT
// The table of docs/exporting.md from the rows beside this file:  node docs/studies/loops/summarise.mjs
import { readFileSync } from 'node:fs';
import { line, table } from '../tables.mjs';

/** @param {string} name @returns {Record<string, string>[]} */
function rows(name) {
  const [header, ...lines] = readFileSync(new URL(name, import.meta.url), 'utf8').trim().split('\n');
  const columns = (header ?? '').split(',');
  return lines.map((one) => {
    const [numbers = '', reason = ''] = one.split('"'); // the reason is the last column, and the only one in quotes
    const cells = numbers.split(',');
    return Object.fromEntries(columns.map((column, i) => [column, column === 'reason' ? reason : cells[i] ?? '']));
  });
}

const percent = (/** @type {string} */ rods) => `${(100 * Number(rods)).toFixed(1)} %`;
const halves = new Map(rows('halves.csv').map((row) => [row.document, row]));
const all = rows('whole.csv');
table(['motion', 'cycle', 'way', 'turns', 'like itself', 'gap before', 'slide', 'even halves']);
for (const row of all) {
  const name = row.document.replace(/^examples\/|\.json$/g, '');
  const half = halves.get(row.document);
  const even = half && half.found !== 'none' ? `${Number(half.period).toFixed(2)} s` : '–';
  if (row.found === 'none') line([name, `none: ${row.reason}`, '', '', '', '', '', even]);
  else line([name, `${Number(row.period).toFixed(2)} s${row.found === 'later' ? ', later' : ''}`, `${Number(row.distance).toFixed(2)} m`, row.turns, Number(row.likeness).toFixed(2), percent(row.gap), percent(row.slide), even]);
}
const loops = all.filter(({ found }) => found !== 'none');
console.log(`\n${loops.length} of ${all.length} loop, ${loops.filter(({ found }) => found === 'later').length} of them later; ${[...halves.values()].filter(({ found }) => found !== 'none').length} with even halves`);
