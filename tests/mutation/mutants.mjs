// SPDX-License-Identifier: MIT
// Small faults that a programmer could have made in core: the places for them, and a fair draw among them.

/** @typedef {{file: string, line: number, column: number, kind: string, before: string, after: string}} Mutant  before: what stands there */

/** What a fault of each kind looks like: the text that it replaces, and by what. @type {[kind: string, pattern: RegExp, (found: string) => string][]} */
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

/** Lines whose faults are none of motion's, or no faults: words of errors, checks for the compiler, includes. */
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

/** The text with the fault in it. @param {string} text @param {Mutant} mutant */
export function withFault(text, { line, column, before, after }) {
  const lines = text.split('\n');
  const whole = lines[line - 1];
  if (whole.slice(column, column + before.length) !== before) throw new Error(`line ${line} is another one by now`);
  lines[line - 1] = whole.slice(0, column) + after + whole.slice(column + before.length);
  return lines.join('\n');
}

/** The order in which they are tried: shuffled, the same for the same seed. @template T @param {T[]} all @param {number} seed @returns {T[]} */
export function shuffled(all, seed) {
  const order = [...all];
  let state = seed >>> 0;
  const next = () => { // mulberry32
    state = (state + 0x6d2b79f5) >>> 0;
    let word = Math.imul(state ^ (state >>> 15), 1 | state);
    word = (word + Math.imul(word ^ (word >>> 7), 61 | word)) ^ word;
    return (word ^ (word >>> 14)) >>> 0;
  };
  for (let i = order.length - 1; i > 0; i--) {
    const other = next() % (i + 1);
    [order[i], order[other]] = [order[other], order[i]];
  }
  return order;
}
