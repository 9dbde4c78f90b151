// What play.mjs needs of an engine.
import type { Controller } from '../../web/runtime/runtime.d.ts';

/** A figure in an engine's world: rods that turn on each other, over level ground. Joints and endpoints as in docs/runtime.md. */
export interface Body {
  /** Of a joint, from the drawn pose [rad], and [rad/s]. */
  angle(joint: number): number;
  rate(joint: number): number;
  /** Lets a joint's motor turn this fast in the steps that follow [rad/s]. */
  drive(joint: number, rate: number): void;
  /** One step of 0.01 s. */
  advance(): void;
  /** The ground's push on an endpoint in the last step, the part away from the ground [N]. */
  force(endpoint: number): number;
  /** The centre of mass [m], and its velocity [m/s]. */
  centre(): { x: number; y: number; vx: number; vy: number };
  /** Changes the velocity of the whole figure [m/s]. */
  push(vx: number, vy: number): void;
  /** Turn of the root rod against the ground, whole turns included [rad]. */
  turn(): number;
}

/** joint_nm: what motors may give whose strength the controller does not say [N m]. substeps: of the engine, in 0.01 s. */
export type BuildBody = (controller: Controller, options: { joint_nm: number; substeps?: number }) => Promise<Body>;
