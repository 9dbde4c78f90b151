// SPDX-License-Identifier: MIT
// The main controls and a description of the motion as plain DOM, for people who cannot see or point at the canvas,
// hidden from view until the keyboard reaches it.
import { banner, element, onClick, setText } from './dom.js';

/** @typedef {import('./app.js').App} App */

const FOLLOW_MS = 100;

export class Controls {
  #radios = /** @type {HTMLInputElement[]} */ ([...document.querySelectorAll('input[name=senses]')]);
  #play = element('control-play');
  #synthesize = element('control-synthesize', HTMLButtonElement);
  #stop = element('control-stop', HTMLButtonElement);
  #description = element('description');
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #follow;

  /** @param {App} app */
  constructor(app) {
    this.app = app;
    onClick('control-play', () => app.play(this.#play.textContent === 'Play'));
    onClick('control-synthesize', () => this.#start());
    onClick('control-stop', () => app.stop());
    onClick('control-describe', () => setText(this.#description, this.#describe()));
    // What the canvas shows changes without a word to the page, but nobody needs it here more often than this.
    setInterval(() => this.#update(), 1000);
    for (const radio of this.#radios) {
      radio.addEventListener('change', () => app.setSenses(/** @type {'timer' | 'physical' | 'network'} */ (radio.value)));
    }
    this.documentChanged();
  }

  documentChanged() {
    // A drag changes it at every frame, and reading the whole document takes some milliseconds.
    this.#follow ??= setTimeout(() => {
      this.#follow = undefined;
      const { kind: controller, senses } = this.app.document();
      const kind = controller === 'network' ? controller : senses?.kind ?? 'physical';
      for (const radio of this.#radios) radio.checked = radio.value === kind;
    }, FOLLOW_MS);
  }

  /** @param {boolean} searching */
  searching(searching) {
    this.#synthesize.disabled = searching;
    this.#stop.disabled = !searching;
  }

  #start() {
    const fault = this.app.synthesize({});
    if (fault) banner(fault);
  }

  #update() {
    if (document.hidden) return;
    const widgets = this.app.widgets();
    const label = widgets.find(({ id }) => id === 'transport/play')?.label;
    if (label) setText(this.#play, label);
    // While it plays, a running commentary would never stop.
    if (label === 'Play') setText(this.#description, this.#describe(widgets));
  }

  #describe(widgets = this.app.widgets()) {
    const stage = widgets.find(({ id }) => id === 'stage');
    const rule = widgets.find(({ id, state }) => id.startsWith('controller/rule/') && state.selected);
    const network = widgets.find(({ id }) => id === 'controller/network');
    const figure = this.app.document().figure.name || 'The figure';
    const where = stage ? `has travelled ${stage.value}` : 'is on the stage';
    const decides = rule ? ` Active rule: ${rule.label}.` : network ? ` ${network.label}, ${network.value}.` : '';
    return `${figure} ${where}.${decides} ${this.app.score()}`;
  }
}
