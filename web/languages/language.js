// SPDX-License-Identifier: MIT
// What a person reads and hears, in the language they chose. English stands where it is used and is the key to every
// other language, whose table (languages/) is fetched when somebody wants it. The canvas has the same tables.
import { remember, remembered } from '../browser/storage.js';

/** Each under its own name: whoever looks for it knows no other. @type {Record<string, string>} */
export const LANGUAGES = { en: 'English', de: 'Deutsch' };

/** A table of shell/languages. @typedef {{decimal_mark: string, group_mark: string, words: Record<string, string>, errors: Record<string, string>}} Table */

const KEY = 'gaitsmith-language';
const ENGLISH = { code: 'en', text: '', decimalMark: '.', groupMark: ',', words: /** @type {Map<string, string>} */ (new Map()) };
// The page waits for its language at the start, but not for ever.
const PATIENCE_MS = 10000;
// As in shell/words/language.cpp: what sentences made elsewhere are about.
const INSERT = /"[^"]*"|(?<![\d_])-?\d(?:\d|[.,](?=\d)|e(?=[+-])|(?<=e)[+-](?=\d))*/g;

let spoken = ENGLISH;
let wanted = ENGLISH.code;
/** @type {((text: string) => void)[]} */
const followers = [];
/** @type {(sentence: string) => void} */
let tell = () => {};

/** In the language spoken now. @param {string} english  {1}, {2}...: places of the inserts @param {(string | number)[]} inserts */
export function tr(english, ...inserts) {
  const pattern = spoken.words.get(english) ?? english;
  return inserts.length === 0 ? pattern : pattern.replace(/\{([1-9])\}/g, (place, which) => String(inserts[which - 1] ?? place));
}

/** Marks a text that goes through tr later, for instance in a table. @param {string} english */
export const trLater = (english) => english;

/**
 * A sentence made elsewhere, perhaps with the place that it is about before it, whose numbers and "quoted" parts stand in
 * the table as {1}, {2}...; as it is where the table has none.
 * @param {string} english
 * @returns {string}
 */
export function trSentence(english) {
  /** @type {string[]} */
  const inserts = [];
  const pattern = english.replace(INSERT, (part) => (inserts.length < 9 ? `{${inserts.push(part)}}` : part));
  if (spoken.words.has(pattern)) return tr(pattern, ...inserts);
  const at = english.indexOf(': ');
  return at < 0 ? english : `${tr(english.slice(0, at))}: ${trSentence(english.slice(at + 2))}`;
}

// Intl's formats take 40 ms to make.

/** "40,000" @param {number} value */
export const grouped = (value) => String(Math.round(value)).replace(/\B(?=(\d{3})+$)/g, spoken.groupMark);
/** "0.80" @param {number} value @param {number} decimals */
export const fixed = (value, decimals) => value.toFixed(decimals).replace('.', spoken.decimalMark);
/** A number to be typed over, with as many digits as it needs. @param {number} value */
export const fixedText = (value) => String(Number(value.toPrecision(6))).replace('.', spoken.decimalMark);

/** What was typed; NaN where it is no number. @param {string} text */
export const numberOf = (text) => (text.trim() === '' ? NaN : Number(text.replace(spoken.decimalMark, '.')));

/** For dates: as the browser has it where that is the same language. */
export const locale = () => navigator.languages.find((tag) => codeOf(tag) === spoken.code) ?? spoken.code;
export const language = () => spoken.code;

/** Calls back now and at every change. @param {(text: string) => void} apply  text: the table; empty: English */
export function followLanguage(apply) {
  followers.push(apply);
  apply(spoken.text);
}

/**
 * Speaks as the person chose earlier, else as the address says, else as the browser does.
 * @param {(sentence: string) => void} say  tells the reader what went wrong
 * @returns {Promise<void>} when it is spoken, or cannot be
 */
export function startLanguage(say) {
  tell = say;
  const asked = new URLSearchParams(location.search).get('lang');
  const code = [remembered(KEY), asked, ...navigator.languages].map((tag) => codeOf(tag ?? '')).find((one) => one !== '');
  return speak(code ?? ENGLISH.code);
}

/** Where storage is forbidden it holds until the page is left. @param {string} code  of LANGUAGES @returns {Promise<void>} */
export async function chooseLanguage(code) {
  remember(KEY, code);
  await speak(code);
  if (spoken.code === code) tell(tr('Language: {1}', LANGUAGES[code]));
}

/** @param {string} tag  like "de-AT" @returns {string} empty: none of ours */
function codeOf(tag) {
  const code = tag.toLowerCase().split('-')[0];
  return Object.hasOwn(LANGUAGES, code) ? code : '';
}

/** @param {string} code */
async function speak(code) {
  wanted = code;
  const next = code === spoken.code ? spoken : code === ENGLISH.code ? ENGLISH : await load(code);
  if (wanted !== code) return; // another one was chosen meanwhile
  if (!next) {
    wanted = spoken.code;
    tell(tr('{1} could not be loaded; the page stays in {2}.', LANGUAGES[code], LANGUAGES[spoken.code]));
  }
  spoken = next ?? spoken;
  document.documentElement.lang = spoken.code;
  for (const apply of followers) apply(spoken.text);
}

/** @param {string} code @returns {Promise<typeof ENGLISH | null>} null: it did not come */
async function load(code) {
  try {
    const signal = AbortSignal.timeout(PATIENCE_MS);
    const response = await fetch(new URL(`${code}.json`, import.meta.url), { signal });
    if (!response.ok) return null;
    const text = await response.text();
    const { decimal_mark: decimalMark, group_mark: groupMark, words, errors } = /** @type {Table} */ (JSON.parse(text));
    return { code, text, decimalMark, groupMark, words: new Map([...Object.entries(errors), ...Object.entries(words)]) };
  } catch {
    return null;
  }
}
