// SPDX-License-Identifier: MIT
// Do found motions travel in other engines? (question.md) Plays the controllers of shipped motions in each of them:
//   node docs/studies/transfer/run.mjs GAITSMITH BOX2D_FIGURE     the built programs; writes transfer.csv
// motion,model,kind,seconds,own,planck,rapier,box2d,mujoco: how far each comes [m].
import { execFileSync } from 'node:child_process';
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { strongJoint } from '../../../examples/engines/figure.mjs';
import { engineOf, play } from '../../../examples/engines/play.mjs';
import { load } from '../../../web/runtime/runtime.js';

const [, , gaitsmith, box2d] = process.argv;
const examples = fileURLToPath(new URL('../../../examples/', import.meta.url));
const run = (/** @type {string} */ program, /** @type {string[]} */ options) => execFileSync(program, options, { encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });

/** Why a document's world cannot be built in the examples, or ''. @param {any} document */
function strange({ timeline = [], environment = {}, pushes = [], start = {} }) {
  if (timeline.length !== 1) return `${timeline.length} clips`;
  if (pushes.length > 0) return 'pushes';
  if (environment.slope_rad || environment.sway_rad || environment.ground?.length) return 'ground that is not level';
  return Object.values(start).some((value) => value !== 0) ? 'thrown or dropped' : '';
}

const rows = ['motion,model,kind,seconds,own,planck,rapier,box2d,mujoco'];
for (const folder of ['', 'gallery/']) {
  for (const file of readdirSync(examples + folder).filter((name) => name.endsWith('.json')).sort()) {
    const path = examples + folder + file;
    const document = JSON.parse(readFileSync(path, 'utf8'));
    const name = folder + file.replace('.json', '');
    const why = strange(document);
    if (why) {
      console.log(`${name}: left out, ${why}`);
      continue;
    }
    const text = run(gaitsmith, ['export', path, '--controller', '-']);
    const mjcf = run(gaitsmith, ['export', path, '--mjcf', '-']);
    const controller = load(text);
    const seconds = (document.duration_steps ?? 1000) / 100;
    const own = Number(run(gaitsmith, ['measure', path]).split('\n')[1].split(',')[0]);
    const ways = [];
    for (const engine of ['planck', 'rapier', 'box2d', 'mujoco']) {
      if (engine === 'box2d') {
        ways.push(JSON.parse(run(box2d, [path, `${seconds}`])).x_m);
        continue;
      }
      const body = await (await engineOf(engine, mjcf))(controller, { joint_nm: strongJoint(controller) });
      const way = play(controller, body, seconds);
      ways.push(Number(way[way.length - 1].x.toFixed(3)));
    }
    rows.push([name, document.model ?? 1, controller.kind, seconds, own.toFixed(3), ...ways].join(','));
    console.log(rows.at(-1));
  }
}
writeFileSync(fileURLToPath(new URL('transfer.csv', import.meta.url)), `${rows.join('\n')}\n`);
const found = rows.slice(1).map((row) => row.split(',')).filter(([, , , , own]) => Math.abs(Number(own)) >= 1);
['planck', 'rapier', 'box2d', 'mujoco'].forEach((engine, i) => {
  const shares = found.map((row) => Number(row[5 + i]) / Number(row[4])).sort((a, b) => a - b);
  console.log(`${engine}: ${shares.filter((share) => share >= 0.5).length} of ${shares.length} keep half of their way, median share ${shares[shares.length >> 1].toFixed(2)}`);
});
