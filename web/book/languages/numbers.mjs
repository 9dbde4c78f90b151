// SPDX-License-Identifier: MIT
// The numbers in a text of a page, to compare languages.

/** @typedef {import('../pages.mjs').Page} Page */

/** The numbers of a text in any order, written the English way. @param {string} text @param {Page} page */
export function numbersIn(text, { language: { decimalMark, groupMark } }) {
  const escaped = (/** @type {string} */ mark) => mark.replace(/[.*+?^$]/g, '\\$&');
  const number = new RegExp(`\\d+(?:${escaped(groupMark)}\\d{3}(?!\\d))*(?:${escaped(decimalMark)}\\d+)?`, 'g');
  return (text.match(number) ?? []).map((each) => each.replaceAll(groupMark, '').replace(decimalMark, '.')).sort().join(', ');
}
