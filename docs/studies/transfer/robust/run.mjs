// SPDX-License-Identifier: MIT
// Searches in one and in five worlds, and what of them travels (question.md). Resumable: rows that are there are kept.
//   node docs/studies/transfer/robust/run.mjs GAITSMITH BOX2D_FIGURE [threads]     the built programs; writes robust.csv
// figure,joints,worlds,seed,own,planck,rapier,box2d,mujoco: how far each comes [m].
import { appendFileSync, existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { ENGINES, run, waysOf } from '../engines.mjs';

const [, , gaitsmith, box2d, threads = '2'] = process.argv;
const FIGURES = ['mr-star-man', 'beryl-biped', 'ostrich', 'frog', 'hopper', 'inchworm', 'caterpillar', 'crab', 'spider', 'torsoless-biped'];
const SIMULATED = 20_000;
const SECONDS = 8;
const file = fileURLToPath(new URL('robust.csv', import.meta.url));
if (!existsSync(file)) writeFileSync(file, `figure,joints,worlds,seed,own,${ENGINES.join(',')}\n`);
const known = new Set(readFileSync(file, 'utf8').split('\n').map((row) => row.split(',').slice(0, 4).join(',')));

const scratch = mkdtempSync(join(tmpdir(), 'robust-'));
try {
  for (const seed of [3001, 3002, 3003]) {
    for (const figure of FIGURES) {
      for (const joints of ['strong', 'limited']) {
        for (const worlds of [1, 5]) {
          const name = [figure, joints, worlds, seed].join(',');
          if (known.has(name)) continue;
          const path = join(scratch, 'found.json');
          run(gaitsmith, ['synthesize', '--figure', figure, '--task', 'travel-right', '--duration', `${SECONDS}`, '--joints', joints, '--search', 'sphc', '--evaluations', `${SIMULATED / worlds}`,
            '--search-option', `worlds=${worlds}`, '--seed', `${seed}`, '--threads', threads, '--out', path]);
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
