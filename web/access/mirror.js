// SPDX-License-Identifier: MIT
// The page's mirror of the canvas: for each widget an element at the same place, for assistive tools and for the
// keyboard. Pointer and touch go through it to the canvas. Actions on an element become requests to the application,
// which returns the changes.
import { MirrorKeys } from './mirror_keys.js';
import { fixedText, numberOf } from '../languages/language.js';
import { element } from '../browser/dom.js';
import { ROVING, controlledPart, isBesideNumber, fits, isMirrored, nodeFor, nodeForPart, setAttribute, takesKeyboard, update } from './mirror_nodes.js';

/** @typedef {import('../app/app.js').App} App */
/** @typedef {import('../app/app.js').MirrorPart} MirrorPart */
/** @typedef {import('../app/app.js').MirrorWidget} MirrorWidget */
/** @typedef {{node: HTMLElement, widget: MirrorWidget}} Reflection */

// Limit for changes without an action, since reading is no faster. A person's own action is answered at the next frame.
const EVERY_MS = 250;
// For so long a change of what has the keyboard counts as the person's own.
const OWN_MS = 1500;
// What comes so near to where something went has its place, though a line of text may have shifted it. [CSS pixels]
const NEAR = 60;

export class Mirror {
  #root = element('mirror');
  /** In the order of drawing. @type {Map<string, Reflection>} */
  #reflections = new Map();
  /** @type {Map<string | undefined, HTMLElement>} */
  #parts = new Map();
  #keyboard = false;
  #waiting = false;
  /** Keys that are down on the canvas. @type {Set<string>} */
  #held = new Set();
  /** The widget whose element the page's focus was last seen on. @type {string | undefined} */
  #here;
  #soon = false;
  #actedMs = -OWN_MS;

