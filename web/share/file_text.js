// SPDX-License-Identifier: MIT
// The text of a file that a person chose or dropped.
import { grouped, tr } from '../languages/language.js';

const MAX_BYTES = 8e6;

/**
 * The text of a file. Rejects files that cannot be documents, because core's sentence about a picture would not help.
 * @param {File} file
 * @returns {Promise<{text: string, fault: string}>}
 */
export async function textOf(file) {
  const failure = (/** @type {string} */ fault) => ({ text: '', fault });
  if (file.size > MAX_BYTES) return failure(tr('it has {1} MB, which is too large for a Gaitsmith document', grouped(file.size / 1e6)));
  let text;
  try {
    text = new TextDecoder('utf-8', { fatal: true }).decode(await file.arrayBuffer());
  } catch {
    return failure(tr('it is not a Gaitsmith document (a file that Save made, or a text with a link)'));
  }
  return text.trim() === '' ? failure(tr('it is empty')) : { text, fault: '' };
}
