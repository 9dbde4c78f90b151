// SPDX-License-Identifier: MIT
// The footer: how far the search is, or the last thing worth knowing. What changes thirty times a second is for the
// eye only; screen readers get a sentence now and then.
import { announce } from './announcer.js';
import { element, setText } from './dom.js';

/** @typedef {import('./messages.js').SearchReport} SearchReport */
/** What the line says about a search besides its report. @typedef {{doing: string, unit: string, workers: number}} SearchWords */

const SPEAK_EVERY_MS = 10000;
const SENTENCE_STAYS_MS = 6000;

// "40,000". Intl's formats take 40 ms to make.
const whole = (/** @type {number} */ value) => String(Math.round(value)).replace(/\B(?=(\d{3})+$)/g, ',');

export class StatusLine {
  #status = element('status');
  #progress = element('progress');
  #bar = /** @type {HTMLElement} */ (element('progress').firstElementChild);
  #count = element('count');
  #rate = element('rate');
  #best = element('best');
  #left = element('left');
  #spokenMs = 0;
  /** What was said of the search that runs. */
  #speaking = '';
  #sentenceUntilMs = 0;

  /** What stands there while there is nothing to tell. @param {string} sentence */
  welcome(sentence) {
    if (this.#status.textContent === '') setText(this.#status, sentence);
  }

  /** Shows a sentence, also over the beginning of a search's line. @param {string} sentence */
  say(sentence) {
    setText(this.#status, sentence);
    announce(sentence);
    this.#sentenceUntilMs = sentence ? performance.now() + SENTENCE_STAYS_MS : 0;
  }

  /** @param {SearchReport} report @param {SearchWords} words */
  show(report, { doing, unit, workers }) {
    const now = performance.now();
    const ended = report.state === 'done' || report.state === 'stopped';
    const best = Number.isFinite(report.bestFitness) && report.bestFitness > -1e8
      ? `best ${report.bestFitness.toFixed(2)}${unit}` : '';
    const count = `${whole(report.evaluations)} of ${whole(report.budget)}`;
    if (ended) {
      this.clear();
      this.#speaking = '';
      const end = `${report.state === 'done' ? 'Search done' : 'Search stopped'}: ${best || 'nothing found'} after ${
        whole(report.evaluations)} evaluations`;
      if (!this.#status.textContent?.startsWith(end)) announce(end); // the application may have said it
      setText(this.#status, end);
      return;
    }
    const paused = report.state === 'paused';
    const sentence = paused ? `Paused: ${doing[0].toLowerCase()}${doing.slice(1)}` : doing;
    if (now > this.#sentenceUntilMs) setText(this.#status, sentence);
    this.#progress.hidden = false;
    this.#progress.setAttribute('aria-valuemax', String(report.budget));
    this.#progress.setAttribute('aria-valuenow', String(report.evaluations));
    this.#bar.style.transform = `scaleX(${report.evaluations / Math.max(1, report.budget)})`;
    setText(this.#count, count);
    setText(this.#rate, paused || report.rate === 0 ? '' :
      `${whole(report.rate)}/s on ${workers} worker${workers === 1 ? '' : 's'}`);
    setText(this.#best, best);
    setText(this.#left, paused || report.rate === 0 ? '' : timeLeft(report.secondsLeft));
    if (sentence !== this.#speaking) {
      this.#speaking = sentence;
      this.#spokenMs = now;
      announce(sentence);
    } else if (!paused && now - this.#spokenMs > SPEAK_EVERY_MS) {
      this.#spokenMs = now;
      announce(`${count} evaluations, ${best || 'nothing found yet'}`);
    }
  }

  /** No search: only the sentence remains. */
  clear() {
    this.#progress.hidden = true;
    this.#sentenceUntilMs = 0;
    for (const node of [this.#count, this.#rate, this.#best, this.#left]) setText(node, '');
  }
}

/** @param {number} seconds */
function timeLeft(seconds) {
  return seconds < 100 ? `${Math.ceil(seconds)} s left` : `${Math.ceil(seconds / 60)} min left`;
}
