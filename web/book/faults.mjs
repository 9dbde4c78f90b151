// SPDX-License-Identifier: MIT
// What is wrong with the book's sources: gathered, so that one build names everything.

export class Faults {
  /** @type {string[]} */
  sentences = [];

  /** @param {string} file  in the repository @param {number} line  from 1 @param {string} sentence */
  add(file, line, sentence) {
    this.sentences.push(`${file}:${line}: ${sentence}`);
  }

  /** Throws if there are any. */
  orThrow() {
    if (this.sentences.length > 0) throw new Error(this.sentences.join('\n'));
  }
}
