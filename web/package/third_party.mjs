// SPDX-License-Identifier: MIT
// The code of others that packages hold, and the notices that must travel with it. Versions are read from where they
// are pinned.
import { createHash } from 'node:crypto';
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join, relative, sep } from 'node:path';
import { ROOT, textOf } from './release.mjs';

/**
 * @typedef {object} Part
 * @property {string} name
 * @property {string} version
 * @property {string} licence  SPDX
 * @property {string} source  where it comes from
 * @property {() => string} notice  for the package that holds it
 * @property {() => string} checksum  of its source
 */

/** A version of .dev/setup.sh. @param {string} name */
function pinned(name) {
  const version = new RegExp(`\\b${name}='?([\\w.~]+)`).exec(textOf('.dev/setup.sh'))?.[1];
  if (!version) throw new Error(`.dev/setup.sh has no version of ${name}`);
  return version;
}

/**
 * Of all files in a folder: the SHA-256 of the lines that sha256sum prints for its files, sorted by name. docs/published-packages.md
 * has the command.
 * @param {string} folder
 */
function checksumOf(folder) {
  const names = readdirSync(folder, { recursive: true, withFileTypes: true }).filter((entry) => entry.isFile() && !entry.name.endsWith('.pyc'))
    .map((entry) => relative(folder, join(entry.parentPath ?? entry.path, entry.name)).split(sep).join('/')).sort();
  const all = createHash('sha256');
  for (const name of names) all.update(`${createHash('sha256').update(readFileSync(join(folder, name))).digest('hex')}  ./${name}\n`);
  return `sha256:${all.digest('hex')}`;
}

const emscripten = () => textOf('.toolchain/emscripten-root').trim();
/** The one in use, which may be newer than the pinned one. */
const emscriptenVersion = () => /[\d.]+/.exec(readFileSync(join(emscripten(), 'emscripten-version.txt'), 'utf8'))?.[0] ?? '';

/** The folder of a library's sources: Debian's, or those that CMake fetched. @param {string} library */
function sourcesOf(library) {
  const folder = [`.toolchain/src/${library}`, `build/release/_deps/${library}-src`].map((name) => join(ROOT, name)).find(existsSync);
  if (!folder) throw new Error(`the sources of ${library} are not here: ./dev setup`);
  return folder;
}

/** @param {string} library @param {string[]} names  of its files */
const sourceOf = (library, ...names) => readFileSync(join(sourcesOf(library), ...names), 'utf8');

const EIGEN = () => /gaitsmith_fetch\(eigen (\S+?)\.git (\S+)\)/.exec(textOf('.dev/libraries.cmake')) ?? ['', '', ''];
const PYBIND11 = '/usr/share/doc/pybind11-dev/copyright';
const INTER = () => JSON.parse(textOf('web/package-lock.json')).packages['node_modules/inter-ui'];

