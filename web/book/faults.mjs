// SPDX-License-Identifier: MIT
// The errors in the book's sources, collected so that one build reports all of them.

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
