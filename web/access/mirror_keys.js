// SPDX-License-Identifier: MIT
// Keys on the mirror of the canvas, after the commands (keys.js). The browser itself handles Enter and Space on
// buttons.
import { isNumber } from './mirror_nodes.js';

/** @typedef {import('./mirror.js').Mirror} Mirror */
/** @typedef {import('./mirror.js').Reflection} Reflection */

const PAGE = 10; // steps
/** @type {Record<string, [number, number]>} */
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
/** Steps of a value. @type {Record<string, number>} */
const STEPS = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1, PageDown: -PAGE, PageUp: PAGE };

export class MirrorKeys {
  /** Whether Escape has just left the mirror. The next Tab then continues after it. */
  #escaped = false;

  /** @param {Mirror} mirror */
  constructor(mirror) {
    this.mirror = mirror;
  }

  /** Whether a widget needs this key, so that no command may handle it. @param {EventTarget | null} target @param {string} name  as from keyName */
  wants(target, name) {
    const reflection = this.mirror.at(target);
    if (!reflection || !(isNumber(reflection.widget.role) || isTyping(reflection))) return false;
    return isTyping(reflection) ? !/^(Ctrl|F\d)/.test(name) : /^[\d.-]$|^Backspace$|^Delete$/.test(name);
  }

  /** Called for every key, before all other handlers. @param {KeyboardEvent} event @returns {boolean} whether it was handled */
  intercept(event) {
    const escaped = this.#escaped;
    this.#escaped = false;
    if (event.key !== 'Tab' || event.ctrlKey || event.altKey || event.metaKey) return false;
    const direction = event.shiftKey ? -1 : 1;
    const onCanvas = event.target === this.mirror.canvas;
    if (!onCanvas && !(escaped && event.target === document.body)) return false;
    if (!onCanvas || !this.mirror.enter(direction)) leave(this.mirror.canvas, direction);
    return true;
  }

  /** @param {KeyboardEvent} event  on the mirror */
  handle(event) {
    const reflection = this.mirror.at(event.target);
    if (!reflection || event.altKey || event.ctrlKey || event.metaKey || event.isComposing) return;
    if (!this.#handle(reflection, event)) return;
    event.preventDefault();
    event.stopPropagation();
  }

  /** @param {Reflection} reflection @param {KeyboardEvent} event @returns {boolean} */
  #handle(reflection, event) {
    const { widget, node } = reflection;
    if (event.key === 'Escape') return this.#escape(reflection);
    if (isNumber(widget.role) && this.#number(reflection, event)) return true;
    if (widget.role === 'slider' && event.key === 'Enter') {
      if (isTyping(reflection)) this.mirror.commit(reflection);
      else this.mirror.type(reflection);
      return true;
    }
    if (isTyping(reflection)) return false;
    if (widget.range) return this.#value(reflection, event);
    if (event.key === 'Enter' && node.tagName === 'DIV') {
      node.click();
      return true;
    }
    return this.#move(reflection, event.key);
  }

  /** @param {Reflection} reflection */
  #escape(reflection) {
    if (isTyping(reflection)) {
      this.mirror.commit(reflection, false);
    } else if (this.mirror.app.dismiss()) {
      this.mirror.acted();
    } else {
      reflection.node.blur();
      this.#escaped = true;
    }
    return true;
  }

  /** @param {Reflection} reflection @param {KeyboardEvent} event @returns {boolean} */
  #number(reflection, { key }) {
    const { node } = reflection;
    if (!(node instanceof HTMLInputElement)) return false;
    if (key === 'Enter') {
      if (isTyping(reflection)) {
        this.mirror.commit(reflection);
        node.select();
      } else {
        this.mirror.type(reflection);
      }
      return true;
    }
    if (isTyping(reflection) && (key === 'ArrowUp' || key === 'ArrowDown')) this.mirror.commit(reflection);
    return false;
  }

  /** @param {Reflection} reflection @param {KeyboardEvent} event @returns {boolean} */
  #value(reflection, { key, shiftKey, repeat }) {
    const { widget } = reflection;
    if (!widget.range) return false;
    if (key === 'Home') this.mirror.set(reflection, widget.range.low, repeat);
    else if (key === 'End') this.mirror.set(reflection, widget.range.high, repeat);
    else if (STEPS[key]) {
      this.mirror.app.step(widget.id, STEPS[key] * (shiftKey && key.startsWith('Arrow') ? PAGE : 1), repeat);
      this.mirror.acted();
    } else return false;
    return true;
  }

  /** Moves the focus: in a group to the next widget, else to the nearest one in that direction. @param {Reflection} from @param {string} key @returns {boolean} */
  #move(from, key) {
    const group = this.mirror.group(from);
    const at = group.findIndex(({ node }) => node === from.node);
    let next;
    if (group.length > 1 && at >= 0) {
      if (key === 'Home') next = group[0];
      else if (key === 'End') next = group[group.length - 1];
      else if (ARROWS[key]) next = group[(at + ARROWS[key][0] + ARROWS[key][1] + group.length) % group.length];
    } else if (ARROWS[key]) {
      next = nearest(from, this.mirror.stops, ARROWS[key]);
    }
    if (next) this.mirror.focus(next);
    return next !== undefined || key in ARROWS;
  }
}

/** @param {Reflection} reflection */
function isTyping({ node }) { return node.classList.contains('typing'); }

/** @param {Reflection} from @param {Reflection[]} stops @param {[number, number]} direction */
function nearest(from, stops, [right, down]) {
  const middle = (/** @type {Reflection} */ { widget: { rect } }) => [rect.x + rect.width / 2, rect.y + rect.height / 2];
  const [x, y] = middle(from);
  let best;
  let minDistance = Infinity;
  for (const stop of stops) {
    if (stop.node === from.node) continue;
    const [sx, sy] = middle(stop);
    const along = (sx - x) * right + (sy - y) * down;
    const aside = Math.abs((sx - x) * down) + Math.abs((sy - y) * right);
    const distance = along + 3 * aside;
    if (along > 1 && distance < minDistance) [best, minDistance] = [stop, distance];
  }
  return best;
}

/**
 * Moves the focus from the canvas and its mirror to the next element of the page.
 * @param {HTMLCanvasElement} canvas @param {number} direction  1 forwards, -1 backwards
 */
function leave(canvas, direction) {
  const all = [...document.querySelectorAll('a[href], button, input, select, textarea, canvas')].filter((node) => node === canvas
    || (node instanceof HTMLElement && node.tabIndex === 0 && !node.matches(':disabled') && node.getClientRects().length > 0
      && !node.closest('#mirror, dialog:not([open])')));
  // After the last one comes the footer, from where the browser's own controls follow.
  const next = all[all.indexOf(canvas) + direction] ?? document.querySelector('footer');
  if (next instanceof HTMLElement) next.focus();
}
