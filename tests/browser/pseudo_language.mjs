// SPDX-License-Identifier: MIT
// A language in which every translated word stands between « and »: what a page shows outside of them was forgotten.
import { readFile, readdir } from 'node:fs/promises';
import { join } from 'node:path';
import { ROOT } from './browsers.mjs';

/** @typedef {import('./page_driver.mjs').PageDriver} PageDriver */

// The same in every language. Documents and figures have their names, too; those are read from examples/.
const NAMES = ['Gaitsmith', 'English', 'Deutsch', 'RG&T', 'SPHC', 'GGA', 'SSGA', 'SHC', 'MPGA', 'Nelder–Mead', 'Powell', 'CMA-ES', 'MAP-Elites'];
const UNITS = ['N s', 'rad/s²', 'rad/s', 'rad', 'm/s', 'kg', 'ms', 'min', 'MB', 'm', 's', 'h', 'N'];
// A letter alone is a key, or the letter of a pose; F1 is a key, "x", "y" and Greek letters are quantities.
const SIGNS = /(?<![\p{L}\d])(\p{L}|F\d+)(?![\p{L}\d])/gu;

/** A document's title stays as it was made. @type {string[]} */
export const DATA = ['#title'];

/** Runs before the page's own scripts: what comes as German is that language; what is said in passing is kept. */
export function speakPseudo() {
  const fetchAsEver = window.fetch;
  window.fetch = async (...request) => {
    const response = await fetchAsEver(...request);
    if (!response.url.endsWith('/languages/de.json')) return response;
    const table = await response.json();
    for (const words of [table.words, table.errors, table.titles]) {
      for (const english of Object.keys(words)) {
        words[english] = english.split(/(\{\d\})/).map((part) => (/^(\{\d\})?$/.test(part) ? part : `«${part}»`)).join('');
      }
    }
    return new Response(JSON.stringify(table));
  };
  const said = /** @type {[string, string][]} */ ([]);
  Object.assign(window, { testPassing: said });
  addEventListener('DOMContentLoaded', () => {
    for (const id of ['#spoken', '#status', '#toast', '#banner-text', '#count', '#rate', '#best', '#left']) {
      const node = document.querySelector(id);
      if (node) new MutationObserver(() => { if (node.textContent) said.push([id, node.textContent]); }).observe(node, { childList: true, subtree: true });
    }
  });
}

/** Everything that can be read or heard on the page now, or was said in passing; and which of DATA it is in. @param {PageDriver} page @returns {Promise<[string, string][]>} */
export const wordsOn = (page) => page.page.evaluate(() => {
  const attributes = ['aria-label', 'aria-description', 'aria-valuetext', 'aria-roledescription', 'title', 'placeholder', 'alt'];
  /** @type {[string, string][]} */
  const words = [];
  for (const node of document.body.querySelectorAll('*')) {
    if (node.closest('script, noscript, svg, [translate=no], textarea')) continue;
    const where = [...document.querySelectorAll('[id]')].filter((one) => one.contains(node)).map(({ id }) => `#${id}`).join(' ');
    for (const child of node.childNodes) if (child instanceof Text) words.push([where, child.data]);
    for (const name of attributes) words.push([where, node.getAttribute(name) ?? '']);
    if (node instanceof HTMLInputElement && node.type === 'text') words.push([where, node.value]);
  }
  return [...words, ...(/** @type {any} */ (window).testPassing.splice(0))];
});

/** Titles and figures of the documents that the page comes with: data, not words. @returns {Promise<string[]>} */
async function shippedNames() {
  const names = new Set();
  for (const folder of ['examples', 'examples/figures', 'examples/problems']) {
    for (const file of (await readdir(join(ROOT, folder))).filter((one) => one.endsWith('.json'))) {
      const { title, name, figure } = JSON.parse(await readFile(join(ROOT, folder, file), 'utf8'));
      for (const one of [title, name, figure?.name]) if (one) names.add(one);
    }
  }
  return [...names];
}

/** What takes out of a text all that need not be translated. @returns {Promise<(text: string) => string>} */
export async function untranslated() {
  const escape = (/** @type {string} */ text) => text.replace(/[.*+?^${}()|[\]\\]/g, '\\$&');
  const longestFirst = [...NAMES, ...await shippedNames(), ...UNITS].sort((a, b) => b.length - a.length).map(escape);
  const known = new RegExp(`(?<!\\p{L})(${longestFirst.join('|')})(?!\\p{L})`, 'gu');
  return (text) => {
    const left = text.replace(/«[^»]*»/g, ' ').replace(known, ' ').replace(SIGNS, ' ');
    return /\p{L}/u.test(left) ? left.trim() : '';
  };
}
