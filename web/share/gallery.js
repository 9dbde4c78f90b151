// SPDX-License-Identifier: MIT
// The shipped motions as cards. Each card in sight plays its real motion, which the engine simulates.
import { element } from '../browser/dom.js';
import { MotionPicture } from './motion_picture.js';
import { Engine } from '../search/engine.js';
import { compiledEngine } from '../search/compiled_engine.js';
import { fixed, followLanguage, tr, trTitle } from '../languages/language.js';

/** metres: how far it gets, or how high if it jumps. link: its payload. @typedef {{title: string, figure: string, metres: number, jumps: boolean, link: string}} Shipped */
/** @typedef {{shipped: Shipped, button: HTMLButtonElement, canvas: HTMLCanvasElement, picture: MotionPicture | null, inSight: boolean, painted: boolean}} Card */

const FRAME_MS = 1000 / 30;
const COLOURS = /** @type {const} */ (['paper', 'ink', 'ink2', 'line', 'soft']);

export class Gallery {
  #list = element('open-gallery');
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
    this.#list.addEventListener('keydown', (event) => this.#key(event));
    this.#list.addEventListener('focusin', ({ target }) => this.#rove(this.#cards.findIndex(({ button }) => button === target)));
    addEventListener('resize', () => { for (const card of this.#cards) card.painted = false; });
  }

  /** Rejected if a file could not be loaded. */
  async show() {
    this.#open = true;
    this.#list.scrollTop = 0;
    const [shipped, code] = await Promise.all([this.#cards.length ? [] : motions(), compiledEngine()]);
    this.#engine ??= await Engine.load(code);
    for (const one of shipped) this.#add(one);
    if (shipped.length) this.#rove(0);
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
  focus() { this.#cards.find(({ button }) => button.tabIndex === 0)?.button.focus(); }

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
    const style = getComputedStyle(document.documentElement);
    const colours = /** @type {import('./motion_picture.js').Colours} */ (Object.fromEntries(COLOURS.map((name) => [name, style.getPropertyValue(`--${name}`).trim()])));
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

  /** Makes one card the list's only stop of the Tab key. @param {number} index */
  #rove(index) {
    if (index < 0) return;
    for (const [i, { button }] of this.#cards.entries()) button.tabIndex = i === index ? 0 : -1;
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    const at = this.#cards.findIndex(({ button }) => button === document.activeElement);
    if (at < 0 || event.ctrlKey || event.metaKey || event.altKey) return;
    const tops = this.#cards.map(({ button }) => button.offsetTop);
    const across = tops.filter((top) => top === tops[0]).length;
    const steps = /** @type {Record<string, number>} */ ({ ArrowRight: 1, ArrowLeft: -1, ArrowDown: across, ArrowUp: -across, Home: -at, End: tops.length });
    if (!(event.key in steps)) return;
    event.preventDefault();
    const { button } = this.#cards[Math.min(Math.max(at + steps[event.key], 0), tops.length - 1)];
    button.focus();
    button.scrollIntoView({ block: 'nearest' });
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
