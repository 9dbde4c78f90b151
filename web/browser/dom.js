// SPDX-License-Identifier: MIT
// Small helpers over the DOM, typed.
import { announce } from './announcer.js';

/**
 * The element with this id. Throws if its class is another one.
 * @template {HTMLElement} T
 * @param {string} id
 * @param {new () => T} [kind]
 * @returns {T}
 */
export function element(id, kind = /** @type {any} */ (HTMLElement)) {
  const found = document.getElementById(id);
  if (!(found instanceof kind)) throw new Error(`the page has no ${kind.name} #${id}`);
  return found;
}

/** @param {string} id @param {(event: MouseEvent) => void} action */
export function onClick(id, action) {
  element(id).addEventListener('click', action);
}

/** Sets text only if it differs, because live regions announce every write. @param {HTMLElement} node @param {string} text */
export function setText(node, text) {
  if (node.textContent !== text) node.textContent = text;
}

/** Downloads a file. @param {string} name @param {BlobPart} contents @param {string} type */
export function offerFile(name, contents, type) {
  const anchor = document.createElement('a');
  anchor.href = URL.createObjectURL(new Blob([contents], { type }));
  anchor.download = name;
  anchor.click();
  setTimeout(() => URL.revokeObjectURL(anchor.href), 10000);
}

/** @type {ReturnType<typeof setTimeout> | undefined} */
let toastTimer;

/** Shows a short confirmation that disappears by itself. @param {string} sentence */
export function toast(sentence) {
  const node = element('toast');
  setText(node, sentence);
  announce(sentence);
  node.classList.add('shown');
  clearTimeout(toastTimer);
  toastTimer = setTimeout(() => {
    node.classList.remove('shown');
    node.textContent = '';
  }, 2500);
}

/**
 * Shows an important error in its own row. It stays until it is closed or replaced.
 * @param {string} sentence  empty: no banner
 * @param {{reload?: boolean}} [options]
 */
export function banner(sentence, { reload = false } = {}) {
  element('banner-text').textContent = sentence;
  element('banner-reload').hidden = !reload;
  element('banner').hidden = sentence === '';
}
