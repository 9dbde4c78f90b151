// SPDX-License-Identifier: MIT
// Documents of figures in flight, for comparison with other engines. Joints are limp, or always at their greatest
// torque, so that another engine can have the same torques to the last digit.

/**
 * @typedef {{length_m: number, mass_kg: number, parent: number, parent_end: 'start' | 'end', rest_rad: number, min_rad: number, max_rad: number,
 *   strength: number}} Rod  the first is the root; parents stand before their children
 * @typedef {{step: number, endpoint: number, impulse_x_ns: number, impulse_y_ns: number}} Push
 * @typedef {{model: number, figure: {name: string, rods: Rod[]}, environment: {gravity_mps2: number, slope_rad: number},
 *   start: {drop_height_m: number, velocity_x_mps: number, velocity_y_mps: number, spin_radps: number}, pushes: Push[],
 *   controllers: {rules: {pose: number[]}[]}[]}} Flight  the fields of a document that a flight depends on
 */

export const GENE_MAX = 65535;
export const STANDARD_GRAVITY = 9.8; // of the unit of strength [m/s^2]

/** The unit of strength, M g L [N m]. @param {Rod[]} rods */
export function unitOfStrength(rods) {
  return rods.reduce((sum, rod) => sum + rod.mass_kg, 0) * STANDARD_GRAVITY * Math.max(...rods.map((rod) => rod.length_m));
}

/**
 * The torque at each joint [N m], counterclockwise on its outer rod. Each rule's pose is at a joint's limit, too far away
 * to be reached.
 * @param {Flight} flight
 */
export function torques({ figure: { rods }, controllers }) {
  const unit = unitOfStrength(rods);
  const pose = controllers[0]?.rules[0].pose ?? [];
  return rods.slice(1).map((rod, joint) => (pose[joint] ? 1 : -1) * rod.strength * unit);
}

/** @typedef {[parent: number, end: 'start' | 'end', length_m: number, mass_kg: number, rest_rad: number, torque_nm?: number]} Limb */

/**
 * @param {string} name
 * @param {Limb[]} limbs
 * @param {{spin?: number, slope?: number, pushes: [endpoint: number, x: number, y: number][]}} thrown
 * @returns {Flight}
 */
function flight(name, limbs, { spin = 0, slope = 0, pushes }) {
  const free = { min_rad: -Math.PI, max_rad: Math.PI };
  const rods = limbs.map(([parent, end, length, mass, rest]) =>
    ({ length_m: length, mass_kg: mass, parent, parent_end: end, rest_rad: rest, ...free, strength: 0 }));
  const unit = unitOfStrength(rods);
  limbs.forEach(([, , , , , torque = 0], i) => { rods[i].strength = Math.abs(torque) / unit; });
  const senses = { kind: 'timer', period_steps: 12000, tau_min_s: 0.02, tau_max_s: 0.02 };
  const pose = limbs.slice(1).map(([, , , , , torque = 0]) => (torque > 0 ? GENE_MAX : 0));
  const driven = limbs.some(([, , , , , torque = 0]) => torque !== 0);
  return /** @type {Flight} */ ({
    model: 2,
    figure: { name, rods },
    environment: { gravity_mps2: 9.8, slope_rad: slope },
    // Up and down again within a second: numbers near 0 keep their digits.
    start: { drop_height_m: 3, velocity_x_mps: 0.5, velocity_y_mps: 4.9, spin_radps: spin },
    pushes: pushes.map(([endpoint, x, y]) => ({ step: 0, endpoint, impulse_x_ns: x, impulse_y_ns: y })),
    ...driven ? { controllers: [{ name: 'Always', senses, rules: [{ when: {}, pose, tau: 0 }] }], timeline: [{ controller: 0, start_step: 0 }] }
      : { controllers: [] },
  });
}

/**
 * A chain of rods of 0.5 m and 1 kg in a zigzag. @param {number} rods @param {number[]} [torques_nm] of its joints
 * @returns {Limb[]}
 */
const chain = (rods, torques_nm = []) => Array.from({ length: rods }, (_, i) =>
  /** @type {Limb} */ ([i - 1, 'end', 0.5, 1, i === 0 ? 0.3 : i % 2 ? -0.6 : 0.6, torques_nm[i - 1] ?? 0]));

/** @type {Limb[]} a trunk with two arms and two legs, one of them with a shank */
const BRANCHES = [
  [-1, 'end', 0.8, 3, 1.4],
  [0, 'end', 0.5, 0.6, 2.2], [0, 'end', 0.5, 0.6, -2],
  [0, 'start', 0.6, 1, 2.7], [0, 'start', 0.6, 1, -2.6], [3, 'end', 0.5, 0.7, -0.5],
];
/** The same with torques at its joints. @param {number[]} torques_nm @returns {Limb[]} */
const branched = (torques_nm) => BRANCHES.map(([parent, end, length, mass, rest], i) => [parent, end, length, mass, rest, torques_nm[i - 1] ?? 0]);

/** Named by their rods, and by whether their joints are limp or driven. @type {Flight[]} */
export const FLIGHTS = [
  flight('1 rod', chain(1), { spin: 1, pushes: [[1, 0.1, 0.4]] }),
  flight('2 limp rods', chain(2), { spin: 1, pushes: [[2, 0.1, 0.6]] }),
  flight('3 limp rods', chain(3), { spin: 1, pushes: [[3, 0.1, 0.5], [1, 0, -0.3]] }),
  flight('5 limp rods', chain(5), { spin: 1, pushes: [[5, 0.1, 0.5], [2, 0, -0.4]] }),
  flight('5 fast limp rods', chain(5), { spin: 3, pushes: [[5, 0.1, 0.5], [2, 0, -0.4]] }),
  flight('6 limp rods with branches', BRANCHES, { spin: 1, slope: 0.2, pushes: [[6, 0.15, 0.1], [2, 0, 0.2], [3, -0.2, 0]] }),
  flight('3 limp rods of masses 50:5:1', [[-1, 'end', 0.5, 10, 0.3], [0, 'end', 0.5, 1, -0.6], [1, 'end', 0.5, 0.2, 0.6]],
    { spin: 1, pushes: [[3, 0.05, 0.15]] }),
  flight('2 driven rods', chain(2, [0.08]), { spin: 1, pushes: [[2, 0.1, 0.2]] }),
  flight('3 driven rods', chain(3, [0.1, -0.06]), { spin: 1, pushes: [[3, 0.1, 0.2]] }),
  flight('5 driven rods with a limp joint', chain(5, [0.1, -0.08, 0, 0.06]), { spin: 1, pushes: [[5, 0.1, 0.2]] }),
  flight('6 driven rods with branches', branched([0.25, -0.2, -0.3, 0.3, 0.06]), { spin: 1, slope: -0.2, pushes: [[6, 0.1, 0.05]] }),
];
