// SPDX-License-Identifier: MIT
// Reports an assignment to a learning system, if it comes in a SCORM package (?scorm). The score is the part of the
// goal's conditions that were met at once. What is kept for the next visit is the motion and the sentences.
import { element, setText } from '../browser/dom.js';
import { control_modes, terms } from '../catalogue/catalogue.js';
import { tr } from '../languages/language.js';
import { findApi } from '../share/scorm.js';
import { decodeWork, emptyWork, encodeWork } from '../share/work.js';
import { isMet, parseGoal } from './goal_conditions.js';

/** @typedef {import('../app/app.js').App} App */
/** @typedef {import('../share/scorm.js').Learning} Learning */

const REST_MS = 1000;
const SHORT_TEXT = 1000; // characters, where the motion has no room either

export class AssignmentReport {
  /** What the learner wrote. */
  text = '';
  #best = 0;
  /** Payload of the motion that has reached the goal last; '': none has. */
  #motion = '';
  /** The last report. */
  #reported = '';
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #timer;
  #line = document.createElement('p');

  /** @param {App} app @param {import('./api.js').Gaitsmith} gaitsmith  dispatches 'goal' and 'changed' @param {string} goal */
  constructor(app, gaitsmith, goal) {
    this.app = app;
    this.gaitsmith = gaitsmith;
    this.conditions = parseGoal(goal, { control_modes, terms });
    this.#line.id = 'task-report';
    this.#line.setAttribute('role', 'status');
    element('task').append(this.#line);
  }

  /** Begins a visit, and opens what the learning system has kept. */
  begin() {
    const system = findApi();
    if (!system) return this.#say(tr('No learning system was found around this page. The assignment works, and nothing will be reported.'));
    try {
      // Before the visit ends, which the system's own listener does.
      addEventListener('pagehide', () => this.#report(system));
      const kept = system.begin();
      if (kept) this.#restore(kept);
    } catch (error) {
      return this.#say(tr('The learning system refuses this assignment: {1}', reason(error)));
    }
    for (const event of /** @type {const} */ (['goal', 'changed'])) this.gaitsmith.addEventListener(event, () => this.#soon(system));
    this.onText = () => this.#soon(system);
    this.#report(system);
  }

  /** Call when the text has changed. */
  onText = () => {};

  /** A search changes the motion often. @param {Learning} system */
  #soon(system) {
    this.#judge();
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.#report(system), REST_MS);
  }

  #judge() {
    const measures = this.app.measures();
    const met = this.conditions.filter((condition) => isMet(condition, measures)).length;
    this.#best = Math.max(this.#best, Math.floor((100 * met) / this.conditions.length));
    if (met === this.conditions.length) this.#motion = this.app.link();
  }

  /** @param {Learning} system */
  #report(system) {
    this.#judge();
    const work = { ...emptyWork(), text: this.text, motion: this.#motion || this.app.link() };
    const stateOf = (/** @type {import('../share/work.js').Work} */ one) => `${encodeWork(one)}.${this.#best}`;
    const whole = stateOf(work), fits = system.holds(whole);
    const state = fits ? whole : stateOf({ ...work, motion: '', text: work.text.slice(0, SHORT_TEXT) });
    if (state === this.#reported) return;
    try {
      const reached = this.#best === 100;
      system.report({ reached, score: this.#best, state });
      this.#reported = state;
      const words = reached ? tr('Reported to the learning system: {1} of 100, passed.', this.#best) : tr('Reported to the learning system: {1} of 100.', this.#best);
      this.#say([words, fits ? '' : tr('The motion is too long for it to be kept. Hand it in as a link.')].join(' ').trim());
    } catch (error) {
      this.#say(tr('The learning system refuses the report: {1}', reason(error)));
    }
  }

  /** @param {string} state */
  #restore(state) {
    const [, link = '', best = ''] = /^(.*)\.(\d{1,3})$/s.exec(state) ?? [];
    try {
      const { text, motion } = decodeWork(link);
      if (motion) this.gaitsmith.open(motion);
      this.text = text;
      this.#best = Math.min(100, Number(best));
      if (this.#best === 100) this.#motion = motion;
    } catch {
      // A state of another version is no reason not to work.
    }
  }

  /** @param {string} sentence */
  #say(sentence) { setText(this.#line, sentence); }
}

/** @param {unknown} error */
const reason = (error) => (error instanceof Error ? error.message : String(error));
