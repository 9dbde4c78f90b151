// SPDX-License-Identifier: MIT
// A figure in Rapier: a rigid body for each rod, a revolute joint with a motor where they meet.
import { createRequire } from 'node:module';
import { BALL_M, centreOf, layOut, STEP_S } from './figure.mjs';

/** @type {typeof import('../../web/node_modules/@dimforge/rapier2d-deterministic-compat/dist/exports.d.ts')} */
const RAPIER = createRequire(new URL('../../web/package.json', import.meta.url))('@dimforge/rapier2d-deterministic-compat');

const ITERATIONS = 12;
// What Rapier 0.20 reports of a contact is the sum over its iterations and one more: figures that stand push (n + 1) / n of
// their weight, for n of 1, 4, 8 and 12.
const OF_REPORTED = ITERATIONS / (ITERATIONS + 1);
const GROUND = 1, FIGURE = 2;
/** What is one and what it touches. @param {number} is @param {number} touches */
const groups = (is, touches) => (is << 16) | touches;

/** @type {import('./engine.d.ts').BuildBody} */
export async function buildBody(controller, { joint_nm: strong, substeps = 2 }) {
  await RAPIER.init();
  const { gravity_mps2: gravity, friction } = controller.world;
  const world = new RAPIER.World({ x: 0, y: -gravity });
  world.timestep = STEP_S / substeps;
  world.numSolverIterations = ITERATIONS;
  const ground = world.createCollider(RAPIER.ColliderDesc.cuboid(1e4, 1).setTranslation(0, -1 - BALL_M).setFriction(friction).setCollisionGroups(groups(GROUND, FIGURE)));

  const laid = layOut(controller);
  /** By endpoint. @type {import('../../web/node_modules/@dimforge/rapier2d-deterministic-compat/dist/exports.d.ts').Collider[]} */
  const balls = [];
  const bodies = laid.map(({ x, y, angle, length, mass, inertia }, rod) => {
    const body = world.createRigidBody(RAPIER.RigidBodyDesc.dynamic().setTranslation(x, y).setRotation(angle).setCanSleep(false)
      .setAdditionalMassProperties(mass, { x: length / 2, y: 0 }, inertia));
    const ball = (/** @type {number} */ at) => world.createCollider(RAPIER.ColliderDesc.ball(BALL_M).setTranslation(at, 0).setDensity(0)
      .setFriction(friction).setCollisionGroups(groups(FIGURE, GROUND)), body);
    if (rod === 0) balls.push(ball(0));
    balls.push(ball(length));
    return body;
  });
  const joints = laid.slice(1).map(({ parent, atEnd }, i) => {
    const { greatest_torque_nm: torque = strong } = controller.joints[i];
    const data = RAPIER.JointData.revolute({ x: atEnd ? laid[parent].length : 0, y: 0 }, { x: 0, y: 0 });
    const joint = /** @type {any} */ (world.createImpulseJoint(data, bodies[parent], bodies[i + 1], true));
    joint.setContactsEnabled(false);
    // Without limits of its own: the runtime keeps within them.
    joint.configureMotorModel(RAPIER.MotorModel.ForceBased);
    joint.setMotorMaxForce(torque);
    return joint;
  });
  const turns = (/** @type {number} */ rod) => bodies[rod].rotation();
  // Rotations come within one turn: what has passed is counted.
  let turned = laid[0].angle;
  const near = (/** @type {number} */ angle, /** @type {number} */ to) => angle + 2 * Math.PI * Math.round((to - angle) / (2 * Math.PI));
  const angle = (/** @type {number} */ joint) => {
    const { parent } = laid[joint + 1];
    const drawn = laid[joint + 1].angle - laid[parent].angle;
    return near(turns(joint + 1) - turns(parent) - drawn, 0);
  };
  const pushed = balls.map(() => 0);

  return {
    angle,
    rate: (joint) => bodies[joint + 1].angvel() - bodies[laid[joint + 1].parent].angvel(),
    drive: (joint, rate) => joints[joint].configureMotorVelocity(rate, 1e5),
    advance() {
      pushed.fill(0);
      for (let i = 0; i < substeps; i++) {
        world.step();
        balls.forEach((ball, endpoint) => world.contactPair(ground, ball, (manifold) => {
          for (let k = 0; k < manifold.numContacts(); k++) pushed[endpoint] += OF_REPORTED * manifold.contactImpulse(k);
        }));
      }
      turned = near(turns(0), turned);
    },
    force: (endpoint) => pushed[endpoint] / STEP_S,
    centre: () => centreOf(bodies.map((body, i) => {
      const [at, velocity, half] = [body.translation(), body.linvel(), laid[i].length / 2];
      return { x: at.x + half * Math.cos(turns(i)), y: at.y + half * Math.sin(turns(i)), vx: velocity.x, vy: velocity.y, mass: laid[i].mass };
    })),
    push(vx, vy) {
      for (const body of bodies) body.setLinvel({ x: body.linvel().x + vx, y: body.linvel().y + vy }, true);
    },
    turn: () => turned,
  };
}
