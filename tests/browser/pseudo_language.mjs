// SPDX-License-Identifier: MIT
// A test language with every translated text between « and ». Text outside of them was not translated.
import { readFile, readdir } from 'node:fs/promises';
import { join } from 'node:path';
import { ROOT } from './browsers.mjs';

/** @typedef {import('./page_driver.mjs').PageDriver} PageDriver */

// Names are the same in every language. Names of documents and figures are read from examples/.
const NAMES = ['Gaitsmith', 'English', 'Deutsch', 'Español', 'RG&T', 'SPHC', 'GGA', 'SSGA', 'SHC', 'MPGA', 'Nelder–Mead', 'Powell', 'CMA-ES', 'MAP-Elites'];
const UNITS = ['N s', 'rad/s²', 'rad/s', 'rad', 'm/s', 'kg', 'ms', 'min', 'MB', 'm', 's', 'h', 'N'];
// Single letters are keys, letters of poses, or quantities. F1 is a key.
const SIGNS = /(?<![\p{L}\d])(\p{L}|F\d+)(?![\p{L}\d])/gu;

/** Elements with data that is not translated. @type {string[]} */
export const DATA = ['#title'];

/** Runs in the page before its scripts: replaces German by the test language, and records short messages. */
export function speakPseudo() {
  const originalFetch = window.fetch;
  const marked = (/** @type {string} */ words) => words.split(/(\{\d\})/).map((part) => (/^(\{\d\})?$/.test(part) ? part : `«${part}»`)).join('');
  window.fetch = async (...request) => {
    const response = await originalFetch(...request);
    if (response.url.endsWith('/hints/de.json')) {
      const hints = Object.entries(await response.json());
      return new Response(JSON.stringify(Object.fromEntries(hints.map(([id, words]) => [id, marked(words)]))));
    }
    if (!response.url.endsWith('/languages/de.json')) return response;
    const table = await response.json();
    for (const words of [table.words, table.errors, table.titles]) {
      for (const english of Object.keys(words)) words[english] = marked(english);
    }
    return new Response(JSON.stringify(table));
  };
  const messages = /** @type {[string, string][]} */ ([]);
  Object.assign(window, { testPassing: messages });
  addEventListener('DOMContentLoaded', () => {
    for (const id of ['#spoken', '#status', '#toast', '#banner-text', '#count', '#rate', '#best', '#left']) {
      const node = document.querySelector(id);
      if (node) new MutationObserver(() => { if (node.textContent) messages.push([id, node.textContent]); }).observe(node, { childList: true, subtree: true });
    }
  });
}

/** All visible texts, labels and recorded messages, with the matching entry of DATA. @param {PageDriver} page @returns {Promise<[string, string][]>} */
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

/** Titles and figures of the examples, which are not translated. @returns {Promise<string[]>} */
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

/** A function that removes the translated and the untranslatable parts of a text. @returns {Promise<(text: string) => string>} */
export async function untranslated() {
  const escape = (/** @type {string} */ text) => text.replace(/[.*+?^${}()|[\]\\]/g, '\\$&');
  const longestFirst = [...NAMES, ...await shippedNames(), ...UNITS].sort((a, b) => b.length - a.length).map(escape);
  const known = new RegExp(`(?<!\\p{L})(${longestFirst.join('|')})(?!\\p{L})`, 'gu');
  return (text) => {
    const left = text.replace(/«[^»]*»/g, ' ').replace(known, ' ').replace(SIGNS, ' ');
    return /\p{L}/u.test(left) ? left.trim() : '';
  };
}
