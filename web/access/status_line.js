// SPDX-License-Identifier: MIT
// The footer: the progress of the search, or the latest message. The progress changes thirty times a second, so screen
// readers get only a sentence from time to time.
import { announce } from '../browser/announcer.js';
import { element, setText } from '../browser/dom.js';
import { fixed, grouped, tr } from '../languages/language.js';

/** @typedef {import('../search/messages.js').SearchReport} SearchReport */
/** What the line shows beside a search's report. @typedef {{doing: (paused: boolean) => string, unit: string, workers: number}} SearchWords */

const ANNOUNCE_EVERY_MS = 10000;
const SENTENCE_STAYS_MS = 6000;

export class StatusLine {
  #status = element('status');
  #progress = element('progress');
  #bar = /** @type {HTMLElement} */ (element('progress').firstElementChild);
  #count = element('count');
  #rate = element('rate');
  #best = element('best');
  #left = element('left');
  #announcedMs = 0;
  /** The last announced sentence about the running search. */
  #announced = '';
  /** What the running search does; empty: none runs. */
  #doing = '';
  #sentenceMs = -Infinity;

  /** Shows and announces a sentence. It replaces a search's own sentence for a few seconds. @param {string} sentence  empty: clears the line */
  say(sentence) {
    setText(this.#status, sentence || this.#doing);
    announce(sentence);
    this.#sentenceMs = sentence ? performance.now() : -Infinity;
  }

  /** @param {SearchReport} report @param {SearchWords} words */
  show(report, { doing, unit, workers }) {
    const now = performance.now();
    const ended = report.state === 'done' || report.state === 'stopped';
    const best = Number.isFinite(report.bestFitness) && report.bestFitness > -1e8
      ? fixed(report.bestFitness, 2) + unit : '';
    const count = tr('{1} of {2}', grouped(report.evaluations), grouped(report.budget));
    if (ended) {
      // The application reports the end. It does not if the search's document was replaced.
      if (this.#status.textContent === this.#doing) setText(this.#status, '');
      this.clear();
      return;
    }
    const paused = report.state === 'paused';
    const sentence = this.#doing = doing(paused);
    if (now < this.#sentenceMs || now - this.#sentenceMs > SENTENCE_STAYS_MS) setText(this.#status, sentence); // the clock may have been set back
    this.#progress.hidden = false;
    this.#progress.setAttribute('aria-valuemax', String(report.budget));
    this.#progress.setAttribute('aria-valuenow', String(report.evaluations));
    this.#bar.style.transform = `scaleX(${report.evaluations / Math.max(1, report.budget)})`;
    setText(this.#count, count);
    setText(this.#rate, paused || report.rate === 0 ? ''
      : workers === 1 ? tr('{1}/s on 1 worker', grouped(report.rate)) : tr('{1}/s on {2} workers', grouped(report.rate), workers));
    setText(this.#best, best && tr('best {1}', best));
    setText(this.#left, paused || report.rate === 0 ? '' : timeLeft(report.secondsLeft));
    if (sentence !== this.#announced) {
      this.#announced = sentence;
      this.#announcedMs = now;
      announce(sentence);
    } else if (!paused && now - this.#announcedMs > ANNOUNCE_EVERY_MS) {
      this.#announcedMs = now;
      const [done, all] = [grouped(report.evaluations), grouped(report.budget)];
      announce(best ? tr('{1} of {2} evaluations, best {3}', done, all, best) : tr('{1} of {2} evaluations, nothing found yet', done, all));
    }
  }

  /** Shows that no search runs: only the sentence remains. */
  clear() {
    this.#progress.hidden = true;
    this.#announced = this.#doing = '';
    this.#sentenceMs = -Infinity;
    for (const node of [this.#count, this.#rate, this.#best, this.#left]) setText(node, '');
  }
}

/** @param {number} seconds */
function timeLeft(seconds) {
  return seconds < 100 ? tr('{1} s left', Math.ceil(seconds)) : tr('{1} min left', grouped(Math.ceil(seconds / 60)));
}
