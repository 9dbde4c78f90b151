// SPDX-License-Identifier: MIT
import { upperTail } from './rank_sum.mjs';

/**
 * Two-sided signed-rank test [Wilcoxon 1945] of paired differences, by the normal approximation, corrected for ties; zeros are left out.
 * @param {number[]} differences  at least eight that are not zero, for the approximation
 * @returns {number} p; 1 if all are zero
 */
export function signedRank(differences) {
  const given = differences.filter((difference) => difference !== 0);
  const sizes = given.map(Math.abs).sort((a, b) => a - b);
  const rank = (/** @type {number} */ size) => (sizes.indexOf(size) + sizes.lastIndexOf(size)) / 2 + 1;
  const n = given.length;
  const above = given.reduce((sum, difference) => sum + (difference > 0 ? rank(Math.abs(difference)) : 0), 0);
  const ties = [...new Set(sizes)].reduce((sum, size) => {
    const alike = sizes.filter((other) => other === size).length;
    return sum + alike ** 3 - alike;
  }, 0);
  const deviation = Math.sqrt((n * (n + 1) * (2 * n + 1)) / 24 - ties / 48);
  return deviation > 0 ? Math.min(1, 2 * upperTail(Math.max(0, Math.abs(above - (n * (n + 1)) / 4) - 0.5) / deviation)) : 1;
}
