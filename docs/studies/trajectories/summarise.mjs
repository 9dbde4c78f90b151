// SPDX-License-Identifier: MIT
// The tables of docs/controllers-and-trajectories.md from the rows beside this file (question.md):  node docs/studies/trajectories/summarise.mjs
import { readFileSync } from 'node:fs';
import { interval } from '../draws.mjs';
import { holm } from '../holm.mjs';
import { median, spread } from '../quantiles.mjs';
import { rankSum } from '../rank_sum.mjs';
import { signedRank } from '../signed_rank.mjs';
import { chance, line, table } from '../tables.mjs';
import { DISTURBANCES } from './disturbances.mjs';

const ARMS = ['senses', 'timer', 'network', 'curve', 'whole'], OTHERS = ARMS.slice(1), KINDS = ['push', 'friction', 'slope', 'start'];
const LEAST_M = 1, KEPT = 0.5;

const rows = (/** @type {string} */ name) => readFileSync(new URL(name, import.meta.url), 'utf8').trim().split('\n').slice(1).map((line) => line.split(','));
const mean = (/** @type {number[]} */ numbers) => numbers.reduce((sum, number) => sum + number, 0) / numbers.length;

const found = rows('found.csv');
const cells = [...new Set(found.map(([problem, search]) => `${problem},${search}`))];
const travels = (/** @type {string} */ cell, /** @type {string} */ arm) => found.filter(([problem, search, of]) => `${problem},${search}` === cell && of === arm);
table(['travel [m], median (quartiles), and size', ...ARMS]);
for (const cell of cells) {
  line([cell.replace(',', ', '), ...ARMS.map((arm) => {
    const ways = travels(cell, arm).map((row) => Number(row[5]));
    return `${spread(ways, 1)}, ${travels(cell, arm)[0]?.[3]}`;
  })]);
}
const against = cells.flatMap((cell) => OTHERS.map((arm) => ({ cell, arm,
  ...rankSum(travels(cell, 'senses').map((row) => Number(row[5])), travels(cell, arm).map((row) => Number(row[5]))) })));
const p = holm(against.map((one) => one.p));
table(['senses end ahead of', 'chance', 'p (Holm over 16)']);
against.forEach(({ cell, arm, superiority }, at) => line([`${arm}: ${cell.replace(',', ', ')}`, superiority.toFixed(2), chance(p[at] ?? 1)]));
table(['rules against trajectories', 'chance', 'p, alone']);
for (const cell of cells) {
  for (const [rules, curves] of [['senses', 'curve'], ['senses', 'whole'], ['timer', 'curve'], ['timer', 'whole']]) {
    const { superiority, p: alone } = rankSum(travels(cell, rules ?? '').map((row) => Number(row[5])), travels(cell, curves ?? '').map((row) => Number(row[5])));
    line([`${rules} before ${curves}: ${cell.replace(',', ', ')}`, superiority.toFixed(2), chance(alone)]);
  }
}

/** Each controller with its ways. @type {Map<string, Map<string, number>>} */
const controllers = new Map();
for (const [problem, search, arm, seed, disturbance, size, travel] of rows('survived.csv')) {
  const key = [problem, search, arm, seed].join();
  if (!controllers.has(key)) controllers.set(key, new Map());
  controllers.get(key)?.set(`${disturbance},${size}`, Number(travel));
}
/** Whether it survives; undefined: it is left out. @param {string} key @param {string} disturbance @returns {boolean | undefined} */
function survives(key, disturbance) {
  const ways = controllers.get(key), own = ways?.get('none,0') ?? 0;
  return own < LEAST_M ? undefined : (ways?.get(disturbance) ?? -Infinity) >= KEPT * own;
}
const keysOf = (/** @type {string} */ arm) => [...controllers.keys()].filter((key) => key.split(',')[2] === arm);
const known = (/** @type {string[]} */ keys) => keys.filter((key) => survives(key, 'none,0') !== undefined);
console.log(`\nLeft out, below ${LEAST_M} m undisturbed: ${ARMS.map((arm) => `${arm} ${keysOf(arm).length - known(keysOf(arm)).length}`).join(', ')}`);

table(['share that survives', ...ARMS]);
/** Sizes without direction and moment, in order. @type {Map<string, string[]>} */
const sizes = new Map();
for (const { name, size } of DISTURBANCES) {
  const plain = `${name} ${size.replace(/@\d+$/, '').replace('-', '')}`;
  sizes.set(plain, [...(sizes.get(plain) ?? []), `${name},${size}`]);
}
for (const [plain, all] of sizes) {
  line([plain, ...ARMS.map((arm) => mean(known(keysOf(arm)).flatMap((key) => all.map((one) => Number(survives(key, one))))).toFixed(2))]);
}

/** The mean over all sizes of a kind. @param {string} key @param {string} kind */
const robustness = (key, kind) => mean(DISTURBANCES.filter(({ name }) => name === kind).map(({ name, size }) => Number(survives(key, `${name},${size}`))));
/** Differences of the senses' robustness from that of a twin, where both are known. @param {string} arm @param {string} kind @param {(twin: string) => boolean} [fits] */
const differences = (arm, kind, fits = () => true) => known(keysOf('senses')).flatMap((key) => {
  const twin = key.replace(',senses,', `,${arm},`);
  return controllers.has(twin) && survives(twin, 'none,0') !== undefined && fits(twin) ? [robustness(key, kind) - robustness(twin, kind)] : [];
});
const paired = KINDS.flatMap((kind) => OTHERS.map((arm) => ({ kind, arm, of: differences(arm, kind) })));
const pairedP = holm(paired.map(({ of }) => signedRank(of)));
table(['senses survive more than', 'pairs', 'median difference (95 %)', 'mean', 'p (Holm over 16)']);
paired.forEach(({ kind, arm, of }, at) => {
  const [low, high] = interval(of, median);
  line([`${arm}: ${kind}`, `${of.length}`, `${median(of).toFixed(2)} (${low.toFixed(2)} to ${high.toFixed(2)})`, mean(of).toFixed(2), chance(pairedP[at] ?? 1)]);
});

const own = (/** @type {string} */ key) => controllers.get(key)?.get('none,0') ?? 0;
const keeps = (/** @type {string} */ twin) => own(twin) >= KEPT * own(twin.replace(',recorded,', ',senses,'));
console.log(`\nRecorded as curves: ${keysOf('recorded').filter(keeps).length} of ${keysOf('recorded').length} still travel half as far undisturbed`);
table(['senses survive more than their own recording', 'pairs', 'median difference (95 %)', 'mean', 'p']);
for (const kind of KINDS) {
  const of = differences('recorded', kind, keeps);
  const [low, high] = interval(of, median);
  line([kind, `${of.length}`, `${median(of).toFixed(2)} (${low.toFixed(2)} to ${high.toFixed(2)})`, mean(of).toFixed(2), chance(signedRank(of))]);
}
