// SPDX-License-Identifier: MIT
/** A quantile, between the two nearest numbers. @param {number[]} numbers @param {number} share */
export function quantile(numbers, share) {
  const sorted = [...numbers].sort((a, b) => a - b), at = share * (sorted.length - 1);
  const low = sorted[Math.floor(at)] ?? NaN, high = sorted[Math.ceil(at)] ?? NaN;
  return low + (high - low) * (at - Math.floor(at));
}
/** @param {number[]} numbers */
export const median = (numbers) => quantile(numbers, 0.5);
/** "5.31 (4.80–6.02)": median and quartiles. @param {number[]} numbers @param {number} [digits] */
export const spread = (numbers, digits = 2) => `${median(numbers).toFixed(digits)} (${quantile(numbers, 0.25).toFixed(digits)}–${quantile(numbers, 0.75).toFixed(digits)})`;