/** @type {Record<string, () => Part>} */
const PARTS = {
  eigen: () => ({
    name: 'Eigen', version: pinned('EIGEN'), licence: 'MPL-2.0', source: `${EIGEN()[1]}, tag ${EIGEN()[2]}, unchanged`,
    notice: () => `Parts of it are compiled in. It is under the Mozilla Public License, version 2.0: https://mozilla.org/MPL/2.0/.\nYou can get its source at ${EIGEN()[1]} (tag ${EIGEN()[2]}). It is unchanged.\n`,
    checksum: () => `${checksumOf(join(sourcesOf('eigen'), 'Eigen'))} (folder Eigen)`,
  }),
  lodepng: () => ({
    name: 'LodePNG', version: pinned('LODEPNG'), licence: 'Zlib', source: 'https://github.com/lvandeve/lodepng, unchanged',
    notice: () => `Its compressor is compiled in.\n\n${sourceOf('lodepng', 'LICENSE')}`,
    checksum: () => `sha256:${createHash('sha256').update(sourceOf('lodepng', 'lodepng.cpp')).digest('hex')} (lodepng.cpp)`,
  }),
  stb: () => ({
    name: 'stb_truetype', version: /v([\d.]+)/.exec(sourceOf('imgui', 'imstb_truetype.h').split('// stb_truetype.h - ')[1])?.[1] ?? '', licence: 'MIT',
    source: 'https://github.com/nothings/stb, as Dear ImGui has it',
    notice: () => `Its rasteriser is compiled in.\n\n${/ALTERNATIVE A[^]*?(?=-{20})/.exec(sourceOf('imgui', 'imstb_truetype.h'))?.[0]}`,
    checksum: () => `sha256:${createHash('sha256').update(sourceOf('imgui', 'imstb_truetype.h')).digest('hex')} (imstb_truetype.h)`,
  }),
  inter: () => ({
    name: 'Inter', version: INTER().version, licence: INTER().license, source: 'npm package inter-ui, reduced to the characters that the application uses',
    notice: () => `The typeface is embedded, reduced to the characters that the application uses.\n\n${textOf('web/node_modules/inter-ui/LICENSE.txt')}`,
    checksum: () => INTER().integrity,
  }),
  pybind11: () => ({
    name: 'pybind11', version: textOf('build/release/shell/python/python.txt').split('\n')[1], licence: 'BSD-3-Clause', source: 'https://github.com/pybind/pybind11, the system\'s',
    notice: () => `Its templates are compiled in.\n\n${existsSync(PYBIND11) ? readFileSync(PYBIND11, 'utf8') : 'https://github.com/pybind/pybind11/blob/master/LICENSE'}`,
    checksum: () => 'the system\'s',
  }),
  emscripten: () => ({
    name: 'Emscripten', version: emscriptenVersion(), licence: 'MIT', source: `https://github.com/emscripten-core/emscripten, ${emscripten().startsWith(join(ROOT, '.toolchain')) ? 'the package of Debian' : 'from this machine'}`,
    notice: () => 'Copyright 2010 The Emscripten Authors. Its support code is in the module and its script, under the MIT License,\nwhose text is in LICENSE.\n',
    checksum: () => `${checksumOf(join(emscripten(), 'src'))} (folder src)`,
  }),
  musl: () => ({
    name: 'musl', version: `of Emscripten ${emscriptenVersion()}`, licence: 'MIT', source: 'https://musl.libc.org',
    notice: () => `Parts of it are compiled in.\n\n${readFileSync(join(emscripten(), 'system/lib/libc/musl/COPYRIGHT'), 'utf8').trim()}\n`,
    checksum: () => `${checksumOf(join(emscripten(), 'system/lib/libc'))} (folder system/lib/libc)`,
  }),
  llvm: () => ({
    name: 'libc++, libc++abi and compiler-rt of LLVM', version: `of Emscripten ${emscriptenVersion()}`, licence: 'Apache-2.0 WITH LLVM-exception', source: 'https://github.com/llvm/llvm-project',
    notice: () => 'Parts of them are compiled in. Their licence asks for no further notice then (its exception for compiled code).\n',
    checksum: () => ['libcxx', 'libcxxabi', 'compiler-rt'].map((name) => `${checksumOf(join(emscripten(), 'system/lib', name))} (folder system/lib/${name})`).join(', '),
  }),
};

/** What each package holds of others, and what the site's modules hold. */
const HELD = { engine: ['emscripten', 'musl', 'llvm', 'eigen', 'lodepng', 'stb'], site: ['emscripten', 'musl', 'llvm', 'eigen', 'lodepng', 'stb'], runtime: [], library: ['eigen'], program: ['eigen', 'inter', 'lodepng', 'stb'], python: ['eigen', 'inter', 'lodepng', 'stb', 'pybind11'], header: [] };

/** @typedef {keyof typeof HELD} Package */

/** @param {Package} name @returns {Part[]} */
export const partsOf = (name) => HELD[name].map((part) => PARTS[part]());

/** The text that must travel with a package. @param {Package} name */
export function noticesOf(name) {
  const parts = partsOf(name);
  return ['Gaitsmith is under the MIT License. It comes with code of others:\n',
    ...parts.map(({ name, version, licence, notice }) => `${'-'.repeat(72)}\n${name}${/^\d/.test(version) ? ' ' : ', '}${version} (${licence})\n\n${notice()}`)].join('\n');
}
