// SPDX-License-Identifier: MIT
// The tables of docs/search.md, "The paper's order", from the result files beside this one (question.md):
//   node docs/studies/pecking-order/summarise.mjs build/release/shell/gaitsmith
import { execFileSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { holm } from '../holm.mjs';

const PROBLEMS = ['star-man-travel', 'beryl-travel', 'fred-travel', 'inchworm-travel', 'hopper-travel'];
const NAMES = ['rgt', 'gga', 'ssga', 'shc', 'sphc'];
/** What each reading calls the five searches. @type {Record<string, string[]>} */
const READINGS = {
  'per child': NAMES,
  'per child, no copies': ['rgt', 'gga:genetic.copies=perturbed', 'ssga:genetic.copies=perturbed', 'shc', 'sphc'],
  'per component': ['rgt', 'gga:genetic.rates=per-component', 'ssga:genetic.rates=per-component', 'shc:gene_chance=1', 'sphc:gene_chance=1'],
  'no heedless rules': NAMES.map((name) => `${name}:heedless=forbidden`),
};
const [, , gaitsmith = 'gaitsmith'] = process.argv;
const path = (/** @type {string} */ name) => fileURLToPath(new URL(`${name}.csv`, import.meta.url));

/** Lines of a CSV as fields. @param {string} text */
const fields = (text) => text.trim().split('\n').slice(1).map((line) => line.split(','));
/**
 * What `compare --summary` says of these searches: n, median, quartiles of each; A12 and adjusted p of each pair.
 * @param {string[]} names  of result files
 * @param {string[]} searches
 */
function summary(names, searches) {
  const words = ['compare', ...names.map((name) => `--summary=${path(name)}`), ...searches.map((search) => `--search=${search}`)];
  const [some = '', pairs = ''] = execFileSync(gaitsmith, words, { encoding: 'utf8' }).split('\n\n');
  return {
    median: new Map(fields(some).map(([, search = '', ...numbers]) => [search, numbers.map(Number)])),
    pairs: fields(pairs).map(([, a = '', b = '', , , a12, p]) => ({ a, b, a12: Number(a12), p: Number(p) })),
  };
}
const cell = ([n = 0, median = 0, low = 0, high = 0]) => `${median.toFixed(2)} (${low.toFixed(2)}–${high.toFixed(2)})${n < 40 ? ` n ${n}` : ''}`;
const middle = (/** @type {number[]} */ values) => values.sort((a, b) => a - b)[Math.floor(values.length / 2)] ?? NaN;

/** The paper's order, X before Y. The first six make it whole (question.md). */
const PAIRS = ['shc gga', 'shc ssga', 'sphc gga', 'sphc ssga', 'gga rgt', 'ssga rgt', 'shc rgt', 'sphc rgt', 'sphc shc', 'ssga gga']
  .map((pair) => pair.split(' '));
/** A column for each sense and reading, a line for each pair, and how often the paper's order is reproduced as a whole. */
const columns = ['sense, reading'], lines = PAIRS.map(([x, y]) => [`${x} before ${y}`]), whole = ['all of the paper\'s order'];
for (const sense of ['physical', 'timer']) {
  const done = PROBLEMS.filter((problem) => existsSync(path(`${problem}-${sense}`)));
  for (const [reading, searches] of Object.entries(READINGS)) {
    if (sense === 'timer' && reading === 'no heedless rules') continue;
    console.log(`\n| ${sense}, ${reading} | ${NAMES.join(' | ')} |\n|---${'|---'.repeat(NAMES.length)}|`);
    const verdicts = done.map((problem) => {
      const { median, pairs } = summary([`${problem}-${sense}`], searches);
      console.log(`| ${problem} | ${searches.map((search) => cell(median.get(search))).join(' | ')} |`);
      return PAIRS.map((pair) => {
        const [x, y] = pair.map((name) => searches[NAMES.indexOf(name)]);
        const { a, a12, p } = pairs.filter((one) => (one.a === x && one.b === y) || (one.a === y && one.b === x))[0] ?? { a: x, a12: NaN, p: NaN };
        const share = a === x ? a12 : 1 - a12;
        return { share, before: p < 0.05 && share > 0.5, after: p < 0.05 && share < 0.5 };
      });
    });
    columns.push(`${sense}, ${reading}`);
    lines.forEach((line, i) => {
      const ones = verdicts.map((problem) => /** @type {(typeof problem)[0]} */ (problem[i]));
      line.push(`${ones.filter(({ before }) => before).length}, ${ones.filter(({ after }) => after).length} (${
        middle(ones.map(({ share }) => share)).toFixed(2)})`);
    });
    whole.push(`${verdicts.filter((problem) => problem.slice(0, 6).every(({ before }) => before)).length}`);
  }
}
console.log(`\n| ${columns.join(' | ')} |\n${'|---'.repeat(columns.length)}|`);
for (const line of [...lines, whole]) console.log(`| ${line.join(' | ')} |`);

for (const [what, suffix] of [['as they are', ''], ['without heedless rules', ':heedless=forbidden']]) {
  const done = PROBLEMS.filter((problem) => existsSync(path(`${problem}-timer`)));
  console.log(`\n| timer against physical senses ${what} | ${NAMES.join(' | ')} |\n|---${'|---'.repeat(NAMES.length)}|`);
  const searches = NAMES.map((name) => {
    const compared = done.map((problem) => {
      const both = summary([`${problem}-timer`, `${problem}-physical`], suffix ? [name, `${name}${suffix}`] : [name]);
      const timer = `${name} in ${problem}-timer`, senses = suffix ? `${name}${suffix}` : `${name} in ${problem}-physical`;
      return both.pairs.filter(({ a, b }) => a === timer && b === senses)[0] ?? { a12: NaN, p: NaN };
    });
    const adjusted = holm(compared.map(({ p }) => p));
    return compared.map(({ a12 }, i) => `${a12.toFixed(2)}${(adjusted[i] ?? 1) < 0.05 ? ' *' : ''}`);
  });
  done.forEach((problem, i) => console.log(`| ${problem} | ${searches.map((shares) => shares[i]).join(' | ')} |`));
}
