// SPDX-License-Identifier: MIT
// The header: its menu on narrow screens, what it shows in the viewer, the banner below it, and Undo and Redo, with the
// reason if they are unavailable.
import { banner, element, onClick } from '../browser/dom.js';
import { keyCap } from '../access/keys.js';
import { followLanguage, tr } from '../languages/language.js';

/** @typedef {import('../app/app.js').App} App */

// On these screens the menu is folded. It is also folded inside another page, and if its words are too long.
const NARROW = matchMedia('(max-width: 899px)');

export function startHeader() {
  foldMenu();
  onClick('banner-close', () => banner(''));
  onClick('banner-reload', () => location.reload());
  const more = element('more');
  const menu = element('menu');
  const show = (/** @type {boolean} */ shown) => {
    menu.classList.toggle('shown', shown);
    more.setAttribute('aria-expanded', String(shown));
  };
  more.addEventListener('click', (event) => {
    event.stopPropagation();
    show(!menu.classList.contains('shown'));
  });
  for (const type of ['click', 'pointerdown']) {
    document.addEventListener(type, (event) => {
      if (type === 'click' || !(event.target instanceof Node && (menu.contains(event.target) || more.contains(event.target)))) show(false);
    });
  }
  menu.addEventListener('keydown', (event) => {
    if (event.key !== 'Escape') return;
    show(false);
    more.focus();
  });
}

/** Folds the menu if it does not fit. That depends on the language, the theme's size and the typeface. */
function foldMenu() {
  const root = document.documentElement;
  const header = /** @type {HTMLElement} */ (element('more').parentElement);
  const fold = () => {
    delete root.dataset.compact;
    if (window.parent !== window || NARROW.matches || header.scrollWidth > header.clientWidth) root.dataset.compact = '';
  };
  addEventListener('resize', fold);
  document.fonts.addEventListener('loadingdone', fold);
  new MutationObserver(fold).observe(root, { attributeFilter: ['data-scale', 'data-viewer'] });
  followLanguage(fold);
}

/** Adapts header and address to the viewer, which the application enters and leaves. @param {{app: App, address: import('../share/address.js').Address}} parts */
export function followViewer({ app, address }) {
  const { dataset } = document.documentElement;
  if (app.viewing()) dataset.viewer = '';
  else if (dataset.viewer !== undefined) {
    delete dataset.viewer;
    address.write(); // so that a reload at once stays in the workbench
  }
}

export class HistoryButtons {
  #undo = element('undo');
  #redo = element('redo');

  /** @param {App} app */
  constructor(app) {
    this.app = app;
    // If there is nothing to do, the application shows that in the status line.
    onClick('undo', () => app.undo());
    onClick('redo', () => app.redo());
    followLanguage(() => this.update());
  }

  /** Call after every change of the document. */
  update() {
    setAvailable(this.#undo, tr('Undo ({1})', keyCap('Ctrl+z')), this.app.canUndo() ? '' : tr('Nothing to undo.'));
    setAvailable(this.#redo, tr('Redo ({1})', keyCap('Ctrl+Shift+z')), this.app.canRedo() ? '' : tr('Nothing to redo.'));
  }
}

/**
 * Not with `disabled`, because a button loses the focus when it is disabled.
 * @param {HTMLElement} button @param {string} title @param {string} whyNot
 */
function setAvailable(button, title, whyNot) {
  button.title = whyNot || title;
  button.setAttribute('aria-disabled', String(whyNot !== ''));
}
