// SPDX-License-Identifier: MIT
// The tables about figures of springs in docs/physics.md and docs/stricter.md, from the result files beside this one (question.md):  node docs/studies/springs/summarise.mjs
import { readFileSync } from 'node:fs';
import { holm } from '../holm.mjs';
import { spread } from '../quantiles.mjs';
import { rankSum } from '../rank_sum.mjs';
import { chance, line, table } from '../tables.mjs';

const FIGURES = ['fish', 'jelly', 'soft-star', 'soft-wheel', 'soft-worm', 'walking-table'];
const SEARCHES = ['rgt', 'ssga', 'ssga:genetic.rates=per-component', 'sphc', 'pose-cycle'];
const PAIRS = [['sphc', 'rgt'], ['sphc', 'ssga'], ['sphc', 'ssga:genetic.rates=per-component'], ['pose-cycle', 'rgt']];

/** @param {string} name @returns {Record<string, string>[]} the rows of a file after its header */
function rows(name) {
  const lines = readFileSync(new URL(`${name}.csv`, import.meta.url), 'utf8').trim().split('\n').filter((each) => !each.startsWith('#'));
  const names = (lines.shift() ?? '').split(',');
  return lines.map((each) => Object.fromEntries(each.split(',').map((value, at) => [names[at] ?? '', value])));
}
/** The diagonal of a figure's drawing [m]. @param {string} name */
function sizeOf(name) {
  const { nodes } = JSON.parse(readFileSync(new URL(`../../../examples/figures/${name}.json`, import.meta.url), 'utf8'));
  const extent = (/** @type {string} */ axis) => {
    const places = nodes.map((/** @type {Record<string, number>} */ node) => node[axis]);
    return Math.max(...places) - Math.min(...places);
  };
  return Math.hypot(extent('x_m'), extent('y_m'));
}
/** Ways or best scores of the runs of a search. @param {Record<string, string>[]} all @param {string} search @param {string} column */
const of = (all, search, column) => all.filter((row) => row.search === search).map((row) => Number(row[column]));

const gaits = rows('gaits').map((row) => ({ ...row, problem: (row.problem ?? '').split('/').at(-1)?.replace('.json', '') ?? '' }));
const found = FIGURES.map((figure) => {
  const mine = gaits.filter(({ problem }) => problem === figure), size = sizeOf(figure);
  const ways = (/** @type {string} */ search) => of(mine, search, 'best');
  const walks = (/** @type {string} */ search) => ways(search).filter((way) => way >= 2 * size).length;
  return { figure, size, cycle: ways('pose-cycle'), sphc: ways('sphc'), cycleWalks: walks('pose-cycle'), sphcWalks: walks('sphc'), ...rankSum(ways('pose-cycle'), ways('sphc')) };
});
const gaitP = holm(found.map(({ p }) => p));
table(['figure', 'size, m', 'gaits of 20: pose cycle', 'SPHC', 'way, pose cycle', 'way, SPHC', 'chance that the cycle ends further, p (Holm over 6)']);
found.forEach((one, at) => line([one.figure, one.size.toFixed(2), String(one.cycleWalks), String(one.sphcWalks), spread(one.cycle), spread(one.sphc), `${one.superiority.toFixed(2)}, ${chance(gaitP[at] ?? 1)}`]));
for (const figure of FIGURES) {
  const best = gaits.filter(({ problem }) => problem === figure).sort((a, b) => Number(b.best) - Number(a.best))[0];
  console.log(`best of ${figure}: ${best?.search}, seed ${best?.seed}, ${best?.best} m`);
}

const senses = ['physical', 'timer'];
table(['walking table, best of 40,000', ...SEARCHES]);
for (const sense of senses) line([sense, ...SEARCHES.map((search) => spread(of(rows(`table-${sense}`), search, 'best')))]);
const pairs = senses.flatMap((sense) => PAIRS.map(([a = '', b = '']) => ({ what: `${sense}: ${a} before ${b}`, ...rankSum(of(rows(`table-${sense}`), a, 'best'), of(rows(`table-${sense}`), b, 'best')) })));
const adjusted = holm(pairs.map(({ p }) => p));
table(['the first ends better', 'with a chance of', 'p (Holm over 8)', 'holds']);
pairs.forEach(({ what, superiority }, at) => line([what, superiority.toFixed(2), chance(adjusted[at] ?? 1), (adjusted[at] ?? 1) < 0.05 ? (superiority > 0.5 ? 'yes' : 'no') : 'open']));
