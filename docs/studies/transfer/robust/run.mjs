// SPDX-License-Identifier: MIT
// Searches in one and in five worlds, and what of them travels (question.md). Resumable: rows that are there are kept.
//   node docs/studies/transfer/robust/run.mjs GAITSMITH BOX2D_FIGURE [threads]     the built programs; writes robust.csv
//   node docs/studies/transfer/robust/run.mjs GAITSMITH BOX2D_FIGURE threads control   one world with 4,000 evaluations: control.csv
//   node docs/studies/transfer/robust/run.mjs GAITSMITH noise [threads]            the same motions in our worlds: noise.csv
// robust.csv: figure,joints,worlds,seed,own,planck,rapier,box2d,mujoco: how far each comes [m].
// noise.csv: figure,joints,worlds,seed,friction,mass,slope,delay,all: in how many of 15 worlds that no search saw, each with one noise
// alone or with all, the motion keeps half of its way.
import { appendFileSync, existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { ENGINES, FIGURES, run, waysOf } from '../engines.mjs';

const [, , gaitsmith, box2d, threads = '2', control] = process.argv;
const NOISES = ['friction', 'mass', 'slope', 'delay', 'all'];
const UNSEEN = 9001; // seed of those worlds
const ours = box2d === 'noise';
const SIMULATED = 20_000;
const SECONDS = 8;
const file = fileURLToPath(new URL(ours ? 'noise.csv' : control ? 'control.csv' : 'robust.csv', import.meta.url));
if (!existsSync(file)) writeFileSync(file, `figure,joints,worlds,seed,${ours ? NOISES.join(',') : `own,${ENGINES.join(',')}`}\n`);
const known = new Set(readFileSync(file, 'utf8').split('\n').map((row) => row.split(',').slice(0, 4).join(',')));

/** Its way here and in the engines. @param {string} path */
async function engines(path) {
  const { own, ways } = await waysOf(gaitsmith, box2d, path, SECONDS);
  return [own.toFixed(3), ...ways];
}

/** In how many worlds a motion keeps half of its way, by noise. @param {string} path */
const kept = (path) => NOISES.map((noise) => {
  const rows = run(gaitsmith, ['measure', path, '--worlds', '16', '--seed', `${UNSEEN}`, ...noise === 'all' ? [] : ['--noise', noise]]).trim().split('\n').slice(1);
  const [own, ...there] = rows.map((row) => Number(row.split(',')[4]));
  return there.filter((way) => way / own >= 0.5).length;
});

const scratch = mkdtempSync(join(tmpdir(), 'robust-'));
try {
  for (const seed of [3001, 3002, 3003]) {
    for (const figure of FIGURES) {
      for (const joints of ['strong', 'limited']) {
        for (const worlds of control ? [1] : [1, 5]) {
          const name = [figure, joints, worlds, seed].join(',');
          if (known.has(name)) continue;
          const path = join(scratch, 'found.json');
          run(gaitsmith, ['synthesize', '--figure', figure, '--task', 'travel-right', '--duration', `${SECONDS}`, '--joints', joints, '--search', 'sphc', '--evaluations', `${control ? SIMULATED / 5 : SIMULATED / worlds}`,
            '--search-option', `worlds=${worlds}`, '--seed', `${seed}`, '--threads', threads, '--out', path]);
          const row = [name, ...ours ? kept(path) : await engines(path)].join(',');
          appendFileSync(file, `${row}\n`);
          console.log(row);
        }
      }
    }
  }
} finally {
  rmSync(scratch, { recursive: true });
}
