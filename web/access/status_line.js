// SPDX-License-Identifier: MIT
// The footer: how far the search is, or the last thing worth knowing. What changes thirty times a second is for the
// eye only; screen readers get a sentence now and then.
import { announce } from '../browser/announcer.js';
import { element, setText } from '../browser/dom.js';
import { fixed, grouped, tr } from '../languages/language.js';

/** @typedef {import('../search/messages.js').SearchReport} SearchReport */
/** What the line says about a search besides its report. @typedef {{doing: (paused: boolean) => string, unit: string, workers: number}} SearchWords */

const SPEAK_EVERY_MS = 10000;
const SENTENCE_STAYS_MS = 6000;

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
  #saidMs = -Infinity;

  /** What stands there while there is nothing to tell. @param {string} sentence */
  welcome(sentence) {
    if (this.#status.textContent === '') setText(this.#status, sentence);
  }

  /** Shows a sentence, also over the beginning of a search's line. @param {string} sentence */
  say(sentence) {
    setText(this.#status, sentence);
    announce(sentence);
    this.#saidMs = sentence ? performance.now() : -Infinity;
  }

  /** @param {SearchReport} report @param {SearchWords} words */
  show(report, { doing, unit, workers }) {
    const now = performance.now();
    const ended = report.state === 'done' || report.state === 'stopped';
    const best = Number.isFinite(report.bestFitness) && report.bestFitness > -1e8
      ? fixed(report.bestFitness, 2) + unit : '';
    const count = tr('{1} of {2}', grouped(report.evaluations), grouped(report.budget));
    if (ended) {
      this.clear();
      this.#speaking = '';
      const after = grouped(report.evaluations);
      const end = report.state === 'done'
        ? best ? tr('Search done: best {1} after {2} evaluations', best, after) : tr('Search done: nothing found after {1} evaluations', after)
        : best ? tr('Search stopped: best {1} after {2} evaluations', best, after) : tr('Search stopped: nothing found after {1} evaluations', after);
      if (!this.#status.textContent?.startsWith(end)) announce(end); // the application may have said it
      setText(this.#status, end);
      return;
    }
    const paused = report.state === 'paused';
    const sentence = doing(paused);
    if (now < this.#saidMs || now - this.#saidMs > SENTENCE_STAYS_MS) setText(this.#status, sentence); // the clock may have been set back
    this.#progress.hidden = false;
    this.#progress.setAttribute('aria-valuemax', String(report.budget));
    this.#progress.setAttribute('aria-valuenow', String(report.evaluations));
    this.#bar.style.transform = `scaleX(${report.evaluations / Math.max(1, report.budget)})`;
    setText(this.#count, count);
    setText(this.#rate, paused || report.rate === 0 ? '' :
      workers === 1 ? tr('{1}/s on 1 worker', grouped(report.rate)) : tr('{1}/s on {2} workers', grouped(report.rate), workers));
    setText(this.#best, best && tr('best {1}', best));
    setText(this.#left, paused || report.rate === 0 ? '' : timeLeft(report.secondsLeft));
    if (sentence !== this.#speaking) {
      this.#speaking = sentence;
      this.#spokenMs = now;
      announce(sentence);
    } else if (!paused && now - this.#spokenMs > SPEAK_EVERY_MS) {
      this.#spokenMs = now;
      const [done, all] = [grouped(report.evaluations), grouped(report.budget)];
      announce(best ? tr('{1} of {2} evaluations, best {3}', done, all, best) : tr('{1} of {2} evaluations, nothing found yet', done, all));
    }
  }

  /** No search: only the sentence remains. */
  clear() {
    this.#progress.hidden = true;
    this.#saidMs = -Infinity;
    for (const node of [this.#count, this.#rate, this.#best, this.#left]) setText(node, '');
  }
}

/** @param {number} seconds */
function timeLeft(seconds) {
  return seconds < 100 ? tr('{1} s left', Math.ceil(seconds)) : tr('{1} min left', grouped(Math.ceil(seconds / 60)));
}
