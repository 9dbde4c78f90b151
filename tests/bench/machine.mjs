// SPDX-License-Identifier: MIT
// The machine and the builds of a measurement, which results depend on.
import { execFileSync, spawn } from 'node:child_process';
import { existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { cpus, loadavg } from 'node:os';
import { join } from 'node:path';
import { ROOT } from '../browser/browsers.mjs';

/** @param {string} path */
const read = (path) => (existsSync(path) ? readFileSync(path, 'utf8') : '');
/** @param {string} text @param {RegExp} pattern */
const first = (text, pattern) => pattern.exec(text)?.[1] ?? '';

/** @param {string} build  a folder of build/ @returns {{compiler: string, flags: string}} */
function compilerOf(build) {
  const folder = join(ROOT, 'build', build);
  const files = existsSync(join(folder, 'CMakeFiles')) ? readdirSync(join(folder, 'CMakeFiles')) : [];
  const known = files.map((name) => read(join(folder, 'CMakeFiles', name, 'CMakeCXXCompiler.cmake'))).join('');
  const cache = read(join(folder, 'CMakeCache.txt'));
  return {
    compiler: `${first(known, /COMPILER_ID "(\w*)"/)} ${first(known, /COMPILER_VERSION "([\d.]*)"/)}`,
    flags: `${first(cache, /^CMAKE_CXX_FLAGS_RELEASE:\w+=(.*)$/m)} -ffp-contract=off${build === 'wasm' ? ' -msimd128' : ''}`,
  };
}

const LOOK_MS = 500;

/** Cores used by other programs, before and after a benchmark. A load average would include a recent build. */
async function busyCores() {
  const spent = () => cpus().reduce((sum, { times }) => {
    const all = Object.values(times).reduce((total, time) => total + time, 0);
    return { busy: sum.busy + all - times.idle, all: sum.all + all };
  }, { busy: 0, all: 0 });
  const before = spent();
  await new Promise((resolve) => setTimeout(resolve, LOOK_MS));
  const after = spent();
  return (cpus().length * (after.busy - before.busy)) / Math.max(1, after.all - before.all);
}
const busyBefore = await busyCores();

async function machine() {
  const git = (/** @type {string[]} */ ...words) => execFileSync('git', words, { cwd: ROOT, encoding: 'utf8' }).trim();
  const emscripten = read(join(ROOT, '.toolchain/emscripten-root')).trim();
  return {
    cpu: cpus()[0]?.model,
    cores: cpus().length,
    busyCores: [busyBefore, await busyCores()],
    loadAverage: loadavg()[0],
    date: new Date().toISOString(),
    commit: git('rev-parse', '--short', 'HEAD') + (git('status', '--porcelain') ? ' with changes' : ''),
    node: process.version,
    emscripten: read(join(emscripten, 'emscripten-version.txt')).replaceAll('"', '').trim(),
    builds: Object.fromEntries(['release', 'release-clang', 'wasm'].map((build) => [build, compilerOf(build)])),
  };
}

/** Writes build/bench-NAME.json. @param {string} name @param {object} figures */
export async function keep(name, figures) {
  mkdirSync(join(ROOT, 'build'), { recursive: true });
  writeFileSync(join(ROOT, `build/bench-${name}.json`), `${JSON.stringify({ machine: await machine(), ...figures }, null, 2)}\n`);
}

/**
 * Speed of two independent programs on two cores relative to one: the present upper limit for two workers.
 * @returns {Promise<number | null>} 2 if neither slows down the other; null if the command line is not built
 */
export async function twoCoresOverOne() {
  const program = join(ROOT, 'build/release/shell/gaitsmith');
  if (!existsSync(program)) return null;
  const words = ['synthesize', '--figure', 'mr-star-man', '--task', 'travel', '--sense', 'physical', '--search', 'sphc',
    '--evaluations', '20000', '--seed', '1', '--threads', '1', '--out', '/dev/null'];
  const run = () => new Promise((resolve, reject) => {
    const start = performance.now();
    spawn(program, words, { stdio: 'ignore' }).on('error', reject).on('close', () => resolve(performance.now() - start));
  });
  const alone = await run();
  const [one, other] = await Promise.all([run(), run()]);
  return alone / one + alone / other;
}

/** @param {number[]} values */
export const median = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];
