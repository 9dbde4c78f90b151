// SPDX-License-Identifier: MIT
// Scripted tasters breed by eye and answer questions (question.md). Resumable: finished tasters are kept.
//   node docs/studies/taste/run.mjs build/release/shell/gaitsmith [--tune] [K/N]
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';

const FIGURES = ['mr-star-man', 'ostrich', 'acrobat', 'frog'];
const TERMS = ['max_cm_height', 'slip_sum', 'rotations', 'effort', 'upright', 'smoothness', 'head_height'];
const ROUNDS = 10;
const QUESTIONS = 15;
const PICKS = 3;
const TURN = 5; // the round from which children that are good at the goal are preferred to ones that differ much

const gaitsmith = resolve(process.argv[2] ?? '');
const tune = process.argv.includes('--tune');
const [shard, shards] = (process.argv.find((word) => /^\d+\/\d+$/.test(word)) ?? '1/1').split('/').map(Number);
const folder = mkdtempSync(join(tmpdir(), 'taste-'));
const out = new URL(tune ? 'tuning/' : 'tasters/', import.meta.url);

/** @param {string[]} words */
const run = (...words) => execFileSync(gaitsmith, words, { cwd: folder, encoding: 'utf8', maxBuffer: 1 << 26 });
/** @param {string} csv @returns {Record<string, string>[]} */
function rows(csv) {
  const [head = '', ...lines] = csv.trim().split('\n');
  return lines.map((line) => Object.fromEntries(head.split(',').map((name, i) => [name, line.split(',')[i] ?? ''])));
}

/** Uniform numbers in [0, 1): mulberry32. @param {number} seed */
function uniform(seed) {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 4294967296;
  };
}

/** A motion that was shown. @typedef {{file: string, measures: Record<string, number>}} Shown */
/** @param {string} csv  of gaitsmith breed @returns {Shown[]} */
const shownBy = (csv) => rows(csv).map(({ file = '', ...others }) => ({ file, measures: Object.fromEntries(Object.entries(others).map(([name, value]) => [name, Number(value)])) }));
/** @param {number[]} values */
const spread = (values) => {
  const mean = values.reduce((sum, value) => sum + value, 0) / values.length;
  return Math.sqrt(values.reduce((sum, value) => sum + (value - mean) ** 2, 0) / values.length);
};

/** @param {number} seed */
function taster(seed) {
  const random = uniform(seed);
  const figure = FIGURES[seed % FIGURES.length] ?? '';
  const first = `first-${seed}.json`;
  run('new', '--figure', figure, '--goal', 'far', '--out', `standing-${seed}.json`);
  run('synthesize', '--problem', `standing-${seed}.json`, '--search', 'pose-cycle', '--evaluations', '4000', '--seed', String(seed), '--out', first);
  const sample = [1, 2, 3].flatMap((s) => shownBy(run('breed', first, '--difference', '0.6', '--seed', String(900 + s), '--out-prefix', `sample-${seed}-${s}`)));
  const of = (/** @type {string} */ name) => sample.map(({ measures }) => measures[name] ?? 0);
  const weights = /** @type {Record<string, number>} */ ({});
  const open = [...TERMS];
  for (let i = 0; i < 3; i++) {
    const [term = ''] = open.splice(Math.floor(random() * open.length), 1);
    const size = 0.5 * 4 ** random();
    weights[term] = ((random() < 0.5 ? -1 : 1) * size * spread(of('travel'))) / Math.max(1e-6, spread(of(term)));
  }
  const worth = (/** @type {Record<string, number>} */ measures) => (measures.travel ?? 0) + Object.entries(weights).reduce((sum, [term, weight]) => sum + weight * (measures[term] ?? 0), 0);
  const asWeights = Object.entries(weights).flatMap(([term, weight]) => ['--weight', `${term}=${Math.max(-1000, Math.min(1000, weight)).toPrecision(6)}`]);
  run('synthesize', '--problem', `standing-${seed}.json`, ...asWeights, '--search', 'pose-cycle', '--evaluations', '40000', '--seed', String(seed), '--out', `best-${seed}.json`);
  const measured = (/** @type {string} */ file) => Object.fromEntries(Object.entries(rows(run('measure', file))[0] ?? {}).map(([term, value]) => [term, Number(value)]));
  return { seed, first, worth, measured, yardstick: worth(measured(`best-${seed}.json`)), start: worth(measured(first)), weights, figure };
}

/** @typedef {ReturnType<typeof taster>} Taster */
/** The best hidden worth that was shown, after each round or question. @typedef {number[]} Course */

