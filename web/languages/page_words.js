// SPDX-License-Identifier: MIT
// Translates the texts of HTML files, and sets up the list of languages in the header. Scripts that change a text
// translate it themselves.
import { element } from '../browser/dom.js';
import { bookPage, followLanguage, language, tr } from './language.js';
import { LANGUAGES, chooseLanguage } from './language_choice.js';

const ATTRIBUTES = ['aria-label', 'title', 'placeholder'];
const FOREIGN = '[translate=no], noscript, svg';

/** Call before any script changes a text. */
export function startPageWords() {
  const list = element('language', HTMLSelectElement);
  followWords(document.body);
  for (const [code, name] of Object.entries(LANGUAGES)) {
    const option = new Option(name, code);
    option.lang = code;
    list.append(option);
  }
  list.addEventListener('change', () => void chooseLanguage(list.value));
  const learn = element('learn', HTMLAnchorElement);
  followLanguage(() => {
    list.value = language();
    learn.href = bookPage('index.html');
  });
}

/** Keeps the English texts of a part of the page translated. @param {HTMLElement} root */
export function followWords(root) {
  const words = wordsOf(root);
  followLanguage(() => { for (const write of words) write(); });
}

/** Functions that translate one text each. @param {HTMLElement} root @returns {(() => void)[]} */
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
  for (const node of [root, ...root.querySelectorAll(ATTRIBUTES.map((name) => `[${name}]`).join())]) {
    for (const name of ATTRIBUTES) {
      const english = node.getAttribute(name);
      if (english) words.push(() => node.setAttribute(name, tr(english)));
    }
  }
  return words;
}
