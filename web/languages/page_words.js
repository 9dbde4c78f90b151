// SPDX-License-Identifier: MIT
// The words that index.html itself has, in the language spoken, and the list in the header where one is chosen. What
// changes while the page is used is written by whoever changes it.
import { element } from '../browser/dom.js';
import { LANGUAGES, chooseLanguage, followLanguage, language, tr } from './language.js';

const ATTRIBUTES = ['aria-label', 'title', 'placeholder'];
const FOREIGN = '[translate=no], noscript, svg';

/** Before anything else writes on the page. */
export function startPageWords() {
  const list = element('language', HTMLSelectElement);
  const words = wordsOf(document.body);
  for (const [code, name] of Object.entries(LANGUAGES)) {
    const option = new Option(name, code);
    option.lang = code;
    list.append(option);
  }
  list.addEventListener('change', () => void chooseLanguage(list.value));
  followLanguage(() => {
    for (const write of words) write();
    list.value = language();
  });
}

/** What writes each of them anew. @param {HTMLElement} root @returns {(() => void)[]} */
function wordsOf(root) {
  /** @type {(() => void)[]} */
  const words = [];
  const texts = document.createTreeWalker(root, NodeFilter.SHOW_TEXT);
  while (texts.nextNode()) {
    const node = /** @type {Text} */ (texts.currentNode);
    const [, before, english, after] = /^(\s*)(.*?)(\s*)$/s.exec(node.data) ?? [];
    if (!/\p{L}/u.test(english) || node.parentElement?.closest(FOREIGN)) continue;
    words.push(() => { node.data = before + tr(english) + after; });
  }
  for (const node of root.querySelectorAll(ATTRIBUTES.map((name) => `[${name}]`).join())) {
    for (const name of ATTRIBUTES) {
      const english = node.getAttribute(name);
      if (english) words.push(() => node.setAttribute(name, tr(english)));
    }
  }
  return words;
}
