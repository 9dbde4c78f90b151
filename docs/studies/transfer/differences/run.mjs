// SPDX-License-Identifier: MIT
// Which difference between engines breaks motions (question.md)?
//   node docs/studies/transfer/differences/run.mjs GAITSMITH BOX2D_FIGURE     the built programs
// Writes ways.csv: motion, then how far it comes [m] here with 1, 2, 4, 16 and 64 substeps, and in each engine with usual steps,
// with sixteen times as many, and with those and motors a hundred times as strong (Box2D's motors cannot be set).
// And partings.csv: motion,engine,step: the first step at which the centre of mass is 2 cm elsewhere (empty: never); and whether a foot
// came down before, alone or beside another, and the share of all earlier steps of which that is true.
import { readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { strongJoint } from '../../../../examples/engines/figure.mjs';
import { engineOf, play } from '../../../../examples/engines/play.mjs';
import { load } from '../../../../web/runtime/runtime.js';
import { run } from '../engines.mjs';

const [, , gaitsmith, box2d] = process.argv;
const here = (/** @type {string} */ file) => fileURLToPath(new URL(file, import.meta.url));
const examples = here('../../../../examples/');
const motions = readFileSync(here('../transfer.csv'), 'utf8').trim().split('\n').slice(1).map((row) => row.split(','))
  .filter(([, , , , own]) => Math.abs(Number(own)) >= 1).map(([motion, , , seconds]) => ({ motion, seconds: Number(seconds) }));

const OWN_SUBSTEPS = [1, 2, 4, 16, 64];
const USUAL = { planck: 2, rapier: 2, box2d: 2, mujoco: 5 };
const FINER = 16, STRONGER = 100;
/** How far apart is elsewhere [m], and how long before a landing may have been [steps]. */
const APART_M = 0.02, BEFORE = 10;
/** A foot that has borne nothing for this long comes down [steps]: contact flickers. */
const OFF = 5;

/** In which steps a foot came down alone, and beside another that bore load. @param {string[]} head @param {number[][]} rows */
function landings(head, rows) {
  const forces = head.flatMap((name, i) => (/^fn\d+$/.test(name) ? [i] : []));
  const off = forces.map(() => 0);
  return rows.map((row) => {
    const came = forces.map((column, foot) => row[column] > 0 && off[foot] >= OFF);
    const stood = forces.some((column, foot) => row[column] > 0 && off[foot] === 0 && !came[foot]);
    forces.forEach((column, foot) => { off[foot] = row[column] > 0 ? 0 : off[foot] + 1; });
    const feet = came.filter(Boolean).length;
    return { two: feet > 1 || (feet === 1 && stood), one: feet === 1 && !stood };
  });
}

/** Whether it is so in one of the steps until this one. @param {boolean[]} so @param {number} step */
const lately = (so, step) => so.slice(Math.max(0, step - BEFORE + 1), step + 1).some(Boolean);

const ways = [['motion', ...OWN_SUBSTEPS.map((n) => `own_${n}`), ...Object.keys(USUAL).flatMap((engine) => [engine, `${engine}_fine`, ...engine === 'box2d' ? [] : [`${engine}_strong`]])].join(',')];
const partings = ['motion,engine,step,two_feet,two_feet_share,one_foot,one_foot_share'];
for (const { motion, seconds } of motions) {
  const path = `${examples}${motion}.json`;
  const controller = load(run(gaitsmith, ['export', path, '--controller', '-']));
  const mjcf = run(gaitsmith, ['export', path, '--mjcf', '-']);
  const own = OWN_SUBSTEPS.map((n) => Number(run(gaitsmith, ['measure', path, '--substeps', `${n}`]).split('\n')[1].split(',')[0]).toFixed(3));
  const csv = run(gaitsmith, ['simulate', path, '--csv', '-']).trim().split('\n').filter((line) => !line.startsWith('#')).map((line) => line.split(','));
  const rows = csv.slice(2).map((row) => row.map(Number)); // without the start
  const x = csv[0].indexOf('x'), start = Number(csv[1][x]);
  const down = landings(csv[0], rows);

  /** @type {string[]} */
  const there = [];
  for (const [engine, substeps] of Object.entries(USUAL)) {
    if (engine === 'box2d') {
      for (const n of [substeps, substeps * FINER]) there.push(JSON.parse(run(box2d, [path, `${seconds}`, `${n}`])).x_m);
      continue;
    }
    for (const [n, times] of [[substeps, 1], [substeps * FINER, 1], [substeps * FINER, STRONGER]]) {
      const way = play(controller, await (await engineOf(engine, mjcf))(controller, { joint_nm: times * strongJoint(controller), substeps: n }), seconds);
      there.push(way[way.length - 1].x.toFixed(3));
      if (times === 1) continue;
      const parted = way.findIndex((at, step) => Math.abs(at.x - (rows[step][x] - start)) > APART_M);
      const until = parted < 0 ? way.length - 1 : parted;
      const told = (['two', 'one']).flatMap((/** @type {'two' | 'one'} */ kind) => {
        const so = down.map((landing) => landing[kind]);
        const share = so.slice(0, until + 1).filter((_, step) => lately(so, step)).length / (until + 1);
        return [Number(lately(so, until)), share.toFixed(4)];
      });
      partings.push([motion, engine, parted < 0 ? '' : parted + 1, ...told].join(','));
    }
  }
  ways.push([motion, ...own, ...there].join(','));
  console.log(ways.at(-1));
}
writeFileSync(here('ways.csv'), `${ways.join('\n')}\n`);
writeFileSync(here('partings.csv'), `${partings.join('\n')}\n`);
