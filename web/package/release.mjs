// SPDX-License-Identifier: MIT
// What is released: the version, and the commit that it is built from.
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

export const WEB = join(dirname(fileURLToPath(import.meta.url)), '..');
export const ROOT = join(WEB, '..');

/** The text of a file of the repository. @param {string} name */
export const textOf = (name) => readFileSync(join(ROOT, name), 'utf8');

/** @returns {{version: string, description: string}} as CMakeLists.txt has them */
export function project() {
  const [, version, description] = /project\(gaitsmith VERSION (\S+) .*DESCRIPTION "([^"]+)"/.exec(textOf('CMakeLists.txt')) ?? [];
  if (!version) throw new Error('CMakeLists.txt has no version');
  return { version, description };
}

/** @param {string[]} options */
const git = (...options) => execFileSync('git', ['-C', ROOT, ...options], { encoding: 'utf8' }).trim();

/** The commit that is checked out, its time, and whether the files are the commit's. */
export function commit() {
  return {
    commit: git('rev-parse', 'HEAD'),
    time: new Date(1000 * Number(git('log', '-1', '--format=%ct'))).toISOString(),
    clean: git('status', '--porcelain') === '',
  };
}
