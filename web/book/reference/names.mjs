// SPDX-License-Identifier: MIT
// Links for the names in texts and signatures of the reference.
import { attributes, escaped } from '../html.mjs';
import { upFrom } from '../html.mjs';

/** @typedef {import('./symbols.mjs').Symbol} Symbol */

/** The namespace of core. */
export const HEADER_SPACE = 'gaitsmith';

const IN_WORDS = /((?:docs|core)\/[\w/]+\.(?:md|h)\b|\b\w+\.h\b|\b(?:[A-Z]\w*::)+\w+(?:\(\))?(?:\.\w+\(\))*|\bk[A-Z]\w*\b|\b[A-Z][a-z0-9]+(?:[A-Z][a-z0-9]*)+\b(?:\(\))?|\b[A-Z]\w*\(\))/;
const IN_CODE = /((?:[A-Za-z]\w*::)*[A-Za-z]\w*)/;

/** The page of a header. @param {string} header */
export const addressOf = (header) => `reference/${header.replace(/h$/, 'html')}`;

export class Names {
  /** Addresses in the book, by name or file. @type {Map<string, string>} */
  #known = new Map();
  /** @type {Map<string, string>} */
  #byDoxygen = new Map();

  /** @param {Map<string, Symbol[]>} symbols  by header @param {Iterable<string>} headers @param {{source: string, address: string}[]} pages */
  constructor(symbols, headers, pages) {
    for (const { source, address } of pages) this.#known.set(source, address);
    for (const header of headers) {
      this.#known.set(header, addressOf(header));
      this.#known.set(header.replace(/^.*\//, ''), addressOf(header));
    }
    for (const [header, declared] of symbols) {
      for (const one of declared.flatMap((symbol) => [symbol, ...symbol.members])) {
        const address = `${addressOf(header)}#${one.id}`;
        // A type wins over functions of the same name.
        if (one.kind !== 'constructor' && !this.#known.has(one.name)) this.#known.set(one.name, address);
        for (const { element } of [one, ...one.others]) this.#byDoxygen.set(element.attributes.id, address);
        for (const value of one.element.all('enumvalue')) this.#known.set(`${one.name}::${value.textOf('name')}`, address);
      }
    }
  }

  /** @param {string} name @param {string} scope  the enclosing type */
  #find(name, scope) {
    const plain = name.replace(/\(\).*$/, '');
    return this.#known.get(`${scope}::${plain}`) ?? this.#known.get(plain);
  }

  /** Functions that write text with links on a page. @param {string} page @param {string} scope */
  on(page, scope) {
    const way = (/** @type {string} */ address) => (address.startsWith(`${page}#`) ? address.slice(page.length) : upFrom(page) + address);
    const link = (/** @type {string | undefined} */ address, /** @type {string} */ html) => (address === undefined || address === page ? html : `<a${attributes({ href: way(address) })}>${html}</a>`);
    return {
      /** @param {string} text */
      words: (text) => text.split(IN_WORDS).map((piece, i) => {
        if (i % 2 === 0) return escaped(piece);
        const address = this.#find(piece, scope);
        return address || /::|^k[A-Z]|\(\)$|\//.test(piece) ? link(address, `<code>${escaped(piece)}</code>`) : escaped(piece);
      }).join(''),
      /** @param {string} text */
      code: (text) => text.split(IN_CODE).map((piece, i) => (i % 2 === 0 ? escaped(piece) : link(/^(k?[A-Z]|.*::)/.test(piece) ? this.#find(piece, scope) : undefined, escaped(piece)))).join(''),
      /** @param {string} id @param {string} text */
      reference: (id, text) => link(this.#byDoxygen.get(id) ?? this.#find(text, scope), escaped(text)),
    };
  }
}

/** @typedef {ReturnType<Names['on']>} Writer */
