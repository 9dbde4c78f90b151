// SPDX-License-Identifier: MIT
// The dialogs and the tour: their HTML and style, loaded when one is first used, or when the page rests after its first
// motion.
import { followWords } from '../languages/page_words.js';

/** @type {Promise<void> | null} */
let loaded = null;

/** Await this before using an element of dialogs.html. Rejected if loading fails. The next call tries again. */
export function dialogs() {
  loaded ??= loadPart(new URL('../dialogs/dialogs', import.meta.url).href, document.body);
  loaded.catch(() => { loaded = null; });
  return loaded;
}

/** Adds a part of the page with its style. @param {string} address  of its .html and .css, without these endings @param {Element} parent */
export async function loadPart(address, parent) {
  // The style comes first, so that nothing is ever shown without it.
  const [page] = await Promise.all([documentAt(`${address}.html`), styleAt(`${address}.css`)]);
  const parts = /** @type {HTMLElement[]} */ ([...page.body.children]);
  parent.append(...parts);
  for (const part of parts) followWords(part);
}

/** Not with fetch, because the page's policy forbids scripts to parse HTML from text. @param {string} address @returns {Promise<Document>} */
function documentAt(address) {
  return new Promise((resolve, reject) => {
    const request = new XMLHttpRequest();
    request.open('GET', address);
    request.responseType = 'document';
    request.onload = () => (request.status === 200 && request.response ? resolve(request.response) : reject(new Error('no dialogs')));
    request.onerror = () => reject(new Error('no dialogs'));
    request.send();
  });
}

/** @param {string} address @returns {Promise<void>} */
function styleAt(address) {
  return new Promise((resolve, reject) => {
    const link = Object.assign(document.createElement('link'), { rel: 'stylesheet', href: address });
    link.onload = () => resolve();
    link.onerror = () => {
      link.remove();
      reject(new Error('no style'));
    };
    document.head.append(link);
  });
}
