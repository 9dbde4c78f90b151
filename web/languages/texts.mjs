// SPDX-License-Identifier: MIT
// Finds the texts in the sources that languages translate. For the tests, for the book's build and for missing.mjs.

const ESCAPES = /** @type {Record<string, string>} */ ({ n: '\n', t: '\t' });
/** @param {string} text  of a literal, without its quotes */
const unescaped = (text) => text.replace(/\\u([0-9a-fA-F]{4})|\\(.)/gs,
  (_, code, letter) => (code ? String.fromCharCode(parseInt(code, 16)) : ESCAPES[letter] ?? letter));

/** A comment, a literal, or one other character. @param {string} source @param {string} quotes */
function tokens(source, quotes) {
  const literals = [...quotes].map((quote) => `${quote}(?:\\\\.|[^${quote}\\\\])*${quote}`);
  const token = new RegExp(`//[^\\n]*|/\\*.*?\\*/|${literals.join('|')}|[A-Za-z_0-9]+|.`, 'gs');
  return (source.match(token) ?? []).filter((text) => !/^(\/\/|\/\*)/.test(text));
}

/**
 * All literals in the first arguments of these functions. Adjacent literals are joined.
 * @param {string} source @param {string[]} functions @param {string} quotes  characters that start a literal
 */
export function textsPassedTo(source, functions, quotes) {
  const found = [];
  const all = tokens(source, quotes);
  for (let i = 0; i + 1 < all.length; i++) {
    if (!functions.includes(all[i] ?? '') || all[i + 1] !== '(') continue;
    let text = null;
    for (let k = i + 2, depth = 1; depth > 0 && k < all.length; k++) {
      const token = all[k] ?? '';
      const literal = token.length > 1 && quotes.includes(token.charAt(0));
      if (literal) text = (text ?? '') + unescaped(token.slice(1, -1));
      if (literal || /^\s$/.test(token)) continue;
      if (text !== null) found.push(text);
      text = null;
      if ('([{'.includes(token)) depth++;
      if (')]}'.includes(token)) depth--;
      if (token === ',' && depth === 1) break;
    }
  }
  return found;
}

/**
 * The texts of the book's sources, where calls stand inside templates: tr('...') and trLater('...') with one literal.
 * @param {string} source
 */
export function bookTexts(source) {
  return [...source.matchAll(/(?<![\w$])tr(?:Later)?\(\s*'((?:\\.|[^'\\\n])*)'/g)].map(([, text]) => unescaped(text));
}
