// SPDX-License-Identifier: MIT
// A language of the book, and English. Also runs in the page that previews a lesson, so it reads no files.

/** Translates a text. {1}, {2}...: places of the inserts @typedef {(english: string, ...inserts: (string | number)[]) => string} Translate */
/**
 * @typedef {object} Language
 * @property {string} code
 * @property {string} name        in that language
 * @property {string} folder      of its pages in the book: '' or 'de/'
 * @property {string} decimalMark
 * @property {string} groupMark
 * @property {Record<string, string>} words  the book's table
 * @property {any} canvas         the playground's table; null: English
 * @property {Translate} tr
 */

/** @param {Record<string, string>} words @returns {Translate} */
export const translator = (words) => (english, ...inserts) => (words[english] ?? english).replace(/\{([1-9])\}/g, (place, which) => String(inserts[which - 1] ?? place));

/** @type {Language} */
export const ENGLISH = { code: 'en', name: 'English', folder: '', decimalMark: '.', groupMark: ',', words: {}, canvas: null, tr: translator({}) };
