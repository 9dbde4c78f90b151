// SPDX-License-Identifier: MIT
// A small stage in a text: it plays a motion, has controls of its own, and a line that says what happens.
import { fixed } from '../languages/language.js';
import { MotionPicture, pageColours } from '../share/motion_picture.js';
import { Climb, measured } from './changes.js';

/** @typedef {import('../search/engine.js').Engine} Engine */
/** @typedef {import('./changes.js').Json} Json */

const SEARCH_MS = 7; // of a frame
const SAID_EVERY_MS = 120;

export class LiveStage {
  /** @type {MotionPicture | null} */
  #picture = null;
  /** Seconds of the motion when the clock was #since [ms]. */
  #at = 0;
  #since = 0;
  #painted = false;
  /** @type {{climb: Climb, progress: (climb: Climb) => void, improved: number} | null} */
  #search = null;
  #saidAt = 0;
  inSight = false;
  speed = 1;

  /** @param {HTMLElement} figure  with a canvas, a place for controls and a line @param {Engine} engine @param {Json} json */
  constructor(figure, engine, json) {
    this.figure = figure;
    this.engine = engine;
    this.json = json;
    this.canvas = /** @type {HTMLCanvasElement} */ (figure.querySelector('canvas'));
    this.controls = /** @type {HTMLElement} */ (figure.querySelector('.controls'));
    this.line = /** @type {HTMLElement} */ (figure.querySelector('.said'));
  }

  get motion() { return /** @type {MotionPicture} */ (this.#picture).motion; }
  get travel() { return measured(this.motion, 'travel'); }
  get seconds() { return (this.motion.frames - 1) / 100; }

  /** Plays another motion, from the same moment. @param {Json | Uint8Array} document */
  show(document) {
    const bytes = document instanceof Uint8Array ? document : this.engine.documentFromText(JSON.stringify(document));
    const picture = new MotionPicture(this.engine.motion(bytes));
    this.#picture?.close();
    this.#picture = picture;
    this.#painted = false;
  }

  /** Goes on from this moment. @param {number} seconds */
  seek(seconds) {
    this.#at = seconds;
    this.#since = performance.now();
    this.#painted = false;
  }

  /** @param {string} words */
  say(words) { if (this.line.textContent !== words) this.line.textContent = words; }

  /** Searches while it is in sight. @param {Json} json  with the search that is wanted @param {(climb: Climb) => void} progress  after each piece, and at the end */
  search(json, progress) {
    this.#search?.climb.close();
    this.#search = { climb: new Climb(this.engine, json), progress, improved: 0 };
    this.#saidAt = 0;
  }

  /** Works and paints for one frame. @param {number} ms @param {boolean} calm  shows some poses side by side, and nothing moves */
  frame(ms, calm) {
    this.#goOn(ms);
    if (!this.#picture) return;
    if (calm && this.#painted) return;
    this.#painted = true;
    const colours = pageColours();
    if (calm) this.#picture.strip(this.canvas, colours);
    else this.#picture.play(this.canvas, this.#at + (this.speed * (ms - this.#since)) / 1000, colours);
  }

  /** @param {number} ms */
  #goOn(ms) {
    const search = this.#search;
    if (!search) return;
    search.climb.goOn(SEARCH_MS);
    const { done, history } = search.climb;
    if (history.length > search.improved && (done || ms - this.#saidAt > SAID_EVERY_MS)) {
      search.improved = history.length;
      const best = search.climb.best();
      if (best) this.show(best);
    }
    if (done || ms - this.#saidAt > SAID_EVERY_MS) {
      this.#saidAt = ms;
      search.progress(search.climb);
    }
    if (!done) return;
    search.climb.search.close();
    this.#search = null;
  }

  // Controls.

  /**
   * @param {{label: string, min: number, max: number, step?: number, value: number, unit?: string, words?: (value: number) => string}} parts
   * @param {(value: number) => void} changed
   */
  slider({ label, min, max, step = 1, value, unit = '', words = (number) => `${number} ${unit}`.trim() }, changed) {
    const row = document.createElement('label'), name = document.createElement('span'), shown = document.createElement('output');
    const input = Object.assign(document.createElement('input'), { type: 'range', min: String(min), max: String(max), step: String(step), value: String(value) });
    const write = () => {
      shown.textContent = words(Number(input.value));
      input.setAttribute('aria-valuetext', shown.textContent);
    };
    name.textContent = label;
    row.append(name, input, shown);
    input.addEventListener('input', () => {
      write();
      changed(Number(input.value));
    });
    write();
    this.controls.append(row);
    return { input, set: (/** @type {number} */ number) => { input.value = String(number); write(); } };
  }

  /** @param {string} label @param {boolean} checked @param {(checked: boolean) => void} changed */
  toggle(label, checked, changed) {
    const row = document.createElement('label');
    const input = Object.assign(document.createElement('input'), { type: 'checkbox', checked });
    row.className = 'toggle';
    row.append(input, ` ${label}`);
    input.addEventListener('change', () => changed(input.checked));
    this.controls.append(row);
    return input;
  }

  /** A list of results as bars. @returns {(label: string, value: number, unit: string) => void} adds a bar, or changes the one with this label */
  bars() {
    const list = document.createElement('ul');
    list.className = 'bars';
    this.controls.append(list);
    /** @type {Map<string, {item: HTMLElement, value: number, unit: string}>} */
    const all = new Map();
    return (label, value, unit) => {
      if (!all.has(label)) list.append(all.set(label, { item: document.createElement('li'), value, unit }).get(label)?.item ?? '');
      Object.assign(/** @type {object} */ (all.get(label)), { value, unit });
      const most = Math.max(1e-9, ...[...all.values()].map((each) => each.value));
      for (const [name, each] of all) {
        each.item.textContent = `${name}: ${fixed(each.value, 1)} ${each.unit}`;
        each.item.style.setProperty('--share', String(Math.max(0, each.value) / most));
      }
    };
  }
}
