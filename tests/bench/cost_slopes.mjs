// SPDX-License-Identifier: MIT
// Least-squares slopes of cost_bench's results.

/** @typedef {{name: string, run_name: string, cpu_time: number, aggregate_name?: string}} Measured  by Google Benchmark */
/** @typedef {{what: string, value: number, relation: '<=' | '', goal: number, unit: string, note?: string}} Slope */

/** Of kGenomes motions of 5 s, which cost_bench measures together. */
const STEPS_OF_A_RUN = 64 * 500;

/** @param {[number, number][]} points @returns {{slope: number, start: number}} */
function line(points) {
  const n = points.length;
  const meanX = points.reduce((sum, [x]) => sum + x, 0) / n;
  const meanY = points.reduce((sum, [, y]) => sum + y, 0) / n;
  const covariance = points.reduce((sum, [x, y]) => sum + (x - meanX) * (y - meanY), 0);
  const slope = covariance / points.reduce((sum, [x]) => sum + (x - meanX) ** 2, 0);
  return { slope, start: meanY - slope * meanX };
}

/**
 * @param {Measured[]} measured
 * @returns {Slope[]} empty if cost_bench has not run
 */
export function costs(measured) {
  /** @param {string} family @returns {[number, number][]} parameter and time */
  const points = (family) => /** @type {[number, number][]} */ (measured
    .filter(({ run_name: name, aggregate_name: kind }) => name.startsWith(`${family}/`) && kind === 'median')
    .map(({ run_name: name, cpu_time: time }) => [Number(/(\d+)$/.exec(name)?.[1]), time]))
    .sort(([one], [other]) => one - other);

  /** @type {Slope[]} */
  const slopes = [];
  for (const [family, what] of [['Star', 'star'], ['Chain', 'chain']]) {
    const found = points(`${family}/strong`);
    if (!found.length) continue;
    const { slope } = line(found.map(([x, y]) => [Math.log(x), Math.log(y)]));
    slopes.push({ what: `cost against rods 4 → 16, ${what}: n to the power`, value: slope, relation: '<=', goal: 1.15, unit: '' });
  }
  for (const [family, what] of [['Star', 'star'], ['Chain', 'chain']]) {
    const found = points(`${family}/limited`);
    if (!found.length) continue;
    const { slope } = line(found.map(([x, y]) => [Math.log(x), Math.log(y)]));
    slopes.push({
      what: `joints of limited strength, rods 2 → 16, ${what}: n to the power`, value: slope, relation: '', goal: 0, unit: '',
      note: found.map(([rods, time]) => `${rods}: ${Math.round(time / STEPS_OF_A_RUN)} ns`).join(', '),
    });
  }
  for (const [family, what] of [
    ['Rules/physical', 'a rule of physical senses'], ['Rules/timer', 'a rule of a timer'], ['CaredSenses', 'caring about 1 % more senses'],
  ]) {
    const found = points(family);
    if (!found.length) continue;
    const { slope, start } = line(found);
    const off = Math.max(...found.map(([x, y]) => Math.abs(y / (start + slope * x) - 1)));
    slopes.push({
      what: `${what} adds to the cost without`, value: (100 * slope) / start, relation: '', goal: 0, unit: ' %',
      note: `straight within ${(100 * off).toFixed(0)} %`,
    });
  }
  return slopes;
}
