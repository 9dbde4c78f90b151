// SPDX-License-Identifier: MIT
// Do found motions travel in other engines? (question.md) Plays the controllers of shipped motions in each of them:
//   node docs/studies/transfer/run.mjs GAITSMITH BOX2D_FIGURE     the built programs; writes transfer.csv
// motion,model,kind,seconds,own,planck,rapier,box2d,mujoco: how far each comes [m].
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { ENGINES, waysOf } from './engines.mjs';

const [, , gaitsmith, box2d] = process.argv;
const examples = fileURLToPath(new URL('../../../examples/', import.meta.url));

/** Why a document's world cannot be built in the examples, or ''. @param {any} document */
function strange({ figure, timeline = [], environment = {}, pushes = [], start = {} }) {
  if (figure.springs) return 'springs';
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
    const seconds = (document.duration_steps ?? 1000) / 100;
    const { kind, own, ways } = await waysOf(gaitsmith, box2d, path, seconds);
    rows.push([name, document.model ?? 1, kind, seconds, own.toFixed(3), ...ways].join(','));
    console.log(rows.at(-1));
  }
}
writeFileSync(fileURLToPath(new URL('transfer.csv', import.meta.url)), `${rows.join('\n')}\n`);
const found = rows.slice(1).map((row) => row.split(',')).filter(([, , , , own]) => Math.abs(Number(own)) >= 1);
ENGINES.forEach((engine, i) => {
  const shares = found.map((row) => Number(row[5 + i]) / Number(row[4])).sort((a, b) => a - b);
  console.log(`${engine}: ${shares.filter((share) => share >= 0.5).length} of ${shares.length} keep half of their way, median share ${shares[shares.length >> 1].toFixed(2)}`);
});
