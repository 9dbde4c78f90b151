// SPDX-License-Identifier: MIT
// Chooses the page's language and fetches its table.
import { remember, remembered } from '../browser/storage.js';
import { languages } from '../catalogue/catalogue.js';
import { language, primaryCode, setLanguage, tr } from './language.js';

/** Each language's name in that language. @type {Record<string, string>} */
export const LANGUAGES = Object.fromEntries(languages.map(({ code, name }) => [code, name]));

const KEY = 'gaitsmith-language';
/** @type {string} */
const ENGLISH = 'en';
// The page's start waits at most this long for its language.
const TIMEOUT_MS = 10000;

let wanted = ENGLISH;
let table = ''; // of the present language
/** @type {(sentence: string) => void} */
let report = () => {};

/**
 * Uses the language chosen earlier, else the one in the address, else the browser's.
 * @param {(sentence: string) => void} say  shows a message
 * @returns {Promise<void>} resolved when the language is loaded, or has failed to load
 */
export function startLanguage(say) {
  report = say;
  const requested = new URLSearchParams(location.search).get('lang');
  const code = [remembered(KEY), requested, ...navigator.languages].map((tag) => codeOf(tag ?? '')).find((one) => one !== '');
  return useLanguage(code ?? ENGLISH);
}

/** Without storage the choice lasts until the page is closed. @param {string} code  key of LANGUAGES @returns {Promise<void>} */
export async function chooseLanguage(code) {
  remember(KEY, code);
  await useLanguage(code);
  if (language() === code) report(tr('Language: {1}', LANGUAGES[code]));
}

/** @param {string} tag  such as "de-AT" @returns {string} empty: not in LANGUAGES */
function codeOf(tag) {
  const code = primaryCode(tag);
  return Object.hasOwn(LANGUAGES, code) ? code : '';
}

/** @param {string} code */
async function useLanguage(code) {
  wanted = code;
  const next = code === language() ? table : code === ENGLISH ? '' : await load(code);
  if (wanted !== code) return; // another one was chosen meanwhile
  if (next !== null && setLanguage(code, next)) {
    table = next;
    return;
  }
  wanted = language();
  report(tr('{1} could not be loaded. The page stays in {2}.', LANGUAGES[code], LANGUAGES[wanted]));
  setLanguage(wanted, table);
}

/** @param {string} code @returns {Promise<string | null>} null: it could not be loaded */
async function load(code) {
  try {
    const signal = AbortSignal.timeout(TIMEOUT_MS);
    const response = await fetch(new URL(`../languages/${code}.json`, import.meta.url), { signal });
    return response.ok ? await response.text() : null;
  } catch {
    return null;
  }
}
