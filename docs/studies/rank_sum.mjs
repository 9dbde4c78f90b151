// SPDX-License-Identifier: MIT
/**
 * Two-sided rank-sum test [Mann Whitney 1947] by the normal approximation, corrected for ties and continuity.
 * @param {number[]} a  both at least eight, for the approximation
 * @param {number[]} b
 * @returns {{p: number, superiority: number}} superiority: the chance that one of a is above one of b, ties counted half
 */
export function rankSum(a, b) {
  const n = a.length + b.length;
  const wins = a.reduce((sum, x) => sum + b.reduce((of, y) => of + (x > y ? 1 : x === y ? 0.5 : 0), 0), 0);
  const all = [...a, ...b];
  // Each of t equal values counts t^2 - 1, together t^3 - t.
  const ties = all.reduce((sum, x) => sum + all.filter((y) => y === x).length ** 2 - 1, 0);
  const deviation = Math.sqrt(a.length * b.length / 12 * (n + 1 - ties / (n * (n - 1))));
  const z = deviation === 0 ? 0 : Math.max(0, Math.abs(wins - a.length * b.length / 2) - 0.5) / deviation;
  return { p: 2 * upperTail(z), superiority: wins / (a.length * b.length) };
}

/**
 * The same test, exactly: among all ways to deal the values to the two sides, the share that is at least as far from even.
 * @param {number[]} a  few, because all ways are counted
 * @param {number[]} b
 * @returns {{p: number, superiority: number}}
 */
export function exactRankSum(a, b) {
  const all = [...a, ...b], ways = [0, 0];
  const pairs = a.length * b.length;
  /** @param {number[]} first @param {number[]} second */
  const winsOf = (first, second) => first.reduce((sum, x) => sum + second.reduce((of, y) => of + (x > y ? 1 : x === y ? 0.5 : 0), 0), 0);
  const wins = winsOf(a, b);
  /** @param {number} next @param {number[]} first @param {number[]} second */
  const deal = (next, first, second) => {
    if (first.length > a.length || second.length > b.length) return;
    if (next === all.length) {
      ways[Math.abs(winsOf(first, second) - pairs / 2) >= Math.abs(wins - pairs / 2) ? 0 : 1]++;
      return;
    }
    deal(next + 1, [...first, all[next] ?? 0], second);
    deal(next + 1, first, [...second, all[next] ?? 0]);
  };
  deal(0, [], []);
  const [far = 0, near = 0] = ways;
  return { p: far / (far + near), superiority: wins / pairs };
}

/** P(Z > z) of a standard normal Z, z >= 0, by Simpson's rule. @param {number} z */
export function upperTail(z) {
  const steps = 2000, end = 12, width = (end - Math.min(z, end)) / steps;
  let sum = 0;
  for (let i = 0; i <= steps; i++) {
    const x = z + i * width;
    sum += (i === 0 || i === steps ? 1 : i % 2 ? 4 : 2) * Math.exp(-x * x / 2);
  }
  return sum * width / 3 / Math.sqrt(2 * Math.PI);
}
