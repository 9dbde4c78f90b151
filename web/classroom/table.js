// SPDX-License-Identifier: MIT
// The rows of a wall as a table for spreadsheets, and their order.

/** @typedef {import('./judge.js').Row} Row */
/** @typedef {'arrival' | 'name' | 'lesson' | 'goal'} Order */

/** @param {Row[]} rows @param {Order} order @returns {Row[]} */
export function sorted(rows, order) {
  const place = new Map(rows.map((row, i) => [row, i]));
  const byPlace = (/** @type {Row} */ a, /** @type {Row} */ b) => (place.get(a) ?? 0) - (place.get(b) ?? 0);
  const rank = (/** @type {Row} */ { met, fault }) => (met === true ? 0 : met === false ? 1 : fault === '' ? 2 : 3);
  /** @type {Record<Order, (a: Row, b: Row) => number>} */
  const compare = {
    arrival: () => 0,
    name: (a, b) => a.name.localeCompare(b.name),
    lesson: (a, b) => a.lesson.localeCompare(b.lesson, undefined, { numeric: true }),
    goal: (a, b) => rank(a) - rank(b),
  };
  return [...rows].sort((a, b) => compare[order](a, b) || byPlace(a, b));
}

/** The rows that show the same motion as an earlier one, by row: the number of the earlier one, from 1. @param {Row[]} rows @returns {Map<Row, number>} */
export function copies(rows) {
  /** @type {Map<string, number>} */
  const first = new Map();
  /** @type {Map<Row, number>} */
  const found = new Map();
  rows.forEach((row, i) => {
    if (row.hash === '') return;
    const earlier = first.get(row.hash);
    if (earlier === undefined) first.set(row.hash, i + 1);
    else found.set(row, earlier);
  });
  return found;
}

/** @param {Row[]} rows @param {string} site  address of the playground, for links @returns {string} comma-separated values with a header */
export function csvOf(rows, site) {
  const most = (/** @type {'predictions' | 'answers'} */ key) => Math.max(0, ...rows.map((row) => row[key].length));
  const [predictions, answers] = [most('predictions'), most('answers')];
  const same = copies(rows);
  const head = ['number', 'name', 'lesson', 'goal_met', 'measured', 'changed', 'same_as', 'fault', 'text',
    ...numbered('prediction', predictions), ...numbered('answer', answers), ...numbered('right', answers), 'link'];
  const lines = rows.map((row, i) => [
    i + 1, row.name, row.lesson, row.met === null ? '' : row.met ? 'yes' : 'no', row.conditions.map(({ text }) => text).join('; '), row.changed.join('; '),
    same.get(row) ?? '', row.fault, row.text,
    ...padded(row.predictions.map(({ given }) => given), predictions), ...padded(row.answers.map(({ given }) => given), answers),
    ...padded(row.answers.map(({ right }) => (right === null ? '' : right ? 'yes' : 'no')), answers), row.link && `${site}#${row.link}`,
  ]);
  return csvOfCells([head, ...lines]);
}

/** Comma-separated values. @param {(string | number)[][]} rows  the first is the header */
export const csvOfCells = (rows) => rows.map((cells) => `${cells.map(cell).join(',')}\r\n`).join('');

/** A text that begins like a formula would be run by a spreadsheet. @param {string | number} value */
function cell(value) {
  const text = typeof value === 'number' ? String(value) : value.replace(/^(?=[=+\-@\t\r])/, '\'');
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

/** @param {string} name @param {number} count */
const numbered = (name, count) => Array.from({ length: count }, (_, i) => `${name}_${i + 1}`);
/** @param {string[]} values @param {number} count */
const padded = (values, count) => Array.from({ length: count }, (_, i) => values[i] ?? '');
