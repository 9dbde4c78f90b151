// SPDX-License-Identifier: MIT
// node split.mjs <module.wasm> <later.txt> <rest.wasm> <folder of Binaryen's programs>
// Splits the application in two: what the first screen needs stays in module.wasm; the rest is loaded after the first
// frame (web/app/rest.js). later.txt names the entrances to the rest: functions that the first screen does not call.
// Whatever is reached only through them goes with them. A wrong entrance costs time at the start, nothing else: a
// function that is called before it is there is waited for.
import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { appendFileSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

const [file, entrances, rest, programs] = process.argv.slice(2);
const FEATURES = ['--enable-simd', '--enable-bulk-memory', '--enable-sign-ext', '--enable-nontrapping-float-to-int', '--enable-mutable-globals',
  '--enable-multivalue'];
/** @param {string} program @param {string[]} options */
const run = (program, options) => execFileSync(join(programs, program), [file, ...FEATURES, ...options],
  { encoding: 'utf8', maxBuffer: 1 << 28, stdio: ['ignore', 'pipe', 'pipe'] });

const starts = readFileSync(entrances, 'utf8').split('\n').filter((line) => line && !line.startsWith('#'));
/** @param {string} name  with other characters than letters and digits written as \\ and their code */
const isEntrance = (name) => {
  const plain = name.replace(/\\([0-9a-f]{2})/g, (_, code) => String.fromCharCode(parseInt(code, 16)));
  return starts.some((start) => plain.startsWith(start));
};

/** The functions that each calls. @type {Map<string, string[]>} */
const calls = new Map();
/** Functions that the page or a pointer may call, and all that these reach. */
const first = new Set();
for (const line of run('wasm-opt', ['--print-call-graph']).split('\n')) {
  const [, from, to] = /^ {2}"(.+)" -> "(.+)"/.exec(line) ?? [];
  if (from !== undefined) calls.get(from)?.push(to);
  const [, name, look, colour] = /^ {2}"(.+)" \[style="([^"]*)"(?:, fillcolor="(\w+)")?/.exec(line) ?? [];
  if (name === undefined || colour === 'turquoise') continue; // imported
  if (!calls.has(name)) calls.set(name, []);
  if ((colour === 'gray' || look.includes('rounded')) && !isEntrance(name)) first.add(name);
}
for (const name of first) { // grows meanwhile
  for (const called of calls.get(name) ?? []) if (!isEntrance(called)) first.add(called);
}
const later = [...calls.keys()].filter((name) => !first.has(name));
writeFileSync(`${rest}.functions`, later.join('\n'));
const pair = createHash('sha256').update(readFileSync(file)).digest().subarray(0, 16);
run('wasm-split', [`--split-funcs=@${rest}.functions`, '-o1', file, '-o2', rest]);
// A custom section in both: a page that loads the rest while its site is replaced must notice.
const section = Buffer.concat([Buffer.from([0, 5 + pair.length, 4]), Buffer.from('pair'), pair]);
for (const part of [file, rest]) appendFileSync(part, section);
console.log(`${later.length} of ${calls.size} functions are loaded after the first frame`);
