// SPDX-License-Identifier: MIT
// The tables of docs/stricter.md from the result files beside this one (question.md):  node docs/studies/stricter/summarise.mjs
import { existsSync, readFileSync } from 'node:fs';
import { holm } from '../holm.mjs';
import { median, spread } from '../quantiles.mjs';
import { rankSum } from '../rank_sum.mjs';
import { chance, line, table } from '../tables.mjs';

const PROBLEMS = ['star-man-travel', 'inchworm-travel'], SENSES = ['physical', 'timer'], SEARCHES = ['rgt', 'ssga', 'ssga:genetic.rates=per-component', 'sphc', 'pose-cycle'];
const PAIRS = [['sphc', 'rgt'], ['sphc', 'ssga'], ['sphc', 'ssga:genetic.rates=per-component'], ['pose-cycle', 'rgt']];
const TERMS = ['slip_sum', 'rotations', 'max_cm_height'];

/** @typedef {{text: Record<string, string>, of: (name: string) => number}} Row */
/** The rows of a file after its header. @param {string} name @returns {Row[]} */
function rows(name) {
  const lines = readFileSync(new URL(`${name}.csv`, import.meta.url), 'utf8').trim().split('\n').filter((line) => !line.startsWith('#'));
  const names = (lines.shift() ?? '').split(',');
  return lines.map((line) => {
    const text = Object.fromEntries(line.split(',').map((value, at) => [names[at], value]));
    return { text, of: (column) => Number(text[column]) };
  });
}

const planned = PROBLEMS.flatMap((problem) => SENSES.map((sense) => ({ problem, sense })));
/** Whether all twenty runs of each search are there. @param {{problem: string, sense: string}} cell */
const complete = ({ problem, sense }) => ['strong', 'limited'].every((joints) => {
  const name = `${problem}-${sense}-${joints}`;
  return existsSync(new URL(`${name}.csv`, import.meta.url)) && rows(name).length === 20 * SEARCHES.length;
});
const cells = planned.filter(complete);
for (const { problem, sense } of planned.filter((cell) => !cells.includes(cell))) console.log(`${problem}, ${sense}: the runs are not complete`);
/** @param {{problem: string, sense: string}} cell @param {string} joints @param {string} search @param {string} [column] */
const found = ({ problem, sense }, joints, search, column = 'best') =>
  rows(`${problem}-${sense}-${joints}`).filter(({ text }) => text.search === search).map(({ of }) => of(column));

table(['best, median (quartiles)', 'joints', ...SEARCHES]);
for (const cell of cells) {
  for (const joints of ['strong', 'limited'])
    line([`${cell.problem}, ${cell.sense}`, joints, ...SEARCHES.map((search) => spread(found(cell, joints, search)))]);
}

const compared = cells.flatMap((cell) => PAIRS.map(([a = '', b = '']) => {
  const of = (/** @type {string} */ joints) => rankSum(found(cell, joints, a), found(cell, joints, b));
  return { cell, pair: `${a} before ${b}`, strong: of('strong'), limited: of('limited') };
}));
// What is not complete counts as a comparison that shows nothing.
const adjusted = holm([...compared.map(({ limited }) => limited.p), ...Array.from({ length: PAIRS.length * (planned.length - cells.length) }, () => 1)]);
table(['chance to end better', 'strong joints, p', 'limited joints, p (Holm over 16)', 'holds']);
compared.forEach(({ cell, pair, strong, limited }, at) => {
  const p = adjusted[at] ?? 1, same = (strong.superiority > 0.5) === (limited.superiority > 0.5);
  line([`${cell.problem}, ${cell.sense}: ${pair}`, `${strong.superiority.toFixed(2)}, ${chance(strong.p)}`, `${limited.superiority.toFixed(2)}, ${chance(p)}`,
    p >= 0.05 ? 'open' : same ? 'yes' : 'no']);
});

const styled = SENSES.flatMap((sense) => TERMS.map((term) => {
  const plain = found({ problem: 'star-man-travel', sense }, 'limited', 'sphc', term);
  const weighed = rows(`star-man-${sense}-${term}`);
  const kept = median(weighed.map(({ of }) => Math.abs(of('travel')))) / median(found({ problem: 'star-man-travel', sense }, 'limited', 'sphc', 'travel').map(Math.abs)); // either way counts
  return { sense, term, plain, with: weighed.map(({ of }) => of(term)), kept, ...rankSum(weighed.map(({ of }) => of(term)), plain) };
}));
const styledP = holm(styled.map(({ p }) => p));
table(['term, Star-Man, limited', 'without its weight', 'with it', 'ratio of medians', 'chance of more', 'p (Holm over 6)', 'travel: with ÷ without']);
styled.forEach((one, at) => line([`${one.term}, ${one.sense}`, spread(one.plain), spread(one.with), (median(one.with) / median(one.plain)).toFixed(2),
  one.superiority.toFixed(2), chance(styledP[at] ?? 1), one.kept.toFixed(2)]));

const shares = (/** @type {string} */ joints, /** @type {string} */ sense) => rows('pushes').filter(({ text }) => text.joints === joints && text.sense === sense)
  .map(({ of }) => median(['f3', 'b3', 'u3', 'd3', 'f6', 'b6', 'u6', 'd6'].map(of)) / of('way'));
table(['share of the way kept when pushed', ...SENSES, 'timer keeps more with a chance of']);
/** @type {{what: string, p: number, superiority: number}[]} */
const pushed = [];
for (const [joints, what] of [['strong', 'as strong as needed'], ['limited', '2 M g L'], ['1', '1 M g L']]) {
  const [physical = [], timer = []] = SENSES.map((sense) => shares(joints ?? '', sense));
  const versus = rankSum(timer, physical);
  pushed.push({ what: `${what}: timer against senses`, ...versus });
  line([what ?? '', spread(physical), spread(timer), versus.superiority.toFixed(2)]);
}
for (const sense of SENSES) {
  for (const [joints, what] of [['limited', '2 M g L'], ['1', '1 M g L']])
    pushed.push({ what: `${sense}: ${what} against as strong as needed`, ...rankSum(shares(joints ?? '', sense), shares('strong', sense)) });
}
const pushedP = holm(pushed.map(({ p }) => p));
table(['pushes', 'the first keeps more with a chance of', 'p (Holm over 7)']);
pushed.forEach(({ what, superiority }, at) => line([what, superiority.toFixed(2), chance(pushedP[at] ?? 1)]));
