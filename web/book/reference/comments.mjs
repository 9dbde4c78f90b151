// SPDX-License-Identifier: MIT
// The comments of core's headers. They are written for readers of the header, and Doxygen recognizes only some of them.
// So Doxygen gets copies in which the comments after members have its syntax. Line numbers stay the same.

/** A paragraph of a header's first comment. drawn: preformatted. @typedef {{text: string, drawn: boolean}} Paragraph */

const BEHIND = /^(.*[^\s/])\s+\/\/ (?!NOLINT|namespace)(.*)$/;
const ALONE = /^(\s*)\/\/ (?!NOLINT|namespace)(.*)$/;
const TAKEN = /^ +using \w+::\w+;$/;
const DRAWN = /^\/\/\/? {2,}(\S.*)$/; // a formula, a row of a table

/** @param {string} text */
const marked = (text) => text.replace(/&/g, '&amp;').replace(/</g, '&lt;').replace(/>/g, '&gt;');

/** @param {string[]} lines */
const codeBegins = (lines) => lines.indexOf('#pragma once') + 1;

/**
 * A header as Doxygen gets it. Without its `using` declarations, because Doxygen would list them as new members.
 * @param {string} header @returns {string}
 */
export function forDoxygen(header) {
  const lines = header.split('\n');
  for (let i = codeBegins(lines); i < lines.length; i++) {
    const comment = lines[i].trimStart();
    const [, code, first] = BEHIND.exec(lines[i]) ?? [];
    if (TAKEN.test(lines[i])) {
      lines[i] = '';
    } else if (comment.startsWith('///')) {
      const [, drawn] = DRAWN.exec(comment) ?? [];
      lines[i] = drawn === undefined ? lines[i].replace(/@param (\w+), (\w+)/, '@param $1,$2') : `/// <pre>${marked(drawn)}</pre>`;
    } else if (code !== undefined) {
      // The comment may continue in the same column of the next lines.
      const column = lines[i].lastIndexOf(`// ${first}`);
      let words = first;
      let next = i + 1;
      for (; ALONE.exec(lines[next] ?? '')?.[1].length === column; next++) {
        words += ` ${lines[next].trim().slice(3)}`;
        lines[next] = '';
      }
      lines[i] = `${code} ///< @details ${words}`;
      i = next - 1;
    }
  }
  return lines.join('\n');
}

/** Comments above one or more members. @param {string} header @returns {Map<number, string>} by the first member's line, from 1 */
export function notes(header) {
  /** @type {Map<number, string>} */
  const found = new Map();
  const lines = forDoxygen(header).split('\n');
  let words = '';
  for (let i = codeBegins(lines); i < lines.length; i++) {
    const [, , alone] = ALONE.exec(lines[i]) ?? [];
    if (alone !== undefined) {
      words += (words && ' ') + alone;
    } else {
      if (words) found.set(i + 1, words);
      words = '';
    }
  }
  return found;
}

/** A header's first comment, after the licence. @param {string} header @returns {Paragraph[]} */
export function firstComment(header) {
  /** @type {Paragraph[]} */
  const paragraphs = [];
  let fresh = true;
  for (const line of header.split('\n').slice(1)) {
    if (!line.startsWith('//')) break;
    const drawn = DRAWN.test(line);
    const last = paragraphs[paragraphs.length - 1];
    const text = drawn ? line.slice(5) : line.slice(2).trim();
    if (text !== '' && !fresh && last?.drawn === drawn) last.text += (drawn ? '\n' : ' ') + text;
    else if (text !== '') paragraphs.push({ text, drawn });
    fresh = text === '';
  }
  return paragraphs;
}
