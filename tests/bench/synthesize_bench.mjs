// SPDX-License-Identifier: MIT
// The command line's search: seconds and peak memory (Linux only). Claim (g) of docs/performance.md. Writes
// build/bench-synthesize.json.
import { spawn } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { join } from 'node:path';
import { ROOT } from '../browser/browsers.mjs';
import { keep } from './machine.mjs';

const EVALUATIONS = 8000;
const LOOK_MS = 10; // polling interval; the high-water mark never falls, so the last sample counts

const started = performance.now();
const child = spawn(join(ROOT, 'build/release/shell/gaitsmith'),
  ['synthesize', '--duration', '10', '--evaluations', String(EVALUATIONS), '--out', join(ROOT, 'build/bench-synthesize.doc')],
  { stdio: 'inherit' });
let residentKb = 0;
const look = setInterval(() => {
  const status = `/proc/${child.pid}/status`;
  if (!existsSync(status)) return;
  const mark = /^VmHWM:\s+(\d+) kB/m.exec(readFileSync(status, 'utf8'));
  if (mark) residentKb = Math.max(residentKb, Number(mark[1]));
}, LOOK_MS);
child.once('exit', async (code) => {
  clearInterval(look);
  if (code !== 0) throw new Error(`gaitsmith ended with ${code}`);
  await keep('synthesize', {
    evaluations: EVALUATIONS,
    threads: availableParallelism(),
    seconds: (performance.now() - started) / 1000,
    residentBytes: residentKb ? 1024 * residentKb : null,
  });
});
