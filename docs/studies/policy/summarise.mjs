// SPDX-License-Identifier: MIT
// The tables of docs/search.md from the result files beside this one (question.md):  node docs/studies/policy/summarise.mjs
import { readFileSync } from 'node:fs';
import { holm } from '../holm.mjs';
import { median } from '../quantiles.mjs';
import { exactRankSum } from '../rank_sum.mjs';
import { chance, line, table } from '../tables.mjs';

const SIDES = ['rules', 'policy'];

/** The rows of a file. @param {string} name @returns {Record<string, string>[]} */
function rows(name) {
  const lines = readFileSync(new URL(`${name}.csv`, import.meta.url), 'utf8').trim().split('\n');
  const names = (lines.shift() ?? '').split(',');
  return lines.map((each) => Object.fromEntries(each.split(',').map((value, at) => [names[at], value])));
}
/** @param {number[]} values */
const range = (values) => `${median(values).toFixed(1)} (${Math.min(...values).toFixed(1)}–${Math.max(...values).toFixed(1)})`;

const known = rows('pendulum').map((row) => Number(row.mean_return));
console.log(`pendulum, mean returns: ${known.join(', ')}; learned by ${known.filter((each) => each >= -200).length} of ${known.length}`);

table(['tried on seed 3101', 'metres at 100,000 s, from most to least']);
for (const side of SIDES) {
  const ends = rows('tuning').filter((row) => row.side === side && row.seconds === '100000').sort((a, b) => Number(b.metres) - Number(a.metres));
  line([side, ends.map((row) => `${Number(row.metres).toFixed(1)} (${row.configuration})`).join(', ')]);
}

const report = rows('report');
const moments = [...new Set(report.map((row) => row.seconds ?? ''))];
/** @param {string} side @param {string} column @param {string} seconds */
const at = (side, column, seconds) => report.filter((row) => row.side === side && row.seconds === seconds).map((row) => Number(row[column]));
table(['metres, median (range) of five', ...moments.map((each) => `${Number(each).toLocaleString('en')} s`)]);
line(['rules, best so far', ...moments.map((each) => range(at('rules', 'metres', each)))]);
line(['policy, best mean action so far', ...moments.map((each) => range(at('policy', 'metres', each)))]);
line(['policy, best of all episodes so far', ...moments.map((each) => range(at('policy', 'explored', each)))]);
line(['policy, its mean action then', ...moments.map((each) => range(at('policy', 'now', each)))]);

const end = moments.at(-1) ?? '';
const tests = ['metres', 'explored'].map((column) => exactRankSum(at('rules', 'metres', end), at('policy', column, end)));
const adjusted = holm(tests.map(({ p }) => p));
table(['at the end', 'chance that rules are ahead, p (Holm over the two)']);
for (const [i, name] of ['of the best mean action', 'of the best of all episodes'].entries()) line([name, `${tests[i]?.superiority.toFixed(2)}, ${chance(adjusted[i] ?? 1)}`]);

const processor = rows('processor').filter((row) => row.table === 'report');
table(['processor seconds of a run', 'median']);
for (const side of SIDES) line([side, median(processor.filter((row) => row.side === side).map((row) => Number(row.processor_s))).toFixed(0)]);
