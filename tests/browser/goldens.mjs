// SPDX-License-Identifier: MIT
// Documents and links whose motions have pinned hashes, for every browser.
import { readdir, readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { ROOT } from './browsers.mjs';

/** @typedef {{name: string, text: string, hash: string | undefined}} Golden  hash: undefined if the document pins none */

/** The documents of a folder of the repository. @param {string} folder @returns {Promise<Golden[]>} */
export async function documentsIn(folder) {
  const files = (await readdir(join(ROOT, folder)).catch(() => /** @type {string[]} */ ([]))).filter((file) => file.endsWith('.json'));
  return Promise.all(files.sort().map(async (file) => {
    const text = await readFile(join(ROOT, folder, file), 'utf8');
    return { name: `${folder}/${file}`, text, hash: JSON.parse(text).hash };
  }));
}

export const goldenMotions = async () => (await Promise.all(['motions', 'limited', 'springs'].map((folder) => documentsIn(`tests/golden/${folder}`)))).flat();

/** The links that open for ever, of every version of the format. @returns {Promise<Golden[]>} */
export async function goldenLinks() {
  const files = (await readdir(join(ROOT, 'tests/golden/links'))).map((file) => /^version-(\d+)\.txt$/.exec(file)?.[1]);
  const versions = files.filter((version) => version !== undefined).map(Number).sort((a, b) => a - b);
  const all = await Promise.all(versions.map(async (version) => {
    const lines = (await readFile(join(ROOT, `tests/golden/links/version-${version}.txt`), 'utf8')).split('\n');
    return lines.filter((line) => /^[0-9a-f]{16} /.test(line)).map((line) => line.split(' '))
      .map(([hash, text]) => ({ name: `version ${version}: ${text.slice(0, 40)}…`, text, hash }));
  }));
  return all.flat();
}
