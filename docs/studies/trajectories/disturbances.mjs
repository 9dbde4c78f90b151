// SPDX-License-Identifier: MIT
// What question.md does to a motion, one at a time, from small to large.

/** @typedef {{name: 'push' | 'friction' | 'slope' | 'start', size: string, change: (document: any) => void}} Disturbance  size: as in the rows of survived.csv */

const massOf = (/** @type {any} */ document) => document.figure.rods.reduce((/** @type {number} */ sum, /** @type {any} */ { mass_kg: mass }) => sum + (mass ?? 1), 0);

/** @param {number} step @param {number} speed  [m/s] @returns {Disturbance} */
const push = (step, speed) => ({ name: 'push', size: `${speed}@${step}`, change(document) {
  document.pushes = [{ step, endpoint: -1, impulse_x_ns: speed * massOf(document), impulse_y_ns: 0 }];
} });
/** @param {number} ratio @returns {Disturbance} */
const friction = (ratio) => ({ name: 'friction', size: `${ratio}`, change(document) { document.environment.friction *= ratio; } });
/** @param {number} degrees @returns {Disturbance} */
const slope = (degrees) => ({ name: 'slope', size: `${degrees}`, change(document) { document.environment.slope_rad = (degrees * Math.PI) / 180; } });
/** @param {number} metres @returns {Disturbance} */
const drop = (metres) => ({ name: 'start', size: `drop ${metres}`, change(document) { document.start.drop_height_m = metres; } });
/** @param {number} speed @returns {Disturbance} */
const thrown = (speed) => ({ name: 'start', size: `speed ${speed}`, change(document) { document.start.velocity_x_mps = speed; } });

const bothWays = (/** @type {number[]} */ sizes) => sizes.flatMap((size) => [size, -size]);

/** @type {Disturbance[]} */
export const DISTURBANCES = [
  ...[300, 500].flatMap((step) => bothWays([0.1, 0.2, 0.5, 1, 2, 4]).map((speed) => push(step, speed))),
  ...[0.4, 0.6, 0.8, 1.25, 1.6, 2.5].map(friction),
  ...bothWays([1, 2, 5, 10]).map(slope),
  ...[0.02, 0.05, 0.1, 0.2, 0.5].map(drop),
  ...bothWays([0.2, 0.5, 1, 2]).map(thrown),
];
