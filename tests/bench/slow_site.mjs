// SPDX-License-Identifier: MIT
// The built site with workers at a quarter of their speed: whatever the engine computes takes four times as long. The
// page itself runs as fast as ever.
import { rmSync } from 'node:fs';
import { cp, mkdtemp, readFile, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { execFile } from 'node:child_process';
import { promisify } from 'node:util';
import { ROOT, serve } from '../browser/browsers.mjs';

const SLOWNESS = 4;

/** Runs in a worker before its own script. */
const SLOWER = `
const instantiate = WebAssembly.instantiate;
WebAssembly.instantiate = async (...options) => {
  const instance = await instantiate(...options);
  const exports = Object.fromEntries(Object.entries(instance.exports).map(([name, value]) => [name, typeof value !== 'function' ? value : (...numbers) => {
    const start = performance.now();
    const result = value(...numbers);
    const end = performance.now() + ${SLOWNESS - 1} * (performance.now() - start);
    while (performance.now() < end);
    return result;
  }]));
  return { exports };
};
`;

/** @param {string} site  a folder @returns {Promise<string>} an address */
export async function slowSite(site) {
  const folder = await mkdtemp(join(tmpdir(), 'slow-site-'));
  process.on('exit', () => rmSync(folder, { recursive: true }));
  await cp(site, folder, { recursive: true });
  await writeFile(join(folder, 'search/slower.js'), SLOWER);
  const worker = join(folder, 'search/worker.js');
  await writeFile(worker, `import './slower.js';\n${await readFile(worker, 'utf8')}`);
  await promisify(execFile)(process.execPath, [join(ROOT, 'web/build/seal.mjs'), folder]);
  return serve(folder);
}
