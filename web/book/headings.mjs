// SPDX-License-Identifier: MIT
// Anchors of headings, with the same names as on GitHub and similar sites, and first sentences.

/** @typedef {{level: number, text: string, id: string}} Heading */

/** Gives each heading of a page a unique name. */
export class HeadingNames {
  /** @type {Map<string, number>} */
  #taken = new Map();

  /** @param {string} text @returns {string} */
  name(text) {
    const plain = text.toLowerCase().replace(/[^\p{L}\p{N}\s_-]/gu, '').trim().replace(/\s/g, '-') || 'section';
    const count = this.#taken.get(plain) ?? 0;
    this.#taken.set(plain, count + 1);
    return count === 0 ? plain : `${plain}-${count}`;
  }
}

/** The first sentence of a text, shortened if it is long. @param {string} text */
export function firstSentence(text) {
  const ends = [...text.matchAll(/[.!?](?=\s|$)/g)];
  const end = ends.find(({ index }) => !/(?:\b(?:Mr|Mrs|Dr|vs|cf|No|Fig)|\b[A-Za-z]\.[A-Za-z])$/.test(text.slice(0, index)));
  const sentence = end ? text.slice(0, end.index + 1) : text;
  if (sentence.length <= 240) return sentence.replace(/:$/, '.');
  return `${sentence.slice(0, sentence.lastIndexOf(' ', 236))} …`;
}
