// SPDX-License-Identifier: MIT
// The gentle weights from the runs with the usual ones, and how they fared (question.md):
//   node docs/studies/style/gentle.mjs tune|report
import { readdirSync, readFileSync } from 'node:fs';
import { cartwheel, shuffle, travel } from './kinds.mjs';

/** @typedef {Record<string, number>} Trial */
const TERMS = ['max_cm_height', 'slip_sum', 'rotations'], SENSES = ['physical', 'timer'], CALIBRATED = ['star-man', 'beryl', 'fred'];
const here = new URL('.', import.meta.url);
const files = readdirSync(new URL('gentle-runs', here));
/** @param {string} file @returns {Trial[]} */
function trials(file) {
  const [names = [], ...rows] = readFileSync(new URL(`${file}.csv`, here), 'utf8').trim().split('\n').filter((line) => !line.startsWith('#')).map((line) => line.split(','));
  return rows.map((row) => Object.fromEntries(row.map((value, i) => [names[i], Number(value)])));
}
/** @param {number[]} values @param {number} share */
function quantile(values, share) {
  const sorted = [...values].sort((a, b) => a - b), at = share * (sorted.length - 1), low = Math.floor(at);
  return (sorted[low] ?? NaN) + (at - low) * ((sorted[Math.ceil(at)] ?? NaN) - (sorted[low] ?? NaN));
}
/** Rounded down to two digits. @param {number} x */
function twoDigits(x) {
  const unit = 10 ** (Math.floor(Math.log10(x)) - 1);
  return Number((Math.floor(x / unit + 1e-9) * unit).toPrecision(2));
}
/** What the runs of other figures give for a term. @param {'usual' | 'gentle'} kind @param {string} term */
const others = (kind, term) => files.filter((file) => file.startsWith(`${kind}-`) && file.endsWith(`-${term}.csv`))
  .map((file) => ({ figure: file.replace(/^\w+-(.*)-(physical|timer)-.*$/, '$1'), runs: trials(`gentle-runs/${file.replace('.csv', '')}`) }));

function tune() {
  const weightOf = (/** @type {Trial[]} */ runs, /** @type {string} */ term) => twoDigits(quantile(runs.map((t) => travel(t) / (t[term] ?? NaN)), 0.25));
  console.log(`| figure | senses | ${TERMS.join(' | ')} |\n|---|---|---|---|---|`);
  for (const figure of CALIBRATED) {
    for (const sense of SENSES)
      console.log(`| ${figure} | ${sense} | ${TERMS.map((term) => weightOf(trials(`${figure}-travel-${sense}-${term}`), term)).join(' | ')} |`);
  }
  console.log(`| others | both | ${TERMS.map((term) => weightOf(others('usual', term).flatMap(({ runs }) => runs), term)).join(' | ')} |`);
  console.log(`\n| figure | ${TERMS.join(' | ')} |\n|---|---|---|---|`);
  for (const figure of new Set(others('usual', 'slip_sum').map((one) => one.figure)))
    console.log(`| ${figure} | ${TERMS.map((term) => weightOf(others('usual', term).filter((one) => one.figure === figure).flatMap(({ runs }) => runs), term)).join(' | ')} |`);
}

/** What the weighted term adds to the score: all other weights are 0. @param {Trial} t */
const weighted = (t) => (t.best ?? NaN) - travel(t);

function report() {
  console.log('| problem | senses | term | search | travel the larger part | raise the term | travel: median ÷ without | seeds of the kind asked for |\n|---|---|---|---|---|---|---|---|');
  for (const figure of CALIBRATED) {
    for (const sense of SENSES) {
      for (const term of TERMS) {
        for (const search of ['sphc', 'pose-cycle']) {
          const plain = trials(search === 'sphc' ? `${figure}-travel-${sense}-none` : `gentle-runs/gentle-${figure}-${sense}-none-pose-cycle`);
          const runs = trials(`gentle-runs/gentle-${figure}-${sense}-${term}-${search}`);
          const level = quantile(plain.map((t) => t[term] ?? NaN), 0.5);
          const of = (/** @type {(t: Trial) => boolean} */ what) => `${runs.filter(what).length} of ${runs.length}`;
          const kind = figure !== 'star-man' ? '' : term === 'slip_sum' ? `${runs.filter(shuffle).length} shuffles`
            : term === 'rotations' ? `${runs.filter(cartwheel).length} cartwheels` : '';
          console.log(`| ${figure} | ${sense} | ${term} | ${search} | ${of((t) => travel(t) >= weighted(t))} | ${of((t) => (t[term] ?? NaN) > level)} | ` +
            `${(quantile(runs.map(travel), 0.5) / quantile(plain.map(travel), 0.5)).toFixed(2)} | ${kind} |`);
        }
      }
    }
  }
  console.log('\n| others: figures where travel is the larger part | of all runs | of half the runs |\n|---|---|---|');
  for (const term of TERMS) {
    const cells = others('gentle', term).filter(({ figure }) => !CALIBRATED.includes(figure));
    const shares = cells.map(({ runs }) => runs.filter((t) => travel(t) >= weighted(t)).length / runs.length);
    console.log(`| ${term} | ${shares.filter((share) => share === 1).length} of ${shares.length} | ${shares.filter((share) => share >= 0.5).length} of ${shares.length} |`);
  }
}
if (process.argv[2] === 'report') report(); else tune();
