// SPDX-License-Identifier: MIT
const DRAWS = 10000;
let state = 1;
/** Uniform in [0, 1), the same numbers in each run [Park Miller 1988]. */
const uniform = () => (state = (state * 48271) % 2147483647) / 2147483647;
/**
 * 95 % bootstrap interval of a statistic [Efron 1979].
 * @template T @param {T[]} of  what is drawn, with replacement @param {(drawn: T[]) => number} statistic
 * @returns {[number, number]}
 */
export function interval(of, statistic) {
  const values = Array.from({ length: DRAWS }, () => statistic(of.map(() => /** @type {T} */ (of[Math.floor(uniform() * of.length)])))).sort((a, b) => a - b);
  return [values[Math.floor(0.025 * DRAWS)] ?? NaN, values[Math.floor(0.975 * DRAWS)] ?? NaN];
}
