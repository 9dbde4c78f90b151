// SPDX-License-Identifier: MIT
// A tour of the playground in six steps, for those who ask for it. It does not cover what it describes, and blocks nothing.
// Escape ends it.
import { element, onClick, setText } from '../browser/dom.js';
import { followLanguage, tr, trLater } from '../languages/language.js';

/** @typedef {import('../app/app.js').App} App */
/** @typedef {{left: number, top: number, right: number, bottom: number}} Box */
/** @typedef {{title: string, text: string, at: RegExp | string, panel?: string}} Step  at: a widget's id, or an element's selector */

const MARGIN = 12;

/** @type {Step[]} */
const STEPS = [
  { title: trLater('Nobody animated this'), at: /^stage$/,
    text: trLater('The computer finds how a figure moves. Letters mark where it was, arrows show the forces of the ground. Click to pause or play.') },
  { title: trLater('Let it find another'), at: /^search\/start$/, panel: 'panel/Search',
    text: trLater('Synthesize searches for a better motion while you watch: the curve shows the best so far.') },
  { title: trLater('A clock, or senses'), at: /^controller\/senses/, panel: 'panel/Controller',
    text: trLater('What decides when to move: a timer, like a wind-up toy, or what the figure feels. The next search uses your choice.') },
  { title: trLater('Why it moves this way'), at: /^controller\/why$/, panel: 'panel/Controller',
    text: trLater('It has only a few rules. The active one lights up, and this explains why. Open a rule to change it by hand.') },
  { title: trLater('Push it'), at: /^world\/open$/,
    text: trLater('Pull at the figure on the stage and let go, or tilt the ground under World. Does it recover? Undo takes everything back.') },
  { title: trLater('Share it'), at: '#copy-link',
    text: trLater('The link holds the whole motion. Friends who open it see the same motion, bit for bit, and can continue from there.') },
];

/** @type {Tour | null} */
let only = null;

/** @param {App} app @param {HTMLCanvasElement} canvas */
export function startTour(app, canvas) {
  only ??= new Tour(app, canvas);
  only.start();
}

class Tour {
  #card = element('tour');
  #mark = element('tour-mark');
  #next = element('tour-next', HTMLButtonElement);
  #step = -1;
  /** @type {HTMLElement | null} */
  #focusBefore = null;

  /** @param {App} app @param {HTMLCanvasElement} canvas */
  constructor(app, canvas) {
    this.app = app;
    this.canvas = canvas;
    onClick('tour-next', () => this.#go(this.#step + 1));
    onClick('tour-back', () => this.#go(this.#step - 1));
    onClick('tour-skip', () => this.end());
    this.#card.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape') return;
      event.stopPropagation();
      this.end();
    });
    addEventListener('resize', () => this.#place());
    // The subject moves when panels scroll or change their length.
    setInterval(() => this.#place(), 250);
    followLanguage(() => this.#write());
  }

  get open() { return this.#step >= 0; }

  start() {
    this.#focusBefore = document.activeElement instanceof HTMLElement ? document.activeElement : null;
    this.#go(0);
    this.#next.focus({ preventScroll: true });
  }

  end() {
    if (!this.open) return;
    const hadFocus = this.#card.contains(document.activeElement);
    this.#step = -1;
    this.#card.hidden = this.#mark.hidden = true;
    if (hadFocus) (this.#focusBefore?.isConnected ? this.#focusBefore : element('home')).focus({ preventScroll: true });
  }

  /** @param {number} step */
  #go(step) {
    if (step >= STEPS.length) return this.end();
    this.#step = Math.max(0, step);
    const { panel } = STEPS[this.#step];
    if (panel) this.app.run(panel);
    this.#write();
    element('tour-back', HTMLButtonElement).disabled = this.#step === 0;
    this.#card.hidden = false;
    // The application draws the panel first.
    requestAnimationFrame(() => requestAnimationFrame(() => this.#place()));
  }

  #write() {
    if (!this.open) return;
    const { title, text } = STEPS[this.#step];
    setText(element('tour-title'), tr(title));
    setText(element('tour-text'), tr(text));
    setText(element('tour-count'), tr('{1} of {2}', this.#step + 1, STEPS.length));
    setText(this.#next, this.#step === STEPS.length - 1 ? tr('Done') : tr('Next'));
  }

  /** @returns {Box | null} the part of the page that the step describes [CSS pixels] */
  #subject() {
    const { at } = STEPS[this.#step];
    if (typeof at === 'string') return document.querySelector(at)?.getBoundingClientRect() ?? null;
    const all = this.app.widgets().filter(({ id }) => at.test(id));
    if (all.length === 0) return null;
    const { left, top } = this.canvas.getBoundingClientRect();
    return {
      left: left + Math.min(...all.map(({ rect }) => rect.x)),
      top: top + Math.min(...all.map(({ rect }) => rect.y)),
      right: left + Math.max(...all.map(({ rect }) => rect.x + rect.width)),
      bottom: top + Math.max(...all.map(({ rect }) => rect.y + rect.height)),
    };
  }

  /** Puts the card beside its subject, within the window. */
  #place() {
    if (!this.open) return;
    const subject = this.#subject();
    this.#mark.hidden = !subject;
    const { offsetWidth: width, offsetHeight: height } = this.#card;
    const [across, down] = [innerWidth, innerHeight];
    let [x, y] = [(across - width) / 2, down - height - 40];
    if (subject) {
      const { left, top, right, bottom } = subject;
      setBox(this.#mark, left - 4, top - 4, right - left + 8, bottom - top + 8);
      const middle = clamp((left + right - width) / 2, across - width);
      const level = clamp((top + bottom - height) / 2, down - height);
      /** @type {[number, number][]} */
      const places = [[left - width - MARGIN, level], [middle, bottom + MARGIN], [middle, top - height - MARGIN], [right + MARGIN, level]];
      // If there is no room beside the subject, as for the stage: in its upper right corner.
      [x, y] = places.find(([px, py]) => px >= MARGIN && py >= MARGIN && px + width <= across - MARGIN && py + height <= down - MARGIN)
        ?? [clamp(right - width - MARGIN, across - width), clamp(top + 64, down - height)];
    }
    this.#card.style.left = `${Math.round(x)}px`;
    this.#card.style.top = `${Math.round(y)}px`;
  }
}

/** @param {number} value @param {number} max */
const clamp = (value, max) => Math.max(MARGIN, Math.min(value, max - MARGIN));

/** @param {HTMLElement} node @param {number} x @param {number} y @param {number} width @param {number} height */
function setBox(node, x, y, width, height) {
  Object.assign(node.style, { left: `${x}px`, top: `${y}px`, width: `${width}px`, height: `${height}px` });
}
