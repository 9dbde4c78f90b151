// SPDX-License-Identifier: MIT
// Fetches the sentences of the canvas's tooltips, in the page's language. Loaded after the first motion, which does not
// need them.
import { followLanguage, language } from './language.js';

/** @typedef {import('../app/app.js').App} App */

/** @param {App} app */
export function startHints(app) { followLanguage(() => void load(app, language())); }

/** If the table cannot be loaded, the former one stays. @param {App} app @param {string} code */
async function load(app, code) {
  try {
    const response = await fetch(new URL(`../hints/${code}.json`, import.meta.url));
    const table = response.ok ? await response.text() : '';
    if (table && code === language()) app.setHints(table);
  } catch { /* no connection */ }
}
