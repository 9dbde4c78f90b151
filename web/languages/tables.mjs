// SPDX-License-Identifier: MIT
// What a language needs: the texts of the page, of its tooltips and of the book, and the pages of the book. For the tests
// and for missing.mjs.
import { readdir, readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { bookTexts, textsPassedTo } from './texts.mjs';

export const CANVAS = 'shell/words/languages', HINTS = 'shell/words/hints', BOOK = 'web/book/words';
/** Pages of docs/ that a whole language has, besides the lessons. */
export const PAGES = ['how-things-learn-to-move.md', 'teachers.md', 'lesson-answers.md'];
/** Scripts whose texts are in the book's tables. */
const OF_BOOK = /^(book\/.*\.m?js|(classroom|explorable)\/.*\.js|share\/work\.js)$/;

/** @param {string} root @param {string} folder @param {RegExp} names @returns {Promise<string[]>} the files' texts */
export async function filesIn(root, folder, names) {
  const files = (await readdir(join(root, folder), { recursive: true })).map((file) => file.replaceAll('\\', '/'));
  return Promise.all(files.filter((file) => names.test(file) && !file.includes('node_modules')).sort().map((file) => readFile(join(root, folder, file), 'utf8')));
}

/** The texts that the tables of the canvas and page must have. @param {string} root */
export async function canvasTexts(root) {
  const shell = (await filesIn(root, 'shell', /\.(h|cpp)$/)).flatMap((text) => textsPassedTo(text, ['Tr', 'TrLater', 'PageText'], '"'));
  const files = (await readdir(join(root, 'web'), { recursive: true })).map((file) => file.replaceAll('\\', '/'))
    .filter((file) => /^(?!package\/|node_modules\/).*\.js$/.test(file) && !OF_BOOK.test(file));
  const page = (await Promise.all(files.map((file) => readFile(join(root, 'web', file), 'utf8')))).flatMap((text) => textsPassedTo(text, ['tr', 'trLater'], '\'"`'));
  return { shell: new Set(shell), page: new Set(page) };
}

/** The texts that the book's tables, or else the canvas's, must have. @param {string} root */
export async function bookWords(root) {
  const sources = await filesIn(root, 'web', OF_BOOK);
  return new Set(sources.flatMap(bookTexts));
}

/** A table, or an empty one. @param {string} root @param {string} folder @param {string} code @returns {Promise<any>} */
export async function tableOf(root, folder, code) {
  try {
    return JSON.parse(await readFile(join(root, folder, `${code}.json`), 'utf8'));
  } catch (error) {
    if (/** @type {NodeJS.ErrnoException} */ (error).code === 'ENOENT') return {};
    throw new Error(`${folder}/${code}.json: ${/** @type {Error} */ (error).message}`);
  }
}

/** The names of the pages in docs/ and docs/<code>/ that a whole language has. @param {string} root */
export const pagesOf = async (root) => [...(await readdir(join(root, 'docs/lessons'))).filter((name) => name.endsWith('.md')).sort().map((name) => `lessons/${name}`), ...PAGES];
