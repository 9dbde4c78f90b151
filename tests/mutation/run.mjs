// SPDX-License-Identifier: MIT
// How many small faults in core the tests find:  node tests/mutation/run.mjs [--shard 1/2] [--count 200] [--seed 1] [--again yes]
// Works on a copy of the sources in build/mutation, and keeps a line for each fault in docs/studies/mutation/shard-K-of-N.csv;
// what stands there already is not tried again, but with --again what survived. A fault that does not compile is none: the next
// in the draw takes its place.
import { execFileSync, spawnSync } from 'node:child_process';
import { cpSync, existsSync, mkdirSync, readFileSync, symlinkSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { drawn, mutantsOf, withFault } from './mutants.mjs';

const ROOT = join(dirname(fileURLToPath(import.meta.url)), '../..');
const { values } = parseArgs({ options: { shard: { type: 'string', default: '1/1' }, count: { type: 'string', default: '200' }, seed: { type: 'string', default: '1' }, again: { type: 'string', default: 'no' } } });
const [shard, shards] = values.shard.split('/').map(Number);
const count = Number(values.count);
const seed = Number(values.seed);
if (!(shards >= 1 && shard >= 1 && shard <= shards && count >= 1 && Number.isInteger(seed))) throw new Error('usage: node tests/mutation/run.mjs [--shard K/N] [--count M] [--seed S]');

const COPY = join(ROOT, `build/mutation/${shard}`);
// A header touches everything: several files are compiled as one then.
const BUILDS = { cpp: join(COPY, 'build'), h: join(COPY, 'build-unity') };
const RESULTS = join(ROOT, `docs/studies/mutation/shard-${shard}-of-${shards}.csv`);
const HEADER = 'fault,file,line,kind,before,after,result,seconds';
// The quick tests first; a fault that these do not find meets all others.
const ROUNDS = [['~[lessons]~[links]~[golden]'], ['[golden],[links],[lessons]']];
const NONE = 'does not compile';
const PATIENCE_S = 240; // the whole takes a quarter of it

/** @param {string[]} words */
const git = (...words) => execFileSync('git', words, { cwd: ROOT, encoding: 'utf8' });
/** @param {string} program @param {string[]} words @param {number} [seconds] */
const run = (program, words, seconds = 900) => spawnSync(program, words, { cwd: COPY, encoding: 'utf8', timeout: seconds * 1000, killSignal: 'SIGKILL' });
const build = (/** @type {string} */ folder) => run('cmake', ['--build', folder, '--target', 'gaitsmith_tests', ...(shards > 1 ? ['-j1'] : [])]);

/** @param {string} folder of the build @returns {'killed' | 'survived' | 'timeout'} */
function judged(folder) {
  for (const tests of ROUNDS) {
    const { status, signal } = run(join(folder, 'tests/gaitsmith_tests'), [...tests, '--abort', '--rng-seed', '1'], PATIENCE_S);
    if (signal === 'SIGKILL') return 'timeout';
    if (status !== 0) return 'killed';
  }
  return 'survived';
}

const files = git('ls-files').split('\n').filter((file) => file !== '' && existsSync(join(ROOT, file)));
for (const file of files) {
  const there = join(COPY, file);
  if (existsSync(there) && readFileSync(there).equals(readFileSync(join(ROOT, file)))) continue;
  mkdirSync(dirname(there), { recursive: true });
  cpSync(join(ROOT, file), there);
}
if (!existsSync(join(COPY, '.toolchain'))) symlinkSync(join(ROOT, '.toolchain'), join(COPY, '.toolchain'));
const textOf = (/** @type {string} */ file) => readFileSync(join(ROOT, file), 'utf8');
const all = files.filter((file) => /^core\/.*\.(h|cpp)$/.test(file)).flatMap((file) => mutantsOf(file, textOf(file)));
const draw = drawn(all, textOf, seed).filter(({ name }) => parseInt(name, 16) % shards === shard - 1);
console.error(`${all.length} places for a fault in core, ${draw.length} of them of shard ${shard} of ${shards}`);
for (const [kind, folder] of Object.entries(BUILDS)) {
  const words = ['-G', 'Ninja', '-S', COPY, '-B', folder, '-DCMAKE_BUILD_TYPE=Debug', '-DCMAKE_CXX_FLAGS_DEBUG=-O1', `-DCMAKE_UNITY_BUILD=${kind === 'h' ? 'ON' : 'OFF'}`];
  const configured = run('cmake', words);
  if (configured.status !== 0 || build(folder).status !== 0) throw new Error(`the sources themselves do not build: ${configured.stderr}`);
  if (judged(folder) !== 'survived') throw new Error('the sources themselves do not pass');
}

/** What is known of a fault: its line, and the result in it. @type {Map<string, {line: string, result: string}>} */
const known = new Map();
if (existsSync(RESULTS)) {
  for (const line of textOf(RESULTS.slice(ROOT.length + 1)).trim().split('\n').slice(1)) {
    known.set(line.split(',')[0], { line, result: /** @type {string} */ (line.split(',').at(-2)) });
  }
}
mkdirSync(dirname(RESULTS), { recursive: true });
const valid = () => [...known.values()].filter(({ result }) => result !== NONE).length;
for (const { name, mutant } of draw) {
  const before = known.get(name);
  if (before ? values.again === 'no' || before.result !== 'survived' : valid() >= Math.ceil(count / shards)) continue;
  const path = join(COPY, mutant.file);
  const sound = textOf(mutant.file);
  const start = performance.now();
  writeFileSync(path, withFault(sound, mutant));
  const folder = mutant.file.endsWith('.h') ? BUILDS.h : BUILDS.cpp;
  const result = build(folder).status === 0 ? judged(folder) : NONE;
  writeFileSync(path, sound);
  const seconds = ((performance.now() - start) / 1000).toFixed(0);
  const text = (/** @type {string} */ words) => `"${words.trim().replaceAll('"', '""').replaceAll(',', ';')}"`;
  known.set(name, { result, line: `${name},${mutant.file},${mutant.line},${mutant.kind},${text(mutant.before)},${text(mutant.after)},${result},${seconds}` });
  writeFileSync(RESULTS, `${[HEADER, ...[...known.values()].map(({ line }) => line)].join('\n')}\n`);
  console.error(`${valid()}: ${mutant.file}:${mutant.line} ${mutant.kind}: ${mutant.before.trim()} → ${mutant.after.trim()}: ${result}, ${seconds} s`);
}
const killed = [...known.values()].filter(({ result }) => result === 'killed' || result === 'timeout').length;
console.error(`${killed} of ${valid()} found`);
