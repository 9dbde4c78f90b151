// SPDX-License-Identifier: MIT
// How far a document's motion comes in four other engines, driven by the runtime.
import { execFileSync } from 'node:child_process';
import { strongJoint } from '../../../examples/engines/figure.mjs';
import { engineOf, play } from '../../../examples/engines/play.mjs';
import { load } from '../../../web/runtime/runtime.js';

export const ENGINES = ['planck', 'rapier', 'box2d', 'mujoco'];
/** Whose searches are compared (robust/question.md). */
export const FIGURES = ['mr-star-man', 'beryl-biped', 'ostrich', 'frog', 'hopper', 'inchworm', 'caterpillar', 'crab', 'spider', 'torsoless-biped'];

/** @param {string} program @param {string[]} options */
export const run = (program, options) => execFileSync(program, options, { encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });

/**
 * The way here and in each of ENGINES [m]. @param {string} gaitsmith @param {string} box2d  built programs
 * @param {string} path  of a document with one clip on level ground @param {number} seconds
 */
export async function waysOf(gaitsmith, box2d, path, seconds) {
  const controller = load(run(gaitsmith, ['export', path, '--controller', '-']));
  const mjcf = run(gaitsmith, ['export', path, '--mjcf', '-']);
  const own = Number(run(gaitsmith, ['measure', path]).split('\n')[1].split(',')[0]);
  /** @type {number[]} */
  const ways = [];
  for (const engine of ENGINES) {
    if (engine === 'box2d') {
      ways.push(JSON.parse(run(box2d, [path, `${seconds}`])).x_m);
      continue;
    }
    const body = await (await engineOf(engine, mjcf))(controller, { joint_nm: strongJoint(controller) });
    const way = play(controller, body, seconds);
    ways.push(Number(way[way.length - 1].x.toFixed(3)));
  }
  return { kind: controller.kind, own, ways };
}
