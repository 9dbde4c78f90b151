// SPDX-License-Identifier: MIT
// The same flight in MuJoCo, of the model that we export, in double precision, by Runge-Kutta of fourth order.
import loadMujoco from '../../web/node_modules/@mujoco/mujoco/mujoco.js';
import { torques } from './figures.mjs';

/** @typedef {import('./figures.mjs').Flight} Flight */
/** @typedef {{root_rad: number, joint_rad: number[], x_m: number, rise_m: number, momentum_kgm2ps: number}} Place */

/** An exported model, for flights: other steps, and nothing but gravity acts. @param {string} mjcf @param {number} step_s */
function forFlights(mjcf, step_s) {
  const text = mjcf.replace(/<option timestep="[^"]*" integrator="[^"]*"([^>]*)\/>/,
    `<option timestep="${step_s}" integrator="RK4"$1><flag contact="disable" constraint="disable" actuation="disable"/></option>`);
  if (text === mjcf) throw new Error('the exported model has no options');
  return text;
}

/** MuJoCo numbers bodies and joints depth first. @param {Flight['figure']['rods']} rods @returns {number[]} rods in this order */
function depthFirst(rods) {
  /** @type {(i: number) => number[]} */
  const from = (i) => [i, ...rods.flatMap((rod, child) => (rod.parent === i ? from(child) : []))];
  return from(0);
}

const mujoco = await loadMujoco();

/**
 * Where a figure is after a flight.
 * @param {Flight} flight @param {string} mjcf  its model, as exported @param {number} seconds @param {number} step_s
 * @param {number} [early_s]  the torques have acted for this time before the flight, and the limbs have not moved yet
 * @returns {Place}
 */
export function fly(flight, mjcf, seconds, step_s, early_s = 0) {
  const { figure: { rods }, start } = flight;
  const order = depthFirst(rods);
  const hinge = rods.map((_, i) => 2 + order.indexOf(i));
  const model = mujoco.MjModel.from_xml_string(forFlights(mjcf, step_s));
  const data = new mujoco.MjData(model);
  data.qpos[hinge[0]] = rods[0].rest_rad; // the others are drawn in the model
  mujoco.mj_forward(model, data);
  const from = [...data.subtree_com];

  // Impulses at rest and without gravity: the accelerations that they would cause in a second are their velocities.
  const gravity = [...model.opt.gravity];
  model.opt.gravity.fill(0);
  for (const { endpoint, impulse_x_ns: x, impulse_y_ns: y } of flight.pushes) {
    const rod = Math.max(endpoint - 1, 0); // endpoint 0 is the root's start, each other one the end of a rod
    const body = 1 + order.indexOf(rod);
    const along = endpoint === 0 ? 0 : rods[rod].length_m;
    const [ax, az] = [data.xmat[9 * body], data.xmat[9 * body + 6]]; // the rod's direction
    const at = [data.xpos[3 * body] + along * ax, 0, data.xpos[3 * body + 2] + along * az];
    mujoco.mj_applyFT(model, data, [x, 0, y], [0, 0, 0], at, body, data.qfrc_applied);
  }
  torques(flight).forEach((torque, joint) => { data.qfrc_applied[hinge[joint + 1]] += early_s * torque; });
  mujoco.mj_forward(model, data);
  data.qvel.set(data.qacc);
  model.opt.gravity.set(gravity);
  // The whole figure flies and spins as one, about its centre of mass.
  data.qvel[0] += start.velocity_x_mps + start.spin_radps * from[2];
  data.qvel[1] += start.velocity_y_mps - start.spin_radps * from[0];
  data.qvel[2] += start.spin_radps;

  data.qfrc_applied.fill(0);
  torques(flight).forEach((torque, joint) => { data.qfrc_applied[hinge[joint + 1]] = torque; });
  for (let step = Math.round(seconds / step_s); step > 0; step--) mujoco.mj_step(model, data);
  mujoco.mj_forward(model, data);
  mujoco.mj_subtreeVel(model, data);
  const place = {
    root_rad: data.qpos[hinge[0]],
    joint_rad: rods.slice(1).map((_, joint) => data.qpos[hinge[joint + 1]]),
    x_m: data.subtree_com[0] - from[0],
    rise_m: data.subtree_com[2] - from[2],
    momentum_kgm2ps: -data.subtree_angmom[1],
  };
  data.delete();
  model.delete();
  return place;
}
