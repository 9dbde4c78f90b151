// SPDX-License-Identifier: MIT
// Searches and measures for question.md, row by row, and continues where it ended:
//   tuning.csv  problem,search,arm,size,seed,travel
//   found.csv   problem,search,arm,size,seed,travel
//   survived.csv  problem,search,arm,seed,disturbance,size,travel   (disturbance "none": undisturbed; arm "recorded": see question.md)
import { execFileSync, spawnSync } from 'node:child_process';
import { appendFileSync, existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { DISTURBANCES } from './disturbances.mjs';

const [, , gaitsmith = 'gaitsmith', threads = '2'] = process.argv;
const here = (/** @type {string} */ name) => fileURLToPath(new URL(name, import.meta.url));
const problems = here('../../../examples/problems/');
const work = mkdtempSync(join(tmpdir(), 'trajectories-'));
process.on('exit', () => rmSync(work, { recursive: true }));

const PROBLEMS = ['star-man-travel', 'beryl-travel'], SEARCHES = ['sphc', 'pose-cycle'];
const EVALUATIONS = '40000';
/** @type {Record<string, {controller: string, clock: 'none' | 'period' | 'whole', sizes: number[]}>} */
const ARMS = {
  senses: { controller: 'rules', clock: 'none', sizes: [5, 10, 20] },
  timer: { controller: 'rules', clock: 'period', sizes: [5, 10, 20] },
  network: { controller: 'network', clock: 'none', sizes: [5, 10, 20] },
  curve: { controller: 'trajectory', clock: 'period', sizes: [5, 10, 20] },
  whole: { controller: 'trajectory:rest', clock: 'whole', sizes: [10, 20, 32] },
};

/** A file of rows; `known` are the keys, the columns before the last. @param {string} name @param {string} header */
function table(name, header) {
  const path = here(name);
  if (!existsSync(path)) writeFileSync(path, `${header}\n`);
  const rows = () => readFileSync(path, 'utf8').trim().split('\n').slice(1).map((line) => line.split(','));
  const known = new Set(rows().map((row) => row.slice(0, -1).join(',')));
  return { rows, has: (/** @type {string} */ key) => known.has(key),
    add: (/** @type {string} */ key, /** @type {string} */ value) => { appendFileSync(path, `${key},${value}\n`); known.add(key); } };
}

const median = (/** @type {number[]} */ numbers) => numbers.sort((a, b) => a - b)[(numbers.length - 1) >> 1] ?? NaN;
const settingsOf = (/** @type {string} */ problem) => JSON.parse(readFileSync(`${problems}${problem}.json`, 'utf8'));

/** Travel of a document [m]. @param {string} input  its path, or its text after "-" @param {string} [text] */
function travelOf(input, text) {
  const { stdout, status, stderr } = spawnSync(gaitsmith, ['measure', input], { input: text, encoding: 'utf8' });
  if (status !== 0) throw new Error(stderr);
  return stdout.split('\n')[1]?.split(',')[0] ?? '';
}

/** @param {string} problem @param {string} search @param {string} arm @param {number} size @param {number} seed @param {string} out */
function find(problem, search, arm, size, seed, out) {
  const { controller, clock } = ARMS[arm];
  const { senses, task } = settingsOf(problem);
  const period = clock === 'whole' ? task.duration_steps : senses.period_steps;
  execFileSync(gaitsmith, ['synthesize', '--problem', `${problems}${problem}.json`, '--task', 'travel-right', '--controller', controller,
    '--sense', clock === 'none' ? 'physical' : `timer=${period / 100}`, '--rules', `${size}`, '--search', search, '--evaluations', EVALUATIONS,
    '--seed', `${seed}`, '--threads', threads, '--out', out], { stdio: ['ignore', 'ignore', 'inherit'] });
}

const tuning = table('tuning.csv', 'problem,search,arm,size,seed,travel');
const found = table('found.csv', 'problem,search,arm,size,seed,travel');
const survived = table('survived.csv', 'problem,search,arm,seed,disturbance,size,travel');

/** Measures a document with every disturbance. @param {string} key  problem,search,arm,seed @param {string} path */
function disturb(key, path) {
  const document = JSON.parse(readFileSync(path, 'utf8'));
  delete document.hash;
  if (!survived.has(`${key},none,0`)) survived.add(`${key},none,0`, travelOf('-', JSON.stringify(document)));
  for (const { name, size, change } of DISTURBANCES) {
    if (survived.has(`${key},${name},${size}`)) continue;
    const other = structuredClone(document);
    change(other);
    survived.add(`${key},${name},${size}`, travelOf('-', JSON.stringify(other)));
  }
}

for (const problem of PROBLEMS) {
  for (const search of SEARCHES) {
    for (const [arm, { sizes }] of Object.entries(ARMS)) {
      for (const size of sizes) {
        for (let seed = 3001; seed <= 3005; seed++) {
          const key = `${problem},${search},${arm},${size},${seed}`;
          if (tuning.has(key)) continue;
          find(problem, search, arm, size, seed, join(work, 'tuned.json'));
          tuning.add(key, travelOf(join(work, 'tuned.json')));
        }
      }
      const ways = (/** @type {number} */ size) => tuning.rows().filter((row) => row.slice(0, 4).join(',') === `${problem},${search},${arm},${size}`).map((row) => Number(row[5]));
      const best = sizes.reduce((a, b) => (median(ways(b)) > median(ways(a)) ? b : a));
      for (let seed = 3101; seed <= 3120; seed++) {
        const key = `${problem},${search},${arm},${best},${seed}`;
        const own = `${problem},${search},${arm},${seed}`, twin = `${problem},${search},recorded,${seed}`;
        const done = (/** @type {string} */ of) => [{ name: 'none', size: 0 }, ...DISTURBANCES].every(({ name, size }) => survived.has(`${of},${name},${size}`));
        if (found.has(key) && done(own) && (arm !== 'senses' || done(twin))) continue;
        const path = join(work, 'found.json');
        find(problem, search, arm, best, seed, path);
        if (!found.has(key)) found.add(key, travelOf(path));
        disturb(own, path);
        if (arm === 'senses') {
          execFileSync(gaitsmith, ['record', path, '--out', join(work, 'recorded.json')], { stdio: 'ignore' });
          disturb(twin, join(work, 'recorded.json'));
        }
        console.log(key);
      }
    }
  }
}
