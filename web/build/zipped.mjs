// SPDX-License-Identifier: MIT
// ZIP files of the site. The same files give the same bytes: the names are sorted, and all times are equal.
import { readdir, readFile } from 'node:fs/promises';
import { join, relative, sep } from 'node:path';
import { zipSync } from 'fflate';

const TIME = new Date(1980, 0, 1); // the earliest of a ZIP, in any time zone

/** The names of the files in a folder, without ZIPs, sorted. @param {string} folder */
export async function namesIn(folder) {
  return (await readdir(folder, { recursive: true, withFileTypes: true }))
    .filter((entry) => entry.isFile())
    .map((entry) => relative(folder, join(entry.parentPath ?? entry.path, entry.name)).split(sep).join('/'))
    .filter((name) => !name.endsWith('.zip'))
    .sort();
}

/** @param {string} folder @param {string[]} names @returns {Promise<Record<string, Uint8Array>>} */
export async function filesOf(folder, names) {
  return Object.fromEntries(await Promise.all(names.map(async (name) => [name, await readFile(join(folder, name))])));
}

/** @param {Record<string, Uint8Array>} files @param {string} [top]  a folder for all */
export function zipped(files, top = '') {
  return zipSync(Object.fromEntries(Object.keys(files).sort().map((name) => [top + name, [files[name], { level: 9, mtime: TIME }]])));
}
