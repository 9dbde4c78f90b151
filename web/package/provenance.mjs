// SPDX-License-Identifier: MIT
// The last step of packing: PROVENANCE.json says what the packed files are made of, SHA256SUMS has a line for each file.
//
//   node web/package/provenance.mjs <folder of the packed files>
import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { commit, project, textOf } from './release.mjs';
import { partsOf } from './third_party.mjs';

const [folder] = process.argv.slice(2);
if (!folder) throw new Error('provenance: of which folder?');

/** @typedef {import('./third_party.mjs').Package} Package */

/** What a packed file is, by its name. @type {[RegExp, Package, string][]} */
const KINDS = [
  [/^gaitsmith-engine-.*\.tgz$/, 'engine', 'Emscripten'],
  [/^gaitsmith-runtime-.*\.tgz$/, 'runtime', ''],
  [/^gaitsmith-[\d.]+\.h$/, 'header', ''],
  [/-cmake-.*\.tar\.gz$/, 'library', 'C++'],
  [/^gaitsmith_.*\.(deb|tar\.gz)$/, 'program', 'C++'],
];

/** @param {string} name */
const sha256 = (name) => createHash('sha256').update(readFileSync(join(folder, name))).digest('hex');

const names = readdirSync(folder).sort();
const files = names.map((file) => {
  const [, kind, compiler] = KINDS.find(([pattern]) => pattern.test(file)) ?? [];
  if (!kind) throw new Error(`provenance: what is ${file}?`);
  return {
    file, sha256: sha256(file), licence: [...new Set(['MIT', ...partsOf(kind).map(({ licence }) => licence)])].join(' AND '),
    ...compiler ? { compiler } : {}, holds: partsOf(kind).map(({ name }) => name),
  };
});
const parts = [...new Map(files.flatMap(({ file }) => partsOf(/** @type {Package} */ (KINDS.find(([pattern]) => pattern.test(file))?.[1])))
  .map((part) => [part.name, part])).values()];

/** The first line that a program prints of its version. @param {string} program */
const versionOf = (program) => execFileSync(program, ['--version'], { encoding: 'utf8' }).split('\n')[0].replace(/^.* (?=v?\d)/, '');

const provenance = {
  name: 'gaitsmith', version: project().version, ...commit(),
  command: './dev packages',
  tools: {
    'C++': textOf('build/release/compiler.txt').trim(), Emscripten: textOf('build/wasm/compiler.txt').trim(),
    CMake: versionOf('cmake'), Node: process.versions.node, npm: versionOf('npm'),
  },
  files,
  third_party: parts.map(({ name, version, licence, source, checksum }) => ({ name, version, licence, source, checksum: checksum() })),
};
writeFileSync(join(folder, 'PROVENANCE.json'), `${JSON.stringify(provenance, null, 2)}\n`);
writeFileSync(join(folder, 'SHA256SUMS'), [...names, 'PROVENANCE.json'].sort().map((name) => `${sha256(name)}  ${name}\n`).join(''));
