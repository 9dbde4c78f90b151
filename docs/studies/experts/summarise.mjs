// SPDX-License-Identifier: MIT
// The tables of docs/search.md from the result files beside this one (question.md):  node docs/studies/experts/summarise.mjs
import { readFileSync } from 'node:fs';
import { holm } from '../holm.mjs';
import { median, spread } from '../quantiles.mjs';
import { rankSum } from '../rank_sum.mjs';
import { chance, line, table } from '../tables.mjs';

const CELLS = ['star-man-travel', 'inchworm-travel'].flatMap((problem) => ['physical', 'timer'].map((sense) => ({ problem, sense })));
const PAIRS = [['de:difference.population=100:difference.weight=0.5:difference.crossover=0.2', 'ssga'], ['cma-es:cma.restarts=bipop', 'cma-es'], ['ssga:genetic.niching=kept', 'ssga'], ['gga:genetic.niching=kept', 'gga'],
  ['map-elites:elites.crossover=0.5', 'map-elites'], ['cma-mae', 'map-elites'], ['nsga-ii', 'ssga']];
const MAPS = PAIRS.filter(([first = '']) => first.startsWith('map-elites') || first === 'cma-mae');

/** The rows of a file. @param {string} name @returns {Record<string, string>[]} */
function rows(name) {
  const lines = readFileSync(new URL(`${name}.csv`, import.meta.url), 'utf8').trim().split('\n').filter((each) => !each.startsWith('#'));
  const names = (lines.shift() ?? '').split(',');
  return lines.map((each) => Object.fromEntries(each.split(',').map((value, at) => [names[at], value])));
}
/** @param {string} name @param {string} search */
const best = (name, search) => rows(name).filter((row) => row.search === search).map((row) => Number(row.best));

const tuned = [...new Set(rows('tuning').map((row) => row.search ?? ''))];
table(['tried on seeds 2101 to 2110', 'best, median (quartiles)']);
for (const search of tuned) line([search, spread(best('tuning', search))]);

const searches = [...new Set(rows('star-man-travel-physical').map((row) => row.search ?? ''))];
table(['best, median (quartiles)', ...CELLS.map(({ problem, sense }) => `${problem}, ${sense}`)]);
for (const search of searches) line([search, ...CELLS.map(({ problem, sense }) => spread(best(`${problem}-${sense}`, search)))]);

/** Compares pairs in all cells and prints a table. @param {string} title @param {string[][]} pairs @param {(cell: {problem: string, sense: string}, search: string) => number[]} values */
function compare(title, pairs, values) {
  const tests = pairs.flatMap((pair) => CELLS.map((cell) => ({ pair, cell, ...rankSum(values(cell, pair[0] ?? ''), values(cell, pair[1] ?? '')) })));
  const adjusted = holm(tests.map(({ p }) => p));
  table([title, ...CELLS.map(({ problem, sense }) => `${problem}, ${sense}`)]);
  for (const pair of pairs) {
    line([`${pair[0]} before ${pair[1]}`, ...CELLS.map((cell) => {
      const at = tests.findIndex((each) => each.pair === pair && each.cell === cell);
      return `${tests[at]?.superiority.toFixed(2)}, ${chance(adjusted[at] ?? 1)}`;
    })]);
  }
}
compare('chance to end better, p (Holm over 28)', PAIRS, ({ problem, sense }, search) => best(`${problem}-${sense}`, search));

/** @param {{problem: string, sense: string}} cell @param {string} search @param {string} column */
const mapped = (cell, search, column) => rows('maps').filter((row) => row.problem === cell.problem && row.sense === cell.sense && row.search === search).map((row) => Number(row[column]));
for (const [column, what] of [['cells', 'cells'], ['sum', 'QD score']]) {
  table([`${what}, median`, ...CELLS.map(({ problem, sense }) => `${problem}, ${sense}`)]);
  for (const search of ['map-elites', 'map-elites:elites.crossover=0.5', 'cma-mae'])
    line([search, ...CELLS.map((cell) => median(mapped(cell, search, column ?? '')).toFixed(0))]);
  compare(`chance of more ${what}, p (Holm over 8)`, MAPS, (cell, search) => mapped(cell, search, column ?? ''));
}
