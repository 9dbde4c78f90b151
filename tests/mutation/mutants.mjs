// SPDX-License-Identifier: MIT
// Mutation testing of core: finds possible mutants, and orders them pseudo-randomly.
import { createHash } from 'node:crypto';

/** @typedef {{file: string, line: number, column: number, kind: string, before: string, after: string}} Mutant  before: the original text */

/** Mutation operators: the pattern of the original text, and its replacement. @type {[kind: string, pattern: RegExp, (found: string) => string][]} */
const KINDS = [
  ['relation', /(?<= )(?:<=|>=|<|>|==|!=)(?= )/g, (found) => /** @type {Record<string, string>} */ ({ '<': '<=', '<=': '<', '>': '>=', '>=': '>', '==': '!=', '!=': '==' })[found]],
  ['sum', /(?<= )[+-](?= )/g, (found) => (found === '+' ? '-' : '+')],
  ['product', /(?<= )[*/](?= )/g, (found) => (found === '*' ? '/' : '*')],
  ['accumulation', /(?<= )[+-]=(?= )/g, (found) => (found === '+=' ? '-=' : '+=')],
  ['logic', /(?<= )(?:&&|\|\|)(?= )/g, (found) => (found === '&&' ? '||' : '&&')],
  ['choice', /\b(?:true|false)\b/g, (found) => (found === 'true' ? 'false' : 'true')],
  ['number', /(?<![\w.])\d+(?:\.\d+)?(?=f?\b)(?![\w.]*[xX'])/g, (found) => (found.includes('.') ? String(Number(found) * 1.5 || 0.5).replace(/^(\d+)$/, '$1.0') : String(Number(found) + 1))],
  ['extreme', /\b(?:std::min|std::max|L::Min|L::Max)(?=[(<])/g, (found) => (/min/i.test(found) ? found.replace('min', 'max').replace('Min', 'Max') : found.replace('max', 'min').replace('Max', 'Min'))],
  ['negation', /(?<=\bif \()(?!const|auto|int|std::)[^;{}]+(?=\) (?:return|continue|break|\{)[^(]*$)/g, (found) => `!(${found})`],
  ['left out', /^ {2,}(?!return\b|const\b|auto\b|using\b|static|break|continue|if\b|for\b|case\b|default|else\b|while\b|switch|\[\[)[\w:.>\-[\]()+]+ ?(?:[-+*|&]?= .+|\(.*\));$/g, (found) => `${/^ */.exec(found)?.[0]};`],
];

/** Lines without mutants that affect motions: error texts, compile-time checks, includes. */
const NOT_CODE = /^\s*(?:\/\/|\/\*|\*|#|static_assert|template|using|namespace|\[\[gnu|inline constexpr std::array<(?:const char|std::string_view))|Fail\(/;

/** @param {string} file @param {string} text @returns {Mutant[]} */
export function mutantsOf(file, text) {
  return text.split('\n').flatMap((whole, index) => {
    if (NOT_CODE.test(whole)) return [];
    const line = whole.replace(/\s*\/\/.*$/, '').replace(/"(?:[^"\\]|\\.)*"/g, (words) => '_'.repeat(words.length));
    return KINDS.flatMap(([kind, pattern, changed]) => [...line.matchAll(pattern)].map((match) => {
      const before = whole.slice(match.index, match.index + match[0].length);
      return { file, line: index + 1, column: match.index, kind, before, after: changed(before) };
    }));
  });
}

/** Applies a mutant. @param {string} text @param {Mutant} mutant */
export function withFault(text, { line, column, before, after }) {
  const lines = text.split('\n');
  const whole = lines[line - 1];
  if (whole.slice(column, column + before.length) !== before) throw new Error(`line ${line} is another one by now`);
  lines[line - 1] = whole.slice(0, column) + after + whole.slice(column + before.length);
  return lines.join('\n');
}

const DRAW = 1; // seed of the order

/**
 * The order in which mutants are tried, by a hash of each mutant's line, so that changes elsewhere do not affect it.
 * @param {Mutant[]} all @param {(file: string) => string} textOf
 * @returns {{name: string, mutant: Mutant}[]} name: eight hexadecimal digits
 */
export function drawn(all, textOf) {
  /** @type {Map<string, number>} */
  const seen = new Map(); // counts equal mutants of equal lines in a file
  return all.map((mutant) => {
    const place = `${DRAW} ${mutant.file} ${mutant.kind} ${mutant.column} ${textOf(mutant.file).split('\n')[mutant.line - 1]}`;
    const nth = (seen.get(place) ?? 0) + 1;
    seen.set(place, nth);
    return { name: createHash('sha256').update(`${place} ${nth}`).digest('hex').slice(0, 8), mutant };
  }).sort((a, b) => (a.name < b.name ? -1 : 1));
}
