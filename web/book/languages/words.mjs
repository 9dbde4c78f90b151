// SPDX-License-Identifier: MIT
// The languages of the book. web/book/words/<code>.json has the book's own words by their English texts, as
// shell/words/languages/<code>.json has those of the playground. The book uses both tables, so no text is in both.
import { readdir, readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { ENGLISH, translator } from './english.mjs';

/** @typedef {import('./english.mjs').Language} Language */
/** @typedef {import('./english.mjs').Translate} Translate */

export const BOOK_WORDS = 'web/book/words';
export const CANVAS_WORDS = 'shell/words/languages';

export { ENGLISH };

/** @param {string} root  of the repository @returns {Promise<Language[]>} English first */
export async function readLanguages(root) {
  const files = await readdir(join(root, BOOK_WORDS)).catch(() => /** @type {string[]} */ ([]));
  const table = async (/** @type {string} */ folder, /** @type {string} */ file) => JSON.parse(await readFile(join(root, folder, file), 'utf8'));
  const others = await Promise.all(files.filter((file) => file.endsWith('.json')).sort().map(async (file) => {
    const [words, canvas] = await Promise.all([table(BOOK_WORDS, file), table(CANVAS_WORDS, file)]);
    const code = file.replace(/\.json$/, '');
    return {
      code, name: canvas.name, folder: `${code}/`, decimalMark: canvas.decimal_mark, groupMark: canvas.group_mark, words, canvas,
      tr: translator({ ...canvas.words, ...words }),
    };
  }));
  return [ENGLISH, ...others];
}