/** @param {Taster} person @param {boolean} learns @returns {Course} */
function byEye({ seed, first, worth, measured }, learns) {
  const prefix = `${learns ? 'taste' : 'eye'}-${seed}`;
  const comparisons = ['first,second,verdict'];
  const course = /** @type {number[]} */ ([]);
  let parents = [first];
  let best = worth(measured(first));
  for (let round = 1; round <= ROUNDS; round++) {
    const children = shownBy(run('breed', ...parents, '--seed', String(round), '--difference', '0.4', ...(round >= TURN ? ['--keep', 'goal'] : []), '--out-prefix', `${prefix}-${round}`))
      .sort((a, b) => worth(b.measures) - worth(a.measures));
    best = Math.max(best, worth(children[0]?.measures ?? {}));
    course.push(best);
    const picked = children.slice(0, PICKS), left = children.slice(PICKS);
    parents = picked.map(({ file }) => file);
    if (!learns) continue;
    for (const one of picked) for (const other of left) comparisons.push(`${one.file},${other.file},first`);
    writeFileSync(join(folder, `${prefix}.csv`), `${comparisons.join('\n')}\n`);
    run('taste', `${prefix}.csv`, '--out', `${prefix}.json`);
    const weights = JSON.parse(readFileSync(join(folder, `${prefix}.json`), 'utf8')).task.weights ?? {};
    for (const file of parents) reweigh(file, weights);
  }
  return course;
}

/** Gives a document's goal these weights. @param {string} file @param {object} weights */
function reweigh(file, weights) {
  const path = join(folder, file);
  const document = JSON.parse(readFileSync(path, 'utf8'));
  document.task.weights = weights;
  delete document.lineage;
  writeFileSync(path, JSON.stringify(document));
}

/** @param {Taster} person @returns {Course} */
function byPairs({ seed, first, worth, measured }) {
  const prefix = `pairs-${seed}`;
  const comparisons = ['first,second,verdict'];
  const course = /** @type {number[]} */ ([]);
  const pool = shownBy(run('breed', first, '--seed', '1', '--difference', '0.6', '--out-prefix', `${prefix}-a`));
  let best = Math.max(worth(measured(first)), ...pool.map(({ measures }) => worth(measures)));
  for (let question = 1; question <= QUESTIONS; question++) {
    const asked = pool.slice(-18);
    // Before the first answer nothing is known, so any pair of those that differ most in the goal will do.
    const [one, other] = question === 1 ? [asked[0], asked[1]] : pairOf(prefix, asked);
    if (!one || !other) break;
    comparisons.push(`${one.file},${other.file},${worth(one.measures) > worth(other.measures) ? 'first' : 'second'}`);
    writeFileSync(join(folder, `${prefix}.csv`), `${comparisons.join('\n')}\n`);
    run('taste', `${prefix}.csv`, '--out', `${prefix}-wish.json`);
    const file = `${prefix}-found-${question}.json`;
    run('synthesize', '--problem', `${prefix}-wish.json`, '--search', 'pose-cycle', '--evaluations', '4000', '--seed', String(question), '--out', file);
    const found = measured(file);
    pool.push({ file, measures: found });
    best = Math.max(best, worth(found));
    course.push(best);
    if (question % 5 === 0) pool.push(...shownBy(run('breed', file, '--seed', String(question), '--difference', '0.6', '--out-prefix', `${prefix}-${question}`)));
  }
  return course;
}

/** @param {string} prefix @param {Shown[]} pool */
function pairOf(prefix, pool) {
  const [row = {}] = rows(run('taste', `${prefix}.csv`, ...pool.flatMap(({ file }) => ['--ask', file])));
  return [row.first, row.second].map((file) => pool.find((shown) => shown.file === file));
}

mkdirSync(out, { recursive: true });
for (let seed = (tune ? 101 : 1) + shard - 1; seed < (tune ? 121 : 21); seed += shards) {
  const file = new URL(`${seed}.json`, out);
  if (existsSync(file)) continue;
  const person = taster(seed);
  const { figure, weights, yardstick, start } = person;
  const result = { seed, figure, weights, yardstick, start, eye: byEye(person, false), taste: byEye(person, true), pairs: byPairs(person) };
  writeFileSync(file, `${JSON.stringify(result)}\n`);
  const near = (/** @type {number[]} */ course) => course.findIndex((best) => best >= yardstick - 0.1 * Math.abs(yardstick)) + 1 || '-';
  console.log(`${seed} ${figure}: eye ${near(result.eye)}, taste ${near(result.taste)}, pairs ${near(result.pairs)}`);
}
rmSync(folder, { recursive: true });
