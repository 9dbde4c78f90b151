// SPDX-License-Identifier: MIT
// The figure of an exported controller, in its drawn pose: where each rod lies, for an engine to build it.

/** @typedef {import('../../web/runtime/runtime.d.ts').Controller} Controller */
/** start: x, y [m]. end: of the parent, where it is attached. angle: against the ground [rad].
 * @typedef {{x: number, y: number, angle: number, length: number, mass: number, inertia: number, parent: number, atEnd: boolean}} LaidRod */

/** Only the rods' ends touch the ground, as in Gaitsmith: with balls of this radius [m]. */
export const BALL_M = 0.01;
export const STEP_S = 0.01;

/** The rods, on the ground at y = 0, with their centre of mass at x = 0. @param {Controller} controller @returns {LaidRod[]} */
export function layOut({ figure }) {
  /** @type {LaidRod[]} */
  const rods = [];
  for (const { length_m: length, mass_kg: mass, parent, parent_end: end, rest_rad: rest } of figure.rods) {
    const from = rods[parent];
    const along = from && end === 'end' ? from.length : 0;
    const [x, y] = from ? [from.x + along * Math.cos(from.angle), from.y + along * Math.sin(from.angle)] : [0, 0];
    rods.push({ x, y, angle: (from?.angle ?? 0) + rest, length, mass, inertia: (mass * length * length) / 12, parent, atEnd: along > 0 });
  }
  const ends = rods.flatMap(({ x, y, angle, length }) => [[x, y], [x + length * Math.cos(angle), y + length * Math.sin(angle)]]);
  const lowest = Math.min(...ends.map(([, y]) => y));
  const mass = rods.reduce((sum, rod) => sum + rod.mass, 0);
  const middle = rods.reduce((sum, { x, angle, length, mass: own }) => sum + own * (x + (length / 2) * Math.cos(angle)), 0) / mass;
  return rods.map((rod) => ({ ...rod, x: rod.x - middle, y: rod.y - lowest }));
}

/** The centre of mass of rods in motion. @param {{x: number, y: number, vx: number, vy: number, mass: number}[]} parts  their own centres */
export function centreOf(parts) {
  const mass = parts.reduce((sum, part) => sum + part.mass, 0);
  const mean = (/** @type {'x' | 'y' | 'vx' | 'vy'} */ of) => parts.reduce((sum, part) => sum + part.mass * part[of], 0) / mass;
  return { x: mean('x'), y: mean('y'), vx: mean('vx'), vy: mean('vy') };
}

/** What a joint's motor may give if its strength is not limited: far more than any motion needs [N m]. @param {Controller} controller */
export function strongJoint({ figure: { rods } }) {
  const mass = rods.reduce((sum, rod) => sum + rod.mass_kg, 0);
  return 100 * mass * 9.8 * Math.max(...rods.map((rod) => rod.length_m));
}
