// SPDX-License-Identifier: MIT
// Small helpers over the DOM, typed.
import { announce } from './announcer.js';

/**
 * The element of this id, of this class.
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

/** Sets text only when it differs: live regions speak on every change. @param {HTMLElement} node @param {string} text */
export function setText(node, text) {
  if (node.textContent !== text) node.textContent = text;
}

/** Gives the reader a file. @param {string} name @param {BlobPart} contents @param {string} type  of them */
export function offerFile(name, contents, type) {
  const anchor = document.createElement('a');
  anchor.href = URL.createObjectURL(new Blob([contents], { type }));
  anchor.download = name;
  anchor.click();
  setTimeout(() => URL.revokeObjectURL(anchor.href), 10000);
}

/** @type {ReturnType<typeof setTimeout> | undefined} */
let toastTimer;

/** A short confirmation that goes by itself. @param {string} sentence */
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
 * An error that the reader must know of, in a row of its own. It stays until closed or replaced.
 * @param {string} sentence  empty: no banner
 * @param {{reload?: boolean}} [options]
 */
export function banner(sentence, { reload = false } = {}) {
  element('banner-text').textContent = sentence;
  element('banner-reload').hidden = !reload;
  element('banner').hidden = sentence === '';
}
