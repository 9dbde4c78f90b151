// SPDX-License-Identifier: MIT
// A figure in Planck (Box2D for JavaScript): a body for each rod, a revolute joint with a motor where they meet.
import { createRequire } from 'node:module';
import { BALL_M, centreOf, layOut, STEP_S } from './figure.mjs';

/** @type {typeof import('../../web/node_modules/planck/dist/planck.d.ts')} */
const { Circle, Edge, RevoluteJoint, Settings, Vec2, World } = createRequire(new URL('../../web/package.json', import.meta.url))('planck');

// Planck lets bodies overlap by one slop, and lines are thicker than they look.
const GROUND_M = -BALL_M - Settings.polygonRadius + Settings.linearSlop;

/** @type {import('./engine.d.ts').BuildBody} */
export async function buildBody(controller, { joint_nm: strong, substeps = 2 }) {
  const { gravity_mps2: gravity, friction } = controller.world;
  const world = new World({ gravity: new Vec2(0, -gravity) });
  world.createBody().createFixture(new Edge(new Vec2(-1e4, GROUND_M), new Vec2(1e4, GROUND_M)), { friction });
  /** Impulses of the last step, by endpoint. @type {number[]} */
  const pushed = [];

  const laid = layOut(controller);
  const bodies = laid.map(({ x, y, angle, length, mass, inertia }, rod) => {
    const body = world.createDynamicBody({ position: new Vec2(x, y), angle, allowSleep: false });
    const ball = (/** @type {number} */ at, /** @type {number} */ endpoint) =>
      body.createFixture(new Circle(new Vec2(at, 0), BALL_M), { friction, density: 0, filterGroupIndex: -1, userData: endpoint });
    if (rod === 0) ball(0, 0);
    ball(length, rod + 1);
    // Box2D wants the moment of inertia about the body's origin.
    body.setMassData({ mass, center: new Vec2(length / 2, 0), I: inertia + (mass * length * length) / 4 });
    return body;
  });
  const joints = laid.slice(1).map(({ x, y, parent }, joint) => {
    const { greatest_torque_nm: torque = strong } = controller.joints[joint];
    // Without limits of its own: the runtime keeps within them.
    return /** @type {import('../../web/node_modules/planck/dist/planck.d.ts').RevoluteJoint} */ (world.createJoint(new RevoluteJoint(
      { enableMotor: true, maxMotorTorque: torque }, bodies[parent], bodies[joint + 1], new Vec2(x, y))));
  });
  world.on('post-solve', (contact, { normalImpulses }) => {
    for (const fixture of [contact.getFixtureA(), contact.getFixtureB()]) {
      const endpoint = /** @type {number | undefined} */ (fixture.getUserData());
      if (typeof endpoint === 'number') pushed[endpoint] = (pushed[endpoint] ?? 0) + normalImpulses[0];
    }
  });

  return {
    angle: (joint) => joints[joint].getJointAngle(),
    rate: (joint) => joints[joint].getJointSpeed(),
    drive: (joint, rate) => joints[joint].setMotorSpeed(rate),
    advance() {
      pushed.length = 0;
      for (let i = 0; i < substeps; i++) world.step(STEP_S / substeps, 20, 8);
    },
    force: (endpoint) => (pushed[endpoint] ?? 0) / STEP_S,
    centre: () => centreOf(bodies.map((body, i) => {
      const [at, velocity] = [body.getWorldCenter(), body.getLinearVelocity()];
      return { x: at.x, y: at.y, vx: velocity.x, vy: velocity.y, mass: laid[i].mass };
    })),
    push(vx, vy) {
      for (const body of bodies) body.setLinearVelocity(Vec2.add(body.getLinearVelocity(), new Vec2(vx, vy)));
    },
    turn: () => bodies[0].getAngle(),
  };
}
