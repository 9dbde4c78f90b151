// SPDX-License-Identifier: MIT
// The words that the scripts of the book's pages need, as a script that runs before them: then nothing is shown in
// English first, and nothing has to be fetched.
import { readdir, readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { bookTexts } from '../../languages/texts.mjs';

/** @typedef {import('./words.mjs').Language} Language */

/** Scripts of the book's pages. */
const SCRIPTS = /^(book(\/teaching)?|classroom|explorable)\/[\w-]+\.js$|^share\/(copying|scorm_maker|work)\.js$|^page\/goal_conditions\.js$/;

/** Its address in the book. @param {Language} language */
export const liveWordsOf = ({ code }) => `words/${code}.js`;

/** The texts that the scripts of the book's pages show. @param {string} web  the folder @returns {Promise<Set<string>>} */
export async function liveTexts(web) {
  const names = (await readdir(web, { recursive: true })).map((name) => name.replaceAll('\\', '/')).filter((name) => SCRIPTS.test(name));
  const sources = await Promise.all(names.map((name) => readFile(join(web, name), 'utf8')));
  return new Set(sources.flatMap((source) => bookTexts(source)));
}

/** @param {Language} language @param {Set<string>} texts  of liveTexts() @returns {string} a script's text */
export function liveWords({ code, canvas, words }, texts) {
  const all = { ...canvas.words, ...words };
  const table = {
    decimal_mark: canvas.decimal_mark, group_mark: canvas.group_mark, errors: canvas.errors, titles: {},
    words: Object.fromEntries([...texts].filter((text) => all[text]).map((text) => [text, all[text]])),
  };
  return `import { setLanguage } from '../../languages/language.js';\nsetLanguage(${JSON.stringify(code)}, ${JSON.stringify(JSON.stringify(table))});\n`;
}
