// SPDX-License-Identifier: MIT
// MuJoCo judges model 2: figures in flight, whose joints are limp or at their greatest torque, after one second, with
// steps of different lengths. Writes a table of errors, and fails if one is large or shrinks too slowly.
//   node tests/peers/judge.mjs PROGRAM [--out CSV] [--spot]
// PROGRAM is the built flight.cpp. --spot: a single figure, in a second.
import { execFileSync } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import { FLIGHTS, torques } from './figures.mjs';
import { fly } from './mujoco.mjs';

/** @typedef {import('./mujoco.mjs').Place} Place */
/** @typedef {Place & {eased: number, touched: boolean, broken: boolean}} Flown  see flight.cpp */

const SECONDS = 1;
const STEPS_PER_SECOND = [100, 200, 400, 800];
const SPOT = '6 driven rods with branches';

/** What the two longest steps may cost [rad], and the power of the step by which that shrinks. */
const SECOND_ORDER = { most: 0.02, power: 2 };
const FIRST_ORDER = { most: 0.05, power: 1 };
/** The errors of the shorter steps may exceed what the longer ones lead to expect by this factor. */
const SLACK = 1.2;
/** What single precision adds in a second: to angles [rad], the centre of mass [m], the angular momentum [kg m^2/s]. */
const ROUNDING = 5e-5;
const MUJOCO_ERROR = 1e-8;

const [program, ...options] = process.argv.slice(2);
const spot = options.includes('--spot');
const fine_s = spot ? 1e-3 : 1e-4; // MuJoCo's step

/** @type {string[]} */
const faults = [];
/** @param {number[]} numbers */
const greatest = (numbers) => Math.max(0, ...numbers.map(Math.abs));
/** @param {Place} one @param {Place} other */
const errors = (one, other) => ({
  joint_rad: greatest(one.joint_rad.map((angle, joint) => angle - other.joint_rad[joint])),
  root_rad: Math.abs(one.root_rad - other.root_rad),
  centre_m: Math.hypot(one.x_m - other.x_m, one.rise_m - other.rise_m),
  momentum_kgm2ps: Math.abs(one.momentum_kgm2ps - other.momentum_kgm2ps),
});
/** @typedef {ReturnType<typeof errors>} Errors */

/** @param {string} name @param {Errors[]} all  from the longest step to the shortest @param {typeof SECOND_ORDER} order */
function check(name, all, { most, power }) {
  for (const quantity of /** @type {const} */ (['joint_rad', 'root_rad'])) {
    const shares = all.map((error, i) => error[quantity] * STEPS_PER_SECOND[i] ** power);
    // The longest step is solved twice if limbs turn fast, and then may err less than its half. So two steps lead.
    const expected = SLACK * Math.max(shares[0], shares[1]);
    all.forEach((error, i) => {
      const allowed = ROUNDING + (i < 2 ? most : expected / STEPS_PER_SECOND[i] ** power);
      if (!(error[quantity] <= allowed)) faults.push(`${name}: ${quantity} is off by ${error[quantity]}, at most ${allowed} is allowed`);
    });
  }
  // A fall and the angular momentum are exact, whatever the step.
  for (const quantity of /** @type {const} */ (['centre_m', 'momentum_kgm2ps'])) {
    const error = greatest(all.map((one) => one[quantity]));
    if (!(error <= ROUNDING)) faults.push(`${name}: ${quantity} is off by ${error}`);
  }
}

const rows = ['# ./dev peers', 'figure,torques,step_s,joint_rad,root_rad,centre_m,momentum_kgm2ps,order'];
/** @param {string} name @param {string} begin  when torques begin @param {Errors[]} all */
function write(name, begin, all) {
  all.forEach((error, i) => {
    const order = i > 0 && error.joint_rad > ROUNDING ? Math.log2(all[i - 1].joint_rad / error.joint_rad).toFixed(2) : '';
    rows.push([name, begin, 1 / STEPS_PER_SECOND[i], ...Object.values(error).map((value) => value.toExponential(1)), order].join(','));
  });
}

for (const flight of FLIGHTS.filter(({ figure }) => !spot || figure.name === SPOT)) {
  const { name } = flight.figure;
  const driven = torques(flight).some((torque) => torque !== 0);
  const lines = execFileSync(program, [String(SECONDS), ...STEPS_PER_SECOND.map(String)], { input: JSON.stringify(flight), encoding: 'utf8' })
    .trim().split('\n').map((line) => JSON.parse(line));
  const mjcf = /** @type {string} */ (lines[0]);
  const flown = /** @type {Flown[]} */ (lines.slice(1));
  for (const { eased, touched, broken } of flown) {
    if (eased || touched || broken) faults.push(`${name}: no fair flight (${JSON.stringify({ eased, touched, broken })})`);
  }
  const truth = fly(flight, mjcf, SECONDS, fine_s);
  const doubt = greatest(Object.values(errors(truth, fly(flight, mjcf, SECONDS, 2 * fine_s))));
  if (!(doubt <= MUJOCO_ERROR)) faults.push(`${name}: MuJoCo's own error is about ${doubt}`);
  const plain = flown.map((one) => errors(one, truth));
  check(name, plain, driven ? FIRST_ORDER : SECOND_ORDER);
  write(name, driven ? 'at once' : 'none', plain);
  if (!driven) continue;
  // Model 2 gives the impulse of a step at its beginning, so its torques begin half a step early. This is all that is of
  // first order.
  const early = flown.map((one, i) => errors(one, fly(flight, mjcf, SECONDS, fine_s, 0.5 / STEPS_PER_SECOND[i])));
  check(`${name}, from half a step early`, early, SECOND_ORDER);
  write(name, 'half a step early', early);
}

if (options.includes('--out')) writeFileSync(options[options.indexOf('--out') + 1], `${rows.join('\n')}\n`);
else console.log(rows.join('\n'));
for (const fault of faults) console.error(fault);
process.exitCode = faults.length ? 1 : 0;
