// SPDX-License-Identifier: MIT
// Tables in Markdown, on standard output.
/** @param {string[]} cells */
export const line = (cells) => console.log(`| ${cells.join(' | ')} |`);
/** The head of a new table. @param {string[]} cells */
export function table(cells) {
  console.log();
  line(cells);
  console.log(`|${'---|'.repeat(cells.length)}`);
}
/** A chance of error. @param {number} p */
export const chance = (p) => (p < 0.001 ? '< 0.001' : p.toFixed(3));
