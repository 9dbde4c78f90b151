// SPDX-License-Identifier: MIT
// Headings as places to link to, under the names that Git forges give them.

/** @typedef {{level: number, text: string, id: string}} Heading */

/** Gives each heading of one page its own name. */
export class HeadingNames {
  /** @type {Map<string, number>} */
  #taken = new Map();

  /** @param {string} text @returns {string} */
  name(text) {
    const plain = text.toLowerCase().replace(/[^\p{L}\p{N}\s_-]/gu, '').trim().replace(/\s/g, '-') || 'section';
    const before = this.#taken.get(plain) ?? 0;
    this.#taken.set(plain, before + 1);
    return before === 0 ? plain : `${plain}-${before}`;
  }
}

/** The first sentence, for who has not read the rest. @param {string} text */
export function firstSentence(text) {
  const ends = [...text.matchAll(/[.!?](?=\s|$)/g)];
  const end = ends.find(({ index }) => !/(?:\b(?:Mr|Mrs|Dr|vs|cf|No|Fig)|\b[A-Za-z]\.[A-Za-z])$/.test(text.slice(0, index)));
  const sentence = end ? text.slice(0, end.index + 1) : text;
  if (sentence.length <= 240) return sentence.replace(/:$/, '.');
  return `${sentence.slice(0, sentence.lastIndexOf(' ', 236))} …`;
}
