// SPDX-License-Identifier: MIT
// Replays recorded senses with web/runtime/runtime.js, as replay.c does with the C header:
//
//   node tests/runtime/replay.mjs NAME...
import { existsSync, readFileSync } from 'node:fs';
import { begin, load, move, step } from '../../web/runtime/runtime.js';

const rows = (/** @type {string} */ path) => readFileSync(path, 'utf8').trimEnd().split('\n').slice(1).map((line) => Float32Array.from(line.split(','), Number));
/** Whether two lists of floats differ in any bit. @param {ArrayLike<number>} a @param {ArrayLike<number>} b */
const differ = (a, b) => a.length !== b.length || Array.from(a).some((value, i) => !Object.is(value, b[i]));

const names = process.argv.slice(2);
const all = { steps: 0, rules: 0, targets: 0, times: 0, angles: 0 };
for (const name of names) {
  const controller = load(readFileSync(`${name}.json`, 'utf8'));
  const motion = existsSync(`${name}.motion.csv`) ? rows(`${name}.motion.csv`) : undefined;
  const joints = controller.joints.length;
  const senses = controller.senses.length;
  const state = begin(controller);
  const bodies = controller.joints.map(() => ({ angle: 0, rate: 0 }));
  rows(`${name}.csv`).forEach((row, i) => {
    if (i > 0) bodies.forEach((body, joint) => move(controller, state, joint, body));
    if (i > 0) step(controller, state, row.subarray(3, 3 + senses));
    const part = (/** @type {number} */ n) => row.subarray(3 + senses + n * joints, 3 + senses + (n + 1) * joints);
    ++all.steps;
    all.rules += Number(state.rule + (controller.kind === 'network' ? 0 : 1) !== row[2]);
    all.targets += Number(differ(state.target, part(0)));
    all.times += Number(differ(state.tau.map((tau) => 1 / tau), part(1)) || differ(state.decay, part(2)));
    if (motion) all.angles += Number(differ(bodies.map(({ angle }) => angle), motion[i].subarray(8, 8 + joints)));
  });
}
console.log(`${names.length} controllers, ${all.steps} steps; rules differ in ${all.rules}, targets in ${all.targets}, time constants in ${all.times}, joint angles in ${all.angles}`);
process.exit(all.steps > 0 && all.rules + all.targets + all.times + all.angles === 0 ? 0 : 1);