  /** @param {App} app @param {HTMLCanvasElement} canvas */
  constructor(app, canvas) {
    this.app = app;
    this.canvas = canvas;
    this.keys = new MirrorKeys(this);
    this.#root.addEventListener('click', (event) => this.#clicked(event));
    this.#root.addEventListener('input', (event) => this.#changed(event));
    this.#root.addEventListener('change', (event) => this.#changed(event));
    this.#root.addEventListener('focusin', (event) => this.#focused(event));
    this.#root.addEventListener('focusout', (event) => {
      // No other event reports that a field was left unchanged.
      const left = this.at(event.target);
      if (left?.node.classList.contains('typing')) this.commit(left);
      if (this.contains(event.relatedTarget)) return;
      this.#here = undefined;
      if (event.relatedTarget !== canvas) app.unfocus();
    });
    this.#root.addEventListener('keydown', (event) => this.keys.take(event));
    canvas.addEventListener('keydown', ({ code }) => this.#held.add(code));
    canvas.addEventListener('keyup', ({ code }) => {
      this.#held.delete(code);
      this.#updateSoon();
    });
    canvas.addEventListener('blur', () => this.#held.clear());
    // A browser that scrolled it to something out of sight would shift it against the canvas.
    this.#root.addEventListener('scroll', () => this.#root.scrollTo(0, 0));
    setInterval(() => { if (!document.hidden) this.update(); }, EVERY_MS);
    this.update();
  }

  /** @param {EventTarget | null} node */
  contains(node) { return node instanceof Node && this.#root.contains(node); }

  /** @param {EventTarget | null} node @returns {Reflection | undefined} */
  at(node) {
    const id = node instanceof Element && this.contains(node) ? node.closest('[data-id]')?.getAttribute('data-id') : null;
    return id ? this.#reflections.get(id) : undefined;
  }

  /** What has the keyboard, whether the page's focus is here or on the canvas. @returns {Reflection | undefined} */
  get current() {
    return this.at(document.activeElement) ?? this.all.find(({ widget }) => widget.state.focused);
  }
  /** The name of the open panel. */
  get #panel() { return this.#parts.get('panel')?.getAttribute('aria-label'); }
  /** @returns {Reflection[]} */
  get all() { return [...this.#reflections.values()]; }
  /** Where the Tab key stops. @returns {Reflection[]} */
  get stops() { return this.all.filter(({ node }) => node.tabIndex === 0); }
  /** The others of its group; empty: it is in none that the arrows move in. @param {Reflection} reflection @returns {Reflection[]} */
  group({ node }) {
    const parent = node.parentElement;
    return ROVING.has(parent?.getAttribute('role') ?? '')
      ? this.all.filter(({ node: other, widget }) => other.parentElement === parent && takesKeyboard(widget)) : [];
  }

  /** The person did something to the canvas: the answer is shown as soon as it is there. */
  acted() {
    this.#actedMs = performance.now();
    this.#updateSoon();
  }

  /** Reads the canvas, and changes what differs. */
  update() {
    const told = this.app.mirror();
    if (!told) return this.#follow();
    this.#keyboard = told.keyboard;
    this.#waiting = told.waiting;
    const active = this.at(document.activeElement);
    const before = this.stops;
    const panel = this.#panel;
    this.#arrange(told.parts, told.widgets.filter(isMirrored));
    if (active && !active.node.isConnected) {
      // Another panel is shown: its tab names it.
      const tab = panel === this.#panel ? undefined
        : this.all.find(({ widget }) => widget.role === 'tab' && widget.state.selected);
      if (tab) this.focus(tab);
      else this.#comeFrom(active, before);
    }
    this.#rove();
    this.#follow();
    if (this.#waiting) this.#updateSoon();
  }

  #updateSoon() {
    if (this.#soon) return;
    this.#soon = true;
    // The application draws in the next frame, maybe after this is called.
    requestAnimationFrame(() => requestAnimationFrame(() => {
      this.#soon = false;
      this.update();
    }));
  }

  /** @param {MirrorPart[]} parts @param {MirrorWidget[]} widgets */
  #arrange(parts, widgets) {
    const own = performance.now() - this.#actedMs < OWN_MS || !this.app.playing();
    /** @type {Map<HTMLElement, HTMLElement[]>} */
    const children = new Map([[this.#root, []]]);
    /** @type {Map<string | undefined, HTMLElement>} */
    const partNodes = new Map();
    const nodeOf = (/** @type {number} */ index) => {
      if (index < 0) return this.#root;
      const part = parts[index];
      const known = partNodes.get(part.id);
      if (known) return known;
      const node = this.#parts.get(part.id) ?? nodeForPart(part);
      setAttribute(node, 'aria-label', part.label);
      children.get(nodeOf(part.parent))?.push(node);
      children.set(node, []);
      partNodes.set(part.id, node);
      return node;
    };
    /** @type {Map<string, Reflection>} */
    const reflections = new Map();
    for (const widget of widgets) {
      const known = this.#reflections.get(widget.id);
      const node = known && fits(known.node, known.widget, widget.role) ? known.node : nodeFor(widget);
      update(node, widget, own || node !== document.activeElement);
      children.get(nodeOf(widget.part))?.push(node);
      reflections.set(widget.id, { node, widget });
    }
    for (const [node, inside] of children) placeChildren(node, inside);
    for (const { node, widget } of reflections.values()) {
      setAttribute(node, 'aria-controls', partNodes.get(controlledPart(widget))?.id);
    }
    this.#reflections = reflections;
    this.#parts = partNodes;
  }

  /** A group has one stop: what has the keyboard, else what is chosen, else the first. */
  #rove() {
    for (const { node, widget } of this.#reflections.values()) {
      if (!takesKeyboard(widget) || isBesideNumber(widget)) {
        if (node.hasAttribute('tabindex') || node.tabIndex === 0) node.tabIndex = -1;
        continue;
      }
      const group = ROVING.has(node.parentElement?.getAttribute('role') ?? '') ? this.group({ node, widget }) : null;
      const stop = group?.find((one) => one.node === document.activeElement)
        ?? group?.find(({ widget: { state } }) => state.selected || state.checked) ?? group?.[0];
      const index = !stop || stop.node === node ? 0 : -1;
      if (node.tabIndex !== index || !node.hasAttribute('tabindex')) node.tabIndex = index;
    }
  }

  /** Where the application moved the keyboard to by itself, the page's focus goes, too. */
  #follow() {
    if (this.#waiting || !this.#keyboard) return;
    const here = this.at(document.activeElement);
    if (!here && document.activeElement !== this.canvas) return;
    // Who takes the keyboard from the canvas while a key is down leaves it down there for ever.
    if (this.#held.size > 0) return;
    // A window that is not in front gets no events when its focus moves.
    if (here && here.widget.id !== this.#here) return this.#came(here);
    const there = this.all.find(({ widget }) => widget.state.focused);
    // A number that is typed into the canvas is typed there.
    if (!there || there === here || there.widget.role === 'textbox' || !takesKeyboard(there.widget)) return;
    this.#here = there.widget.id;
    this.focus(there);
  }

  /** What had the keyboard is gone: what stands in its place gets it, or what stood before it. @param {Reflection} gone @param {Reflection[]} before */
  #comeFrom({ widget: { id, rect } }, before) {
    const x = rect.x + Math.min(8, rect.width / 2);
    const y = rect.y + rect.height / 2;
    const known = new Set(before.map(({ widget }) => widget.id));
    const after = this.all.filter(({ widget }) => takesKeyboard(widget));
    const far = (/** @type {Reflection} */ { widget }) => distance(widget.rect, x, y);
    const heir = after.filter((one) => !known.has(one.widget.id) && far(one) < NEAR).sort((a, b) => far(a) - far(b))[0]
      ?? before.slice(0, before.findIndex(({ widget }) => widget.id === id)).reverse()
        .map(({ widget }) => this.#reflections.get(widget.id)).find((one) => one && takesKeyboard(one.widget)) ?? after[0];
    if (!heir) return;
    const chosen = this.group(heir).find(({ widget: { state } }) => state.selected || state.checked);
    this.focus(known.has(heir.widget.id) && chosen ? chosen : heir);
  }

  /** @param {Reflection} reflection */
  focus({ node }) { node.focus({ preventScroll: true }); }

  /** The Tab key on the canvas: on from what it is at. @param {number} direction @returns {boolean} false: nothing more there */
  enter(direction) {
    this.update();
    const { stops, current } = this;
    const order = this.all;
    const at = current ? order.indexOf(order.find(({ widget }) => widget.id === current.widget.id) ?? order[0]) : -1;
    const next = direction > 0 ? stops.find((stop) => order.indexOf(stop) > at)
      : [...stops].reverse().find((stop) => order.indexOf(stop) < at);
    if (next) this.focus(next);
    return next !== undefined;
  }

  /** @param {Event} event */
  #focused(event) {
    const reflection = this.at(event.target);
    if (!reflection) return;
    const { node, widget } = reflection;
    if (node instanceof HTMLInputElement && node.type === 'text') node.select();
    this.#rove();
    if (widget.id !== this.#here) this.#came(reflection);
  }

  /** The page's focus came to it: on the canvas the keyboard does, too. @param {Reflection} reflection */
  #came({ node, widget }) {
    this.#here = widget.id;
    this.#waiting = true; // the last record does not include it
    this.app.focus(widget.id, node.matches(':focus-visible'));
    this.#updateSoon();
  }

  /** @param {MouseEvent} event */
  #clicked(event) {
    const reflection = this.at(event.target);
    if (!reflection || reflection.node instanceof HTMLInputElement || reflection.widget.state.disabled) return;
    if (!takesKeyboard(reflection.widget)) return;
    this.app.activate(reflection.widget.id);
    this.acted();
  }

  /** @param {Event} event */
  #changed({ target, type }) {
    const reflection = this.at(target);
    if (!reflection || !(target instanceof HTMLInputElement)) return;
    if (target.type === 'range') {
      if (type === 'input') this.set(reflection, target.valueAsNumber);
      return;
    }
    if (type === 'input') target.classList.add('typing');
    else this.commit(reflection);
  }

  /** The number of a slider is typed, in its place. @param {Reflection} reflection */
  type({ node, widget }) {
    if (!(node instanceof HTMLInputElement) || !widget.range || widget.state.disabled) return;
    node.type = 'text';
    node.inputMode = 'decimal';
    node.value = fixedText(widget.range.now);
    node.setAttribute('role', 'spinbutton');
    node.classList.add('typing');
    update(node, widget, true);
    node.select();
  }

  /** @param {Reflection} reflection @param {number} value @param {boolean} [again]  a key that is held */
  set({ widget }, value, again = false) {
    if (widget.state.disabled || !Number.isFinite(value)) return;
    this.app.setValue(widget.id, value, again);
    this.acted();
  }

  /** Ends the typing of a number. @param {Reflection} reflection @param {boolean} [keep]  false: as it was before */
  commit({ node, widget }, keep = true) {
    if (!(node instanceof HTMLInputElement)) return;
    const value = numberOf(node.value);
    node.classList.remove('typing');
    if (widget.role === 'slider') {
      for (const name of ['role', 'aria-valuemin', 'aria-valuemax', 'aria-valuenow']) node.removeAttribute(name);
      node.type = 'range';
      update(node, widget, true);
    }
    if (keep && Number.isFinite(value)) this.set({ node, widget }, value);
    else if (widget.role !== 'slider') node.value = widget.value;
  }
}

/**
 * Makes these the children, in this order, without moving those that are in order: what is moved loses the keyboard.
 * @param {HTMLElement} parent @param {HTMLElement[]} wanted
 */
function placeChildren(parent, wanted) {
  const keep = new Set(wanted);
  for (const child of [...parent.children]) {
    if (child instanceof HTMLElement && !keep.has(child)) child.remove();
  }
  let at = parent.firstElementChild;
  for (const node of wanted) {
    if (node === at) at = at.nextElementSibling;
    else parent.insertBefore(node, at);
  }
}

/** @param {MirrorWidget['rect']} rect @param {number} x @param {number} y */
const distance = (rect, x, y) => Math.hypot(Math.max(rect.x - x, 0, x - rect.x - rect.width), Math.max(rect.y - y, 0, y - rect.y - rect.height));
