// SPDX-License-Identifier: MIT
// The page's mirror of the canvas: for each widget an element at the same place, for assistive tools and the keyboard.
// Pointer and touch go through it to the canvas. Actions on an element become requests to the application. The next
// update() shows their effect.
import { MirrorKeys } from './mirror_keys.js';
import { fixedText, numberOf } from '../languages/language.js';
import { element } from '../browser/dom.js';
import { ROVING, controlledPart, isBesideNumber, fits, isMirrored, nodeFor, nodeForPart, setAttribute, takesKeyboard, update } from './mirror_nodes.js';

/** @typedef {import('../app/app.js').App} App */
/** @typedef {import('../app/app.js').MirrorPart} MirrorPart */
/** @typedef {import('../app/app.js').MirrorWidget} MirrorWidget */
/** @typedef {{node: HTMLElement, widget: MirrorWidget}} Reflection */

// Update interval. A screen reader cannot read faster. After a person's action the mirror updates at the next frame.
const UPDATE_MS = 250;
// For this long after an action, changes of the focused element count as the person's.
const ACTION_MS = 1500;
// A new widget within this distance of a removed one replaces it. Text lines may shift widgets a little. [CSS pixels]
const NEAR = 60;

export class Mirror {
  #root = element('mirror');
  /** In drawing order. @type {Map<string, Reflection>} */
  #reflections = new Map();
  /** @type {Map<string | undefined, HTMLElement>} */
  #parts = new Map();
  #keyboard = false;
  #waiting = false;
  /** Keys held on the canvas. @type {Set<string>} */
  #keysDown = new Set();
  /** The widget whose element last had the page's focus. @type {string | undefined} */
  #focusedId;
  #updatePlanned = false;
  #actedMs = -ACTION_MS;

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
      // No other event occurs if a field is left unchanged.
      const left = this.at(event.target);
      if (left?.node.classList.contains('typing')) this.commit(left);
      if (this.contains(event.relatedTarget)) return;
      this.#focusedId = undefined;
      if (event.relatedTarget !== canvas) app.unfocus();
    });
    this.#root.addEventListener('keydown', (event) => this.keys.handle(event));
    canvas.addEventListener('keydown', ({ code }) => this.#keysDown.add(code));
    canvas.addEventListener('keyup', ({ code }) => {
      this.#keysDown.delete(code);
      this.#updateSoon();
    });
    canvas.addEventListener('blur', () => this.#keysDown.clear());
    // A browser may scroll to an element out of sight. That would shift the mirror against the canvas.
    this.#root.addEventListener('scroll', () => this.#root.scrollTo(0, 0));
    setInterval(() => { if (!document.hidden) this.update(); }, UPDATE_MS);
    this.update();
  }

  /** @param {EventTarget | null} node */
  contains(node) { return node instanceof Node && this.#root.contains(node); }

  /** @param {EventTarget | null} node @returns {Reflection | undefined} */
  at(node) {
    const id = node instanceof Element && this.contains(node) ? node.closest('[data-id]')?.getAttribute('data-id') : null;
    return id ? this.#reflections.get(id) : undefined;
  }

  /** The focused widget, whether the page's focus is on the mirror or on the canvas. @returns {Reflection | undefined} */
  get current() {
    return this.at(document.activeElement) ?? this.all.find(({ widget }) => widget.state.focused);
  }

  /** The name of the open panel. */
  get #panel() { return this.#parts.get('panel')?.getAttribute('aria-label'); }
  /** @returns {Reflection[]} */
  get all() { return [...this.#reflections.values()]; }
  /** The stops of the Tab key. @returns {Reflection[]} */
  get stops() { return this.all.filter(({ node }) => node.tabIndex === 0); }
  /** The group in which arrows move from this widget. @param {Reflection} reflection @returns {Reflection[]} empty: there is none */
  group({ node }) {
    const parent = node.parentElement;
    return ROVING.has(parent?.getAttribute('role') ?? '')
      ? this.all.filter(({ node: other, widget }) => other.parentElement === parent && takesKeyboard(widget)) : [];
  }

  /** Call after a person's action on the canvas, to update soon. */
  acted() {
    this.#actedMs = performance.now();
    this.#updateSoon();
  }

  /** Makes the elements equal to the canvas's widgets. */
  update() {
    const state = this.app.mirror();
    if (!state) return this.#follow();
    this.#keyboard = state.keyboard;
    this.#waiting = state.waiting;
    const active = this.at(document.activeElement);
    const before = this.stops;
    const panel = this.#panel;
    this.#arrange(state.parts, state.widgets.filter(isMirrored));
    if (active && !active.node.isConnected) {
      // If another panel was opened, focus its tab, which has its name.
      const tab = panel === this.#panel ? undefined
        : this.all.find(({ widget }) => widget.role === 'tab' && widget.state.selected);
      if (tab) this.focus(tab);
      else this.#restoreFocus(active, before);
    }
    this.#rove();
    this.#follow();
    if (this.#waiting) this.#updateSoon();
  }

  #updateSoon() {
    if (this.#updatePlanned) return;
    this.#updatePlanned = true;
    // Two frames, because the application may draw the first one after the first callback.
    requestAnimationFrame(() => requestAnimationFrame(() => {
      this.#updatePlanned = false;
      this.update();
    }));
  }

  /** @param {MirrorPart[]} parts @param {MirrorWidget[]} widgets */
  #arrange(parts, widgets) {
    const byPerson = performance.now() - this.#actedMs < ACTION_MS || !this.app.playing();
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
      update(node, widget, byPerson || node !== document.activeElement);
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

  /** Gives each group one stop: the focused element, else the selected one, else the first. */
  #rove() {
    for (const { node, widget } of this.#reflections.values()) {
      if (!takesKeyboard(widget) || isBesideNumber(widget, (id) => this.#reflections.get(id)?.widget)) {
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

  /** If the application has moved its focus by itself, moves the page's focus to the same widget. */
  #follow() {
    if (this.#waiting || !this.#keyboard) return;
    const here = this.at(document.activeElement);
    if (!here && document.activeElement !== this.canvas) return;
    // If the canvas loses the focus while a key is held, SDL never receives its release.
    if (this.#keysDown.size > 0) return;
    // A window in the background receives no focus events.
    if (here && here.widget.id !== this.#focusedId) return this.#focusMoved(here);
    const there = this.all.find(({ widget }) => widget.state.focused);
    // A text field that is open on the canvas receives its keys there.
    if (!there || there === here || there.widget.role === 'textbox' || !takesKeyboard(there.widget)) return;
    this.#focusedId = there.widget.id;
    this.focus(there);
  }

  /**
   * After the focused element was removed, focuses a new widget at its place, or the previous stop.
   * @param {Reflection} removed @param {Reflection[]} before  the stops before the removal
   */
  #restoreFocus({ widget: { id, rect } }, before) {
    const x = rect.x + Math.min(8, rect.width / 2);
    const y = rect.y + rect.height / 2;
    const known = new Set(before.map(({ widget }) => widget.id));
    const after = this.all.filter(({ widget }) => takesKeyboard(widget));
    const far = (/** @type {Reflection} */ { widget }) => distance(widget.rect, x, y);
    const successor = after.filter((one) => !known.has(one.widget.id) && far(one) < NEAR).sort((a, b) => far(a) - far(b))[0]
      ?? before.slice(0, before.findIndex(({ widget }) => widget.id === id)).reverse()
        .map(({ widget }) => this.#reflections.get(widget.id)).find((one) => one && takesKeyboard(one.widget)) ?? after[0];
    if (!successor) return;
    const chosen = this.group(successor).find(({ widget: { state } }) => state.selected || state.checked);
    this.focus(known.has(successor.widget.id) && chosen ? chosen : successor);
  }

  /** @param {Reflection} reflection */
  focus({ node }) { node.focus({ preventScroll: true }); }

  /** Moves the focus to the next stop after the focused widget. @param {number} direction @returns {boolean} false: there are no more stops */
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
    if (widget.id !== this.#focusedId) this.#focusMoved(reflection);
  }

  /** Moves the application's focus to the widget that has received the page's focus. @param {Reflection} reflection */
  #focusMoved({ node, widget }) {
    this.#focusedId = widget.id;
    this.#waiting = true; // the last state does not include this change
    this.app.focus(widget.id, node.matches(':focus-visible'));
    this.#updateSoon();
  }

  /** @param {MouseEvent} event */
  #clicked(event) {
    this.update(); // what was disabled at the last one may be possible now
    // An assistive tool may press a button without taking the focus from a number.
    const typing = this.at(this.#root.querySelector('.typing'));
    if (typing && typing.node !== event.target) this.commit(typing);
    const reflection = this.at(event.target);
    if (!reflection || reflection.node instanceof HTMLInputElement || !takesKeyboard(reflection.widget)) return;
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

  /** Begins the typing of a number. A slider becomes a text field. @param {Reflection} reflection */
  type({ node }) {
    this.update(); // as in #clicked
    const widget = this.at(node)?.widget;
    if (!(node instanceof HTMLInputElement) || !widget?.range || widget.state.disabled) return;
    node.classList.add('typing');
    if (widget.role === 'slider') {
      node.type = 'text';
      node.inputMode = 'decimal';
      node.value = fixedText(widget.range.now);
      node.setAttribute('role', 'spinbutton');
      update(node, widget, true);
    }
    node.select();
  }

  /** @param {Reflection} reflection @param {number} value @param {boolean} [again]  repeated by a held key */
  set({ widget }, value, again = false) {
    if (!Number.isFinite(value)) return;
    this.app.setValue(widget.id, value, again);
    this.acted();
  }

  /** Ends the typing of a number. @param {Reflection} reflection @param {boolean} [apply]  false: restores the old number */
  commit({ node, widget }, apply = true) {
    if (!(node instanceof HTMLInputElement)) return;
    const value = numberOf(node.value);
    node.classList.remove('typing');
    if (widget.role === 'slider') {
      for (const name of ['role', 'aria-valuemin', 'aria-valuemax', 'aria-valuenow']) node.removeAttribute(name);
      node.type = 'range';
      update(node, widget, true);
    }
    if (apply && Number.isFinite(value)) this.set({ node, widget }, value);
    else if (widget.role !== 'slider') node.value = widget.value;
  }
}

/**
 * Makes these the children, in this order. Moves neither what is already in order nor what has the focus, because a moved
 * element loses it.
 * @param {HTMLElement} parent @param {HTMLElement[]} wanted
 */
function placeChildren(parent, wanted) {
  const wantedSet = new Set(wanted);
  for (const child of [...parent.children]) {
    if (child instanceof HTMLElement && !wantedSet.has(child)) child.remove();
  }
  const focused = wanted.findIndex((node) => node.parentElement === parent && node.contains(document.activeElement));
  let at = parent.firstElementChild;
  wanted.forEach((node, i) => {
    if (i === focused) at = node; // what is still before it comes later
    if (node === at) at = at.nextElementSibling;
    else parent.insertBefore(node, at);
  });
}

/** @param {MirrorWidget['rect']} rect @param {number} x @param {number} y */
const distance = (rect, x, y) => Math.hypot(Math.max(rect.x - x, 0, x - rect.x - rect.width), Math.max(rect.y - y, 0, y - rect.y - rect.height));
