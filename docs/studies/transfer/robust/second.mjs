// SPDX-License-Identifier: MIT
// The second round of question.md. Resumable: rows that are there are kept.
//   node docs/studies/transfer/robust/second.mjs GAITSMITH BOX2D_FIGURE [threads [limited|strong]]   the built programs; writes second.csv
// figure,joints,kind,seed,own,planck,rapier,box2d,mujoco: how far each comes [m].
import { appendFileSync, existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { ENGINES, FIGURES, run, waysOf } from '../engines.mjs';

const [, , gaitsmith, box2d, threads = '2', only] = process.argv;
const KINDS = { one: [20_000], five: [4000, 'worlds=5'], finer: [4000, 'worlds=5', 'finest_step=quarter'], short: [4000] };
const SECONDS = 8;
const file = fileURLToPath(new URL('second.csv', import.meta.url));
if (!existsSync(file)) writeFileSync(file, `figure,joints,kind,seed,own,${ENGINES.join(',')}\n`);
/** What a row is of. @param {string} row */
const named = (row) => row.split(',').slice(0, 4).join(',');
const known = new Set(readFileSync(file, 'utf8').split('\n').map(named));

const scratch = mkdtempSync(join(tmpdir(), 'second-'));
try {
  for (const joints of only ? [only] : ['limited', 'strong']) {
    for (const seed of [5001, 5002, 5003]) {
      for (const figure of FIGURES) {
        for (const [kind, [evaluations, ...options]] of Object.entries(KINDS)) {
          const name = [figure, joints, kind, seed].join(',');
          if (known.has(name)) continue;
          const path = join(scratch, 'found.json');
          run(gaitsmith, ['synthesize', '--figure', figure, '--task', 'travel-right', '--duration', `${SECONDS}`, '--joints', joints, '--search', 'sphc',
            '--evaluations', `${evaluations}`, ...options.flatMap((option) => ['--search-option', `${option}`]), '--seed', `${seed}`, '--threads', threads, '--out', path]);
          const { own, ways } = await waysOf(gaitsmith, box2d, path, SECONDS);
          const row = [name, own.toFixed(3), ...ways].join(',');
          appendFileSync(file, `${row}\n`);
          console.log(row);
        }
      }
    }
  }
} finally {
  rmSync(scratch, { recursive: true });
}
