// SPDX-License-Identifier: MIT
// The command line's opinion of a document, to compare browsers with.
import { spawn } from 'node:child_process';
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { ROOT } from './browsers.mjs';

const PROGRAM = ['release', 'dev'].map((preset) => join(ROOT, `build/${preset}/shell/gaitsmith`)).find(existsSync);

/**
 * @param {string} text  JSON or a link
 * @returns {Promise<string | null>} the trajectory hash; null: the command line has not been built
 */
export async function nativeHash(text) {
  if (!PROGRAM) return null;
  const child = spawn(PROGRAM, ['hash', '-'], { stdio: ['pipe', 'pipe', 'inherit'] });
  child.stdin.end(text);
  let output = '';
  child.stdout.on('data', (data) => { output += data; });
  await new Promise((resolve) => child.on('close', resolve));
  const found = /\b[0-9a-f]{16}\b/.exec(output);
  if (!found) throw new Error(`gaitsmith hash said: ${output}`);
  return found[0];
}
