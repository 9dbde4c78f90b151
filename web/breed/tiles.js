// SPDX-License-Identifier: MIT
// Motions side by side, in step, each a button that picks it.
import { GridKeys } from '../browser/grid_keys.js';
import { MotionPicture, pageColours } from '../share/motion_picture.js';
import { differences } from './traits.js';
import { icon } from './icon.js';
import { fixed, tr } from '../languages/language.js';

/** @typedef {import('./nursery.js').Child} Child */
/** @typedef {import('../search/engine.js').RecordedMotion} RecordedMotion */
/** @typedef {{child: Child, item: HTMLLIElement, button: HTMLButtonElement, canvas: HTMLCanvasElement, metres: HTMLElement, picture: MotionPicture | null, painted: string}} Tile */

const HEART = 'M10 16.5C5.5 13 3 10.6 3 7.7A3.7 3.7 0 0 1 6.7 4C8.2 4 9.3 4.8 10 6c.7-1.2 1.8-2 3.3-2A3.7 3.7 0 0 1 17 7.7c0 2.9-2.5 5.3-7 8.8z';
const DOTS = 'M4.5 10h.01M10 10h.01M15.5 10h.01';

export class Tiles {
  /** @type {Tile[]} */
  #tiles = [];
  #keys;
  #frame = 0;
  #began = 0; // when the motions began together [ms]
  #calm = matchMedia('(prefers-reduced-motion: reduce)').matches;

  /**
   * @param {HTMLElement} list
   * @param {object} uses
   * @param {(child: Child) => RecordedMotion} uses.simulate
   * @param {import('./traits.js').Trait[]} uses.traits
   * @param {() => void} uses.picked  called after a pick
   * @param {(child: Child, from: HTMLElement) => void} uses.menu
   * @param {AbortSignal} uses.signal  ends the keys
   */
  constructor(list, { simulate, traits, picked, menu, signal }) {
    this.list = list;
    this.#keys = new GridKeys(list, () => this.#tiles.map(({ button }) => button), signal);
    this.simulate = simulate;
    this.traits = traits;
    this.picked = picked;
    this.menu = menu;
  }

  /** Shows these motions, none of them picked. @param {Child[]} children */
  show(children) {
    const inside = this.list.contains(document.activeElement);
    this.#forget();
    this.#tiles = children.map((child, i) => this.#add(child, i));
    this.list.replaceChildren(...this.#tiles.map(({ item }) => item));
    this.#keys.rove();
    if (inside) this.#keys.focus();
    this.#began = performance.now();
    this.#next();
  }

  /** The picked motions as bits. */
  get picks() { return this.#tiles.reduce((bits, { button }, i) => bits | (button.ariaPressed === 'true' ? 1 << i : 0), 0); }
  focus() { this.#keys.focus(); }
  /** @param {number} index @returns {boolean} false: there is no such motion */
  toggle(index) {
    const tile = this.#tiles[index];
    if (!tile) return false;
    tile.button.ariaPressed = tile.button.ariaPressed === 'true' ? 'false' : 'true';
    this.picked();
    return true;
  }

  /** Picks these motions alone. @param {number} bits */
  pick(bits) {
    for (const [i, { button }] of this.#tiles.entries()) button.ariaPressed = (bits >> i) & 1 ? 'true' : 'false';
    this.picked();
  }

  /** Says each motion's measures again, in another language for example. */
  describe() {
    for (const tile of this.#tiles) this.#describe(tile);
  }

  close() {
    cancelAnimationFrame(this.#frame);
    this.#forget();
    this.list.replaceChildren();
  }

  /** @param {Child} child @param {number} index @returns {Tile} */
  #add(child, index) {
    const item = document.createElement('li');
    const button = Object.assign(document.createElement('button'), { type: 'button', className: 'tile', ariaPressed: 'false' });
    const canvas = document.createElement('canvas');
    canvas.ariaHidden = 'true';
    const metres = document.createElement('strong');
    button.append(canvas, metres, icon(HEART, 'heart'));
    button.addEventListener('click', () => this.toggle(index));
    const more = Object.assign(document.createElement('button'), { type: 'button', className: 'icon more' });
    more.append(icon(DOTS, ''));
    button.ariaLabel = tr('Motion {1}', index + 1);
    more.ariaLabel = more.title = tr('More for motion {1}', index + 1);
    more.addEventListener('click', () => this.menu(child, more));
    item.append(button, more);
    return { child, item, button, canvas, metres, picture: null, painted: '' };
  }

  /** @param {Tile} tile */
  #describe({ child, item, button, metres, picture }) {
    if (!picture) return;
    const number = this.#tiles.findIndex((tile) => tile.child === child) + 1;
    const { numbers, stride, frames } = picture.motion;
    const distance = numbers[(frames - 1) * stride + 1] - numbers[1];
    metres.textContent = `${fixed(distance, Math.abs(distance) < 10 ? 1 : 0)} m`;
    const { more, less } = differences(child.traits, this.#tiles.filter((tile) => tile.child !== child).map((tile) => tile.child.traits), this.traits);
    const parts = [tr('Motion {1}: {2}.', number, metres.textContent)];
    if (more.length) parts.push(tr('More than the others: {1}.', more.join(', ')));
    if (less.length) parts.push(tr('Less: {1}.', less.join(', ')));
    button.ariaLabel = parts.join(' ');
    button.title = parts.slice(1).join(' ');
    const dots = /** @type {HTMLElement} */ (item.querySelector('.more'));
    dots.ariaLabel = dots.title = tr('More for motion {1}', number);
  }

  #forget() {
    for (const tile of this.#tiles) tile.picture?.close();
    this.#tiles = [];
  }

  #next() {
    cancelAnimationFrame(this.#frame);
    if (this.#tiles.length > 0) this.#frame = requestAnimationFrame((now) => this.#tick(now));
  }

  /** @param {number} now [ms] */
  #tick(now) {
    this.#next();
    // One simulation a frame, so that nothing stands still meanwhile.
    const next = this.#tiles.find(({ picture }) => !picture);
    if (next) {
      next.picture = new MotionPicture(this.simulate(next.child));
      this.#describe(next);
      if (this.#tiles.every(({ picture }) => picture)) this.#began = now; // they begin together
    }
    const colours = pageColours();
    for (const tile of this.#tiles) {
      if (!tile.picture) continue;
      const still = `${colours.paper}${colours.ink} ${tile.canvas.clientWidth}`;
      if (!this.#calm) tile.picture.play(tile.canvas, Math.max(0, now - this.#began) / 1000, colours);
      else if (tile.painted !== still) tile.picture.strip(tile.canvas, colours);
      tile.painted = still;
    }
  }
}
