// SPDX-License-Identifier: MIT
// Translates the page. The source code has the English texts, which are the keys of the other languages' tables
// (language_choice.js fetches them). The canvas has the same tables.
import { withdrawAnnouncements } from '../browser/announcer.js';

/** A table of shell/words/languages. @typedef {{decimal_mark: string, group_mark: string, words: Record<string, string>, errors: Record<string, string>, titles: Record<string, string>}} Table */

const ENGLISH = { code: 'en', text: '', decimalMark: '.', groupMark: ',', words: /** @type {Map<string, string>} */ (new Map()), titles: /** @type {Record<string, string>} */ ({}) };
// The numbers and "quoted" parts of a sentence, as in shell/words/language.cpp.
const INSERT = /"[^"]*"|(?<![\d_])-?\d(?:\d|[.,](?=\d)|e(?=[+-])|(?<=e)[+-](?=\d))*/g;

let current = ENGLISH;
/** @type {((text: string) => void)[]} */
const followers = [];

/** Translates a text. @param {string} english  {1}, {2}...: places of the inserts @param {(string | number)[]} inserts */
export function tr(english, ...inserts) {
  const pattern = current.words.get(english) ?? english;
  return inserts.length === 0 ? pattern : pattern.replace(/\{([1-9])\}/g, (place, which) => String(inserts[which - 1] ?? place));
}

/** Marks a text that tr translates later, for example in a table. @param {string} english */
export const trLater = (english) => english;

/** Translates the title of a shipped motion, or the name of a shipped figure. @param {string} english */
export const trTitle = (english) => current.titles[english] ?? english;

/**
 * Translates a complete sentence, for example from core, perhaps after a place such as "rod 2: ". In the table its
 * numbers and "quoted" parts are {1}, {2}... Returns the sentence unchanged if the table does not have it.
 * @param {string} english
 * @returns {string}
 */
export function trSentence(english) {
  /** @type {string[]} */
  const inserts = [];
  const pattern = english.replace(INSERT, (part) => (inserts.length < 9 ? `{${inserts.push(part)}}` : part));
  if (current.words.has(pattern)) return tr(pattern, ...inserts);
  const at = english.indexOf(': ');
  return at < 0 ? english : `${tr(english.slice(0, at))}: ${trSentence(english.slice(at + 2))}`;
}

// Without Intl, because creating its formats takes 40 ms.

/** "40,000" @param {number} value */
export const grouped = (value) => String(Math.round(value)).replace(/\B(?=(\d{3})+$)/g, current.groupMark);
/** "−0.80", and "0.00" for what rounds to it. @param {number} value @param {number} decimals */
export const fixed = (value, decimals) => (Number(value.toFixed(decimals)) + 0).toFixed(decimals)
  .replace('-', '−').replace('.', current.decimalMark);
/** A number for a text field, without superfluous digits. @param {number} value */
export const fixedText = (value) => String(Number(value.toPrecision(6))).replace('.', current.decimalMark);

/** The number that a person typed. NaN: not a number. @param {string} text */
export const numberOf = (text) => (text.trim() === '' ? NaN : Number(text.replace(current.decimalMark, '.')));

/** The book's page in the present language, from the site's root. @param {string} name  of a page that every language has */
export const bookPage = (name) => `book/${current.code === 'en' ? '' : `${current.code}/`}${name}`;

/** For dates: the browser's locale if it has the same language. */
export const locale = () => navigator.languages.find((tag) => primaryCode(tag) === current.code) ?? current.code;
export const language = () => current.code;
/** @param {string} tag  such as "de-AT" */
export const primaryCode = (tag) => tag.toLowerCase().split('-')[0] ?? '';

/** Calls `apply` now and at every change. @param {(text: string) => void} apply  text: the table; empty: English */
export function followLanguage(apply) {
  followers.push(apply);
  apply(current.text);
}

/**
 * Translates into a language from now on.
 * @param {string} code @param {string} text  the table, as JSON; empty: English
 * @returns {boolean} false: it is not a table, and nothing has changed
 */
export function setLanguage(code, text) {
  const next = text === '' ? ENGLISH : languageOf(code, text);
  if (!next) return false;
  current = next;
  withdrawAnnouncements();
  document.documentElement.lang = current.code;
  for (const apply of followers) apply(current.text);
  return true;
}

/** @param {string} code @param {string} text @returns {typeof ENGLISH | null} null: not a table */
function languageOf(code, text) {
  try {
    const { decimal_mark: decimalMark, group_mark: groupMark, words, errors, titles } = /** @type {Table} */ (JSON.parse(text));
    return { code, text, decimalMark, groupMark, words: new Map([...Object.entries(errors), ...Object.entries(words)]), titles };
  } catch {
    return null;
  }
}
