// SPDX-License-Identifier: MIT
// Plays a controller in another engine, driven by the runtime:
//   node examples/engines/play.mjs ENGINE CONTROLLER [--seconds S] [--push VX@S] [--mjcf MODEL] [--substeps N]
// ENGINE is planck, rapier or mujoco, which needs --mjcf. CONTROLLER is a file of gaitsmith export --controller. Prints how the
// figure moved, as JSON: its way along the ground [m], the height of its centre of mass at the end [m], and its turns.
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { begin, load, move, normalise, step } from '../../web/runtime/runtime.js';
import { STEP_S, strongJoint } from './figure.mjs';

/** @typedef {import('./engine.d.ts').Body} Body */
/** @typedef {import('../../web/runtime/runtime.d.ts').Controller} Controller */

/** How far a joint may be from where the runtime has it [rad]. */
const FOLLOWS_RAD = 0.05;

/** What the controller feels of a body, in the order of its senses. @param {Controller} controller @param {Body} body */
function feel(controller, body) {
  const { y, vy } = body.centre();
  return controller.senses.map(({ name }, i) => {
    const [what, number] = name.split(' ');
    if (what === 'touch') return body.force(Number(number) - 1) > 0 ? 1 : 0;
    const reading = { angle: () => body.angle(Number(number) - 1), force: () => body.force(Number(number) - 1), height: () => y, rise: () => vy,
      // Level ground: nothing is higher ahead, and there is no corner.
      ahead: () => 0, corner: () => controller.senses[i].at_one, timer: () => 0 }[what];
    if (!reading) throw new Error(`no reading for ${name}`);
    return controller.kind === 'network' ? reading() : normalise(controller, i, reading());
  });
}

/**
 * Plays a controller. Every 0.01 s each joint's motor gets the rate that leads to where the joint should be after the step.
 * @param {Controller} controller @param {Body} body @param {number} seconds
 * @param {{at: number, vx: number}[]} [pushes]  seconds, and by how much the figure becomes faster [m/s]
 */
export function play(controller, body, seconds, pushes = []) {
  const state = begin(controller);
  const from = { ...body.centre(), turn: body.turn() };
  // Engines give a joint's mean rate over a step; the runtime needs the rate at its end, so it keeps its own.
  const joints = controller.joints.map((_, joint) => ({ angle: body.angle(joint), rate: 0 }));
  /** @type {{x: number, y: number, turn: number}[]} */
  const way = [];
  for (let i = 0; i < Math.round(seconds / STEP_S); i++) {
    for (const { at, vx } of pushes) if (Math.round(at / STEP_S) === i) body.push(vx, 0);
    joints.forEach((ideal, joint) => {
      const now = body.angle(joint);
      // A motor that is too weak, or a limb that is held: the joint goes on from where it is.
      if (Math.abs(now - ideal.angle) > FOLLOWS_RAD) Object.assign(ideal, { angle: now, rate: body.rate(joint) });
      move(controller, state, joint, ideal);
      body.drive(joint, (ideal.angle - now) / STEP_S);
    });
    body.advance();
    step(controller, state, feel(controller, body));
    const { x, y } = body.centre();
    way.push({ x: x - from.x, y, turn: body.turn() - from.turn });
  }
  return way;
}

/** An engine by name. @param {string} name @param {string} [mjcf]  MuJoCo's model @returns {Promise<import('./engine.d.ts').BuildBody>} */
export async function engineOf(name, mjcf = '') {
  if (name === 'planck') return (await import('./planck_body.mjs')).buildBody;
  if (name === 'rapier') return (await import('./rapier_body.mjs')).buildBody;
  if (name === 'mujoco') return (await import('./mujoco_body.mjs')).bodyOf(mjcf);
  throw new Error(`there is no engine ${name}: planck, rapier or mujoco`);
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const [engine, file, ...options] = process.argv.slice(2);
  const option = (/** @type {string} */ name, standard = '') => (options.includes(name) ? options[options.indexOf(name) + 1] : standard);
  const controller = load(readFileSync(file, 'utf8'));
  if (controller.figure.nodes) throw new Error(`${file}: is of a figure of springs, and these engines get bodies of rods`);
  const mjcf = option('--mjcf') && readFileSync(option('--mjcf'), 'utf8');
  const body = await (await engineOf(engine, mjcf))(controller, { joint_nm: strongJoint(controller), substeps: option('--substeps') ? Number(option('--substeps')) : undefined });
  const pushes = option('--push') ? [option('--push').split('@').map(Number)].map(([vx, at]) => ({ vx, at })) : [];
  const way = play(controller, body, Number(option('--seconds', '10')), pushes);
  const { x, y, turn } = way[way.length - 1];
  console.log(JSON.stringify({ engine, x_m: Number(x.toFixed(3)), height_m: Number(y.toFixed(3)), turns: Number((turn / (2 * Math.PI)).toFixed(2)) }));
}
