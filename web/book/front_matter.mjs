// SPDX-License-Identifier: MIT
// Front matter: the lines `key: value` between two lines of three hyphens at the start of a lesson.

/** @typedef {import('./faults.mjs').Faults} Faults */
/** @typedef {{value: string, line: number}} Field */

const EDGE = '---';

/**
 * @param {string} text  of the whole file
 * @param {string} file  its name, for faults
 * @param {readonly string[]} known  keys
 * @param {Faults} faults
 * @returns {{fields: Map<string, Field>, body: string, before: number}} `before`: lines before the body
 */
export function frontMatter(text, file, known, faults) {
  /** @type {Map<string, Field>} */
  const fields = new Map();
  const lines = text.split('\n');
  if (lines[0] !== EDGE) return { fields, body: text, before: 0 };
  const end = lines.indexOf(EDGE, 1);
  if (end < 0) {
    faults.add(file, 1, 'the lines after the first --- have no second ---');
    return { fields, body: '', before: 0 };
  }
  for (let i = 1; i < end; i++) {
    const [, key = '', value = ''] = /^(\w+):\s*(.*?)\s*$/.exec(lines[i]) ?? [];
    if (lines[i].trim() === '') continue;
    if (!known.includes(key)) faults.add(file, i + 1, `between the --- lines stand ${known.join(', ')}, each with a colon, not "${lines[i]}"`);
    else if (fields.has(key)) faults.add(file, i + 1, `"${key}" stands here twice`);
    else fields.set(key, { value: value.replace(/^"(.*)"$/, '$1'), line: i + 1 });
  }
  return { fields, body: lines.slice(end + 1).join('\n'), before: end + 1 };
}
