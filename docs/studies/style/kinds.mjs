// SPDX-License-Identifier: MIT
// What counts as a shuffle and as a cartwheel (docs/style.md), for rows of result files.

/** @typedef {Record<string, number>} Trial */
export const travel = (/** @type {Trial} */ trial) => Math.abs(trial.travel ?? NaN);
// More slip than if all endpoints that bear load were dragged the whole way is rubbing on the spot.
const rubs = (/** @type {Trial} */ t) => (t.slip_sum ?? NaN) > (t.bearers ?? NaN) * travel(t);
export const shuffle = (/** @type {Trial} */ t) => (t.slip_sum ?? NaN) >= 0.7 * travel(t) && !rubs(t) && (t.rotations ?? NaN) < 0.25;
export const cartwheel = (/** @type {Trial} */ t) => (t.rotations ?? NaN) >= 2 && (t.grounded ?? NaN) >= 0.7 && (t.bearers ?? NaN) >= 3;
