// SPDX-License-Identifier: MIT
// A short name for a text. Two different texts have different names, but for a chance of about 1 in 2^64.

/** @param {string} text @returns {string} small letters and digits */
export function stamp(text) {
  const sums = [0x811c9dc5, 0x2c1b3c6d]; // FNV-1a, twice
  for (let i = 0; i < text.length; i++) sums.forEach((sum, k) => { sums[k] = Math.imul(sum ^ text.charCodeAt(i), 0x01000193 + 2 * k) >>> 0; });
  return sums.map((sum) => sum.toString(36)).join('');
}
