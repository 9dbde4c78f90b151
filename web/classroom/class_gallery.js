// SPDX-License-Identifier: MIT
// The class's motions, all moving, for the projector.
import { tr } from '../languages/language.js';
import { MotionPicture, pageColours } from '../share/motion_picture.js';

/** @typedef {import('./judge.js').Row} Row */

const FRAME_MS = 1000 / 30;

export class ClassGallery {
  #list;
  #names;
  /** @type {{canvas: HTMLCanvasElement, picture: MotionPicture}[]} */
  #shown = [];
  #painted = 0;
  #calm = matchMedia('(prefers-reduced-motion: reduce)');

  /** @param {HTMLDialogElement} dialog  with ul, a switch for names and a button */
  constructor(dialog) {
    this.dialog = dialog;
    this.#list = /** @type {HTMLUListElement} */ (dialog.querySelector('ul'));
    this.#names = /** @type {HTMLInputElement} */ (dialog.querySelector('input'));
    this.#names.addEventListener('change', () => this.#list.classList.toggle('named', this.#names.checked));
    dialog.querySelector('button')?.addEventListener('click', () => dialog.close());
    dialog.addEventListener('close', () => { this.#shown = []; });
  }

  /** @param {Row[]} rows */
  open(rows) {
    this.#list.replaceChildren();
    this.#shown = rows.flatMap((row) => {
      if (!row.motion) return [];
      const canvas = document.createElement('canvas'), item = document.createElement('li'), name = document.createElement('span');
      canvas.setAttribute('role', 'img');
      canvas.ariaLabel = tr('Motion {1}', rows.indexOf(row) + 1);
      name.textContent = row.name;
      item.append(canvas, name);
      this.#list.append(item);
      return [{ canvas, picture: new MotionPicture(row.motion) }];
    });
    this.#list.style.setProperty('--across', String(Math.ceil(Math.sqrt(this.#shown.length * 1.6))));
    this.dialog.showModal();
    const colours = pageColours();
    if (this.#calm.matches) for (const { canvas, picture } of this.#shown) picture.strip(canvas, colours);
    else requestAnimationFrame((ms) => this.#play(ms));
  }

  /** @param {number} ms */
  #play(ms) {
    if (this.#shown.length === 0) return;
    if (ms - this.#painted >= FRAME_MS) {
      this.#painted = ms;
      const colours = pageColours();
      for (const { canvas, picture } of this.#shown) picture.play(canvas, ms / 1000, colours);
    }
    requestAnimationFrame((next) => this.#play(next));
  }
}
