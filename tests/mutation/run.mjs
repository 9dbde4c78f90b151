// SPDX-License-Identifier: MIT
// Mutation testing of core:  node tests/mutation/run.mjs [--shard 1/2] [--count 200] [--again]
// Works on a copy of the sources in build/mutation, and writes a row per mutant to docs/studies/mutation/shard-K-of-N.csv.
// Skips mutants that are in the file already; with --again, repeats those that survived. Mutants that do not compile do not
// count.
import { execFileSync, spawnSync } from 'node:child_process';
import { cpSync, existsSync, mkdirSync, readFileSync, symlinkSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { drawn, mutantsOf, withFault } from './mutants.mjs';

const ROOT = join(dirname(fileURLToPath(import.meta.url)), '../..');
const { values } = parseArgs({ options: { shard: { type: 'string', default: '1/1' }, count: { type: 'string', default: '200' }, again: { type: 'boolean', default: false } } });
const [shard, shards] = values.shard.split('/').map(Number);
const count = Number(values.count);
if (!(shards >= 1 && shard >= 1 && shard <= shards && count >= 1)) throw new Error('usage: node tests/mutation/run.mjs [--shard K/N] [--count M] [--again]');

/** @typedef {{copy: string, folder: string, unity: boolean}} Build  each has its own copy, so that mutants of headers do not rebuild the other */
const build = (/** @type {string} */ name, unity = false) => ({ copy: join(ROOT, `build/mutation/${shard}-${name}`), folder: join(ROOT, `build/mutation/${shard}-${name}/build`), unity });
// A header affects all files, so mutants of headers use a unity build.
const BUILDS = { sources: build('sources'), headers: build('headers', true) };
const RESULTS = join(ROOT, `docs/studies/mutation/shard-${shard}-of-${shards}.csv`);
const HEADER = 'fault,file,line,kind,before,after,result,seconds';
// The quick tests first. Mutants that survive them get all others.
const ROUNDS = [['~[lessons]~[links]~[golden]'], ['[golden],[links],[lessons]']];
const NONE = 'does not compile';
const PATIENCE_S = 240; // four times the duration of all tests

/** @param {string[]} words */
const git = (...words) => execFileSync('git', words, { cwd: ROOT, encoding: 'utf8' });
/** @param {Build} where @param {string} program @param {string[]} words @param {number} [seconds] */
const run = ({ copy }, program, words, seconds = 900) => spawnSync(program, words, { cwd: copy, encoding: 'utf8', timeout: seconds * 1000, killSignal: 'SIGKILL' });

/** @param {Build} where @returns {boolean} whether it compiles */
function built(where) {
  const { status, signal } = run(where, 'cmake', ['--build', where.folder, '--target', 'gaitsmith_tests', ...(shards > 1 ? ['-j1'] : [])]);
  if (signal) throw new Error(`the build ended by ${signal}`);
  return status === 0;
}

/** @param {Build} where @returns {'killed' | 'survived' | 'timeout'} */
function judged(where) {
  for (const tests of ROUNDS) {
    const { status, signal } = run(where, join(where.folder, 'tests/gaitsmith_tests'), [...tests, '--abort', '--rng-seed', '1'], PATIENCE_S);
    if (signal === 'SIGKILL') return 'timeout';
    if (status !== 0) return 'killed';
  }
  return 'survived';
}

const files = git('ls-files').split('\n').filter((file) => file !== '' && existsSync(join(ROOT, file)));
for (const where of Object.values(BUILDS)) {
  for (const file of files) {
    const there = join(where.copy, file);
    if (existsSync(there) && readFileSync(there).equals(readFileSync(join(ROOT, file)))) continue;
    mkdirSync(dirname(there), { recursive: true });
    cpSync(join(ROOT, file), there);
  }
  if (!existsSync(join(where.copy, '.toolchain'))) symlinkSync(join(ROOT, '.toolchain'), join(where.copy, '.toolchain'));
  const configured = run(where, 'cmake', ['-G', 'Ninja', '-S', where.copy, '-B', where.folder, '-DCMAKE_BUILD_TYPE=Debug', '-DCMAKE_CXX_FLAGS_DEBUG=-O1',
    `-DCMAKE_UNITY_BUILD=${where.unity ? 'ON' : 'OFF'}`]);
  if (configured.status !== 0 || !built(where)) throw new Error(`the sources themselves do not build: ${configured.stderr}`);
  if (judged(where) !== 'survived') throw new Error('the sources themselves do not pass');
}
// Read from the copies, since the sources may change during the run.
const core = new Map(files.filter((file) => /^core\/.*\.(h|cpp)$/.test(file)).map((file) => [file, readFileSync(join(BUILDS.sources.copy, file), 'utf8')]));
const textOf = (/** @type {string} */ file) => /** @type {string} */ (core.get(file));
const all = [...core].flatMap(([file, text]) => mutantsOf(file, text));
const draw = drawn(all, textOf).filter(({ name }) => parseInt(name, 16) % shards === shard - 1);
console.error(`${all.length} places for a fault in core, ${draw.length} of them of shard ${shard} of ${shards}`);
/** The results so far: the row of each mutant, and the result in it. @type {Map<string, {line: string, result: string}>} */
const known = new Map();
const places = new Set(draw.map(({ name }) => name)); // rows of mutants that no longer exist are removed
if (existsSync(RESULTS)) {
  for (const line of readFileSync(RESULTS, 'utf8').trim().split('\n').slice(1)) {
    const [name, ...rest] = line.split(',');
    if (places.has(name)) known.set(name, { line, result: /** @type {string} */ (rest.at(-2)) });
  }
}
mkdirSync(dirname(RESULTS), { recursive: true });
const valid = () => [...known.values()].filter(({ result }) => result !== NONE).length;
for (const { name, mutant } of draw) {
  const before = known.get(name);
  if (before ? !values.again || before.result !== 'survived' : valid() >= Math.ceil(count / shards)) continue;
  const where = mutant.file.endsWith('.h') ? BUILDS.headers : BUILDS.sources;
  const path = join(where.copy, mutant.file);
  const sound = textOf(mutant.file);
  const start = performance.now();
  writeFileSync(path, withFault(sound, mutant));
  const result = built(where) ? judged(where) : NONE;
  writeFileSync(path, sound);
  const seconds = ((performance.now() - start) / 1000).toFixed(0);
  const text = (/** @type {string} */ words) => `"${words.trim().replaceAll('"', '""').replaceAll(',', ';')}"`;
  known.set(name, { result, line: `${name},${mutant.file},${mutant.line},${mutant.kind},${text(mutant.before)},${text(mutant.after)},${result},${seconds}` });
  writeFileSync(RESULTS, `${[HEADER, ...[...known.values()].map(({ line }) => line)].join('\n')}\n`);
  console.error(`${valid()}: ${mutant.file}:${mutant.line} ${mutant.kind}: ${mutant.before.trim()} → ${mutant.after.trim()}: ${result}, ${seconds} s`);
}
const killed = [...known.values()].filter(({ result }) => result === 'killed' || result === 'timeout').length;
console.error(`${killed} of ${valid()} found`);
