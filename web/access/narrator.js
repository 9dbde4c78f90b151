// SPDX-License-Identifier: MIT
// Describes the motion in words. The description is up to date while the motion is paused, and on request. A short
// sentence is announced when the motion is paused or stepped, but not while it plays, because that would never end.
import { announce } from '../browser/announcer.js';
import { element, onClick, setText } from '../browser/dom.js';
import { followLanguage } from '../languages/language.js';

/** @typedef {import('../app/app.js').App} App */

const UPDATE_MS = 250;
// Steps by a held key are announced when it is released.
const REST_MS = 500;

export class Narrator {
  #description = element('description');
  #announced = '';
  #lastMoment = '';
  #sinceMs = 0;

  /** @param {App} app */
  constructor(app) {
    this.app = app;
    onClick('describe', () => {
      this.#describe();
      announce(this.#description.textContent ?? '');
    });
    setInterval(() => { if (!document.hidden) this.#update(); }, UPDATE_MS);
    followLanguage(() => this.#describe());
  }

  #update() {
    if (this.app.playing()) {
      this.#announced = '';
      this.#lastMoment = '';
      return;
    }
    const moment = this.app.moment();
    if (moment !== this.#lastMoment) {
      this.#lastMoment = moment;
      this.#sinceMs = performance.now();
    }
    this.#describe(); // may change although the moment does not
    if (performance.now() - this.#sinceMs < REST_MS || moment === this.#announced) return;
    const before = this.#announced;
    this.#announced = moment;
    // An edit changes the distance, which is announced only on request.
    if (timeOf(before) !== timeOf(moment)) announce(this.#newWords(before, moment));
  }

  /** Omits the time on the time slider, which announces its own value. @param {string} before @param {string} moment */
  #newWords(before, moment) {
    if (document.activeElement?.getAttribute('data-id') !== 'transport/scrub') return moment;
    return ruleOf(before) === ruleOf(moment) ? '' : ruleOf(moment);
  }

  #describe() { setText(this.#description, this.app.description()); }
}

// In every language the time comes first, and the rule has its own sentence.

/** "Paused at 2.31 s" @param {string} moment */
const timeOf = (moment) => moment.split(', ')[0];
/** "Rule 3 acts." @param {string} moment */
const ruleOf = (moment) => /\. (.*)$/.exec(moment)?.[1] ?? '';
