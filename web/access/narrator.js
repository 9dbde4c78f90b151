// SPDX-License-Identifier: MIT
// Tells the motion in words: its description, kept up to date while the motion is paused and whenever asked for, and a
// short sentence when it is paused or stepped. Never while it plays, for that would not end.
import { announce } from '../browser/announcer.js';
import { element, onClick, setText } from '../browser/dom.js';
import { followLanguage } from '../languages/language.js';

/** @typedef {import('../app/app.js').App} App */

const LOOK_EVERY_MS = 250;
// Steps by a held key are announced when it is released.
const REST_MS = 500;

export class Narrator {
  #description = element('description');
  #told = '';
  #seen = '';
  #sinceMs = 0;

  /** @param {App} app */
  constructor(app) {
    this.app = app;
    onClick('describe', () => {
      this.#describe();
      announce(this.#description.textContent ?? '');
    });
    setInterval(() => { if (!document.hidden) this.#look(); }, LOOK_EVERY_MS);
    followLanguage(() => this.#describe());
  }

  #look() {
    if (this.app.playing()) {
      this.#told = '';
      this.#seen = '';
      return;
    }
    const moment = this.app.moment();
    if (moment !== this.#seen) {
      this.#seen = moment;
      this.#sinceMs = performance.now();
    }
    this.#describe(); // what stands beside may change while the moment does not
    if (performance.now() - this.#sinceMs < REST_MS || moment === this.#told) return;
    const before = this.#told;
    this.#told = moment;
    // An edit changes the distance, which is announced only on request.
    if (timeOf(before) !== timeOf(moment)) announce(this.#unheard(before, moment));
  }

  /** A slider says its own value, the time. @param {string} before @param {string} moment */
  #unheard(before, moment) {
    if (document.activeElement?.getAttribute('data-id') !== 'transport/scrub') return moment;
    return ruleOf(before) === ruleOf(moment) ? '' : ruleOf(moment);
  }

  #describe() { setText(this.#description, this.app.description()); }
}

// In other languages, too, the time comes first, and the rule has a sentence of its own.

/** "Paused at 2.31 s" @param {string} moment */
const timeOf = (moment) => moment.split(', ')[0];
/** "Rule 3 acts." @param {string} moment */
const ruleOf = (moment) => /\. (.*)$/.exec(moment)?.[1] ?? '';
