// SPDX-License-Identifier: MIT
// Results of the command line, to compare with those of browsers.
import { spawn } from 'node:child_process';
import { existsSync } from 'node:fs';
import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { ROOT } from './browsers.mjs';

const PROGRAM = ['release', 'dev'].map((preset) => join(ROOT, `build/${preset}/shell/gaitsmith`)).find(existsSync);

/** @param {string[]} words @param {string} [input] @returns {Promise<string>} what it prints */
async function gaitsmith(words, input = '') {
  const child = spawn(/** @type {string} */ (PROGRAM), words, { stdio: ['pipe', 'pipe', 'inherit'] });
  child.stdin.end(input);
  let output = '';
  child.stdout.on('data', (data) => { output += data; });
  await new Promise((resolve) => child.on('close', resolve));
  return output;
}

/**
 * @param {string} text   a document
 * @param {string} label  the problem's name in the file
 * @param {{algorithms: string[], trials: number, evaluations: number, firstSeed: number}} options
 * @returns {Promise<string | null>} the file of curves that `gaitsmith compare` writes; null as below
 */
export async function nativeCurves(text, label, { algorithms, trials, evaluations, firstSeed }) {
  if (!PROGRAM) return null;
  const folder = await mkdtemp(join(tmpdir(), 'gaitsmith-'));
  try {
    const curves = join(folder, 'curves.csv');
    await writeFile(join(folder, `${label}.json`), text);
    await gaitsmith(['compare', '--problem', join(folder, `${label}.json`), ...algorithms.flatMap((name) => ['--search', name]),
      '--trials', `${trials}`, '--evaluations', `${evaluations}`, '--first-seed', `${firstSeed}`,
      '--out', join(folder, 'results.csv'), '--curves', curves]);
    return await readFile(curves, 'utf8');
  } finally {
    await rm(folder, { recursive: true });
  }
}

/**
 * @param {string} text  JSON or a link
 * @returns {Promise<string | null>} the trajectory hash; null: the command line has not been built
 */
export async function nativeHash(text) {
  if (!PROGRAM) return null;
  const output = await gaitsmith(['hash', '-'], text);
  const found = /\b[0-9a-f]{16}\b/.exec(output);
  if (!found) throw new Error(`gaitsmith hash said: ${output}`);
  return found[0];
}
