// SPDX-License-Identifier: MIT
// The shipped motions as cards. Each card in sight plays its real motion, which the engine simulates.
import { element } from '../browser/dom.js';
import { GridKeys } from '../browser/grid_keys.js';
import { MotionPicture, pageColours } from './motion_picture.js';
import { Engine } from '../search/engine.js';
import { compiledEngine } from '../search/compiled_engine.js';
import { fixed, followLanguage, tr, trTitle } from '../languages/language.js';

/** metres: how far it gets, or how high if it jumps. link: its payload. @typedef {{title: string, figure: string, metres: number, jumps: boolean, link: string}} Shipped */
/** @typedef {{shipped: Shipped, button: HTMLButtonElement, canvas: HTMLCanvasElement, picture: MotionPicture | null, inSight: boolean, painted: boolean}} Card */

const FRAME_MS = 1000 / 30;

export class Gallery {
  #list = element('open-gallery');
  #keys = new GridKeys(this.#list, () => this.#cards.map(({ button }) => button));
  /** @type {Card[]} */
  #cards = [];
  /** @type {Engine | null} */
  #engine = null;
  #open = false;
  #drawn = 0; // when the pictures were painted last [ms]
  #frame = 0; // the next one, of requestAnimationFrame
  #calm = matchMedia('(prefers-reduced-motion: reduce)').matches;
  #sight = new IntersectionObserver((changes) => this.#see(changes), { root: this.#list });

  /** @param {(shipped: Shipped) => void} choose */
  constructor(choose) {
    this.choose = choose;
    addEventListener('resize', () => { for (const card of this.#cards) card.painted = false; });
  }

  /** Rejected if a file could not be loaded. */
  async show() {
    this.#open = true;
    this.#list.scrollTop = 0;
    const [shipped, code] = await Promise.all([this.#cards.length ? [] : motions(), compiledEngine()]);
    this.#engine ??= await Engine.load(code);
    for (const one of shipped) this.#add(one);
    this.#keys.rove();
    for (const { button } of this.#cards) this.#sight.observe(button);
    this.#next();
  }

  /** Stops all pictures. */
  hide() {
    this.#open = false;
    cancelAnimationFrame(this.#frame);
    this.#sight.disconnect();
    for (const card of this.#cards) forget(card);
  }

  /** Focuses the card that was focused last, or the first one. */
  focus() { this.#keys.focus(); }

  /** @param {Shipped} shipped */
  #add(shipped) {
    const item = document.createElement('li');
    const button = Object.assign(document.createElement('button'), { type: 'button', tabIndex: -1 });
    const canvas = document.createElement('canvas');
    canvas.ariaHidden = 'true';
    const [name, line] = [document.createElement('strong'), document.createElement('small')];
    followLanguage(() => {
      const metres = fixed(shipped.metres, Math.abs(shipped.metres) < 10 ? 1 : 0);
      name.textContent = trTitle(shipped.title);
      line.textContent = tr(shipped.jumps ? '{1}, jumps {2} m high' : '{1}, {2} m', trTitle(shipped.figure), metres);
    });
    button.append(canvas, name, line);
    button.addEventListener('click', () => this.choose(shipped));
    item.append(button);
    this.#list.append(item);
    this.#cards.push({ shipped, button, canvas, picture: null, inSight: false, painted: false });
  }

  /** @param {IntersectionObserverEntry[]} changes */
  #see(changes) {
    for (const { target, isIntersecting } of changes) {
      const card = this.#cards.find(({ button }) => button === target);
      if (!card) continue;
      card.inSight = isIntersecting;
      if (!isIntersecting) forget(card);
    }
  }

  #next() {
    cancelAnimationFrame(this.#frame);
    if (this.#open) this.#frame = requestAnimationFrame((now) => this.#tick(now));
  }

  /** @param {number} now [ms] */
  #tick(now) {
    this.#next();
    if (now - this.#drawn < FRAME_MS - 4) return;
    this.#drawn = now;
    const colours = pageColours();
    // One simulation a frame, so that scrolling stays smooth.
    const next = this.#cards.find((card) => card.inSight && !card.picture);
    if (next && this.#engine) next.picture = new MotionPicture(this.#engine.motion(this.#engine.documentFromText(next.shipped.link)));
    for (const card of this.#cards) {
      if (!card.inSight || !card.picture || (this.#calm && card.painted)) continue;
      if (this.#calm) card.picture.strip(card.canvas, colours);
      else card.picture.play(card.canvas, now / 1000, colours);
      card.painted = true;
    }
  }
}

/** @returns {Promise<Shipped[]>} */
async function motions() {
  const answer = await fetch(new URL('../gallery/motions.json', import.meta.url));
  if (!answer.ok) throw new Error('no gallery');
  return answer.json();
}

/** @param {Card} card */
function forget(card) {
  card.picture?.close();
  card.picture = null;
  card.inSight = card.painted = false;
}
