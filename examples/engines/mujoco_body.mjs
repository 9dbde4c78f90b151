// SPDX-License-Identifier: MIT
// A figure in MuJoCo: the model that Gaitsmith exports with --mjcf, with its servos as motors that turn at a rate.
import loadMujoco from '../../web/node_modules/@mujoco/mujoco/mujoco.js';
import { STEP_S } from './figure.mjs';

/** @param {string} mjcf  of the same document @returns {import('./engine.d.ts').BuildBody} */
export const bodyOf = (mjcf) => async (controller, { joint_nm: strong, substeps = 5 }) => {
  const mujoco = await loadMujoco();
  // A servo for rates: its force is gain × (rate asked for − rate).
  const gain = strong / 20;
  const text = mjcf.replaceAll(/<position name="([^"]*)" joint="([^"]*)"[^>]*?( forcelimited="true" forcerange="[^"]*")?\/>/g,
    (_, name, joint, limit = '') => `<velocity name="${name}" joint="${joint}" kv="${gain}"${limit}/>`).replaceAll(/ ctrl="[^"]*"/g, '');
  const model = mujoco.MjModel.from_xml_string(text);
  const data = new mujoco.MjData(model);
  model.opt.timestep = STEP_S / substeps;
  mujoco.mj_resetDataKeyframe(model, data, 0);
  mujoco.mj_forward(model, data);
  const { rods } = controller.figure;
  // Bodies, joints and balls are numbered depth first.
  /** @type {(rod: number) => number[]} */
  const from = (rod) => [rod, ...rods.flatMap(({ parent }, child) => (parent === rod ? from(child) : []))];
  const order = from(0);
  const moving = order.filter((rod) => rod > 0 && controller.joints[rod - 1].max_rad > controller.joints[rod - 1].min_rad);
  const placeOf = controller.joints.map((_, joint) => moving.indexOf(joint + 1));
  // Limp joints have no motor.
  const driven = moving.filter((rod) => controller.joints[rod - 1].greatest_torque_nm !== 0);
  const motorOf = controller.joints.map((_, joint) => driven.indexOf(joint + 1));
  // Balls, in the order of the model: the root's start, then each rod's end.
  const balls = [0, ...order.map((rod) => rod + 1)];
  const geoms = Array.from({ length: model.ngeom }, (_, geom) => geom).filter((geom) => model.geom_contype[geom] === 1);
  const endpointOf = new Map(geoms.map((geom, i) => [geom, balls[i]]));
  const pushed = rods.map(() => 0).concat(0);
  const force = new mujoco.DoubleBuffer(6); // across, and along the ground

  return {
    angle: (joint) => (placeOf[joint] < 0 ? 0 : data.qpos[3 + placeOf[joint]]),
    rate: (joint) => (placeOf[joint] < 0 ? 0 : data.qvel[3 + placeOf[joint]]),
    drive: (joint, rate) => { if (motorOf[joint] >= 0) data.ctrl[motorOf[joint]] = rate; },
    advance() {
      pushed.fill(0);
      for (let i = 0; i < substeps; i++) {
        mujoco.mj_step(model, data);
        for (let k = 0; k < data.ncon; k++) {
          const contact = /** @type {any} */ (data.contact.get(k));
          const endpoint = endpointOf.get(contact.geom1) ?? endpointOf.get(contact.geom2);
          mujoco.mj_contactForce(model, data, k, force);
          if (endpoint !== undefined) pushed[endpoint] += force.GetView()[0] / substeps;
          contact.delete();
        }
      }
    },
    force: (endpoint) => pushed[endpoint],
    centre() {
      mujoco.mj_subtreeVel(model, data);
      return { x: data.subtree_com[0], y: data.subtree_com[2], vx: data.subtree_linvel[0], vy: data.subtree_linvel[2] };
    },
    push(vx, vy) {
      data.qvel[0] += vx;
      data.qvel[1] += vy;
    },
    turn: () => data.qpos[2],
  };
};
