// SPDX-License-Identifier: MIT
// The goal that the shown motion has to reach (goal_conditions.js). A row under the header shows the progress and ticks
// the conditions that are met.
import { announce } from '../browser/announcer.js';
import { element } from '../browser/dom.js';
import { control_modes, terms } from '../catalogue/catalogue.js';
import { faultOfGoal, isMet, parseGoal } from './goal_conditions.js';
import { fixed, tr } from '../languages/language.js';

/** @typedef {import('../app/app.js').App} App */
/** @typedef {import('../app/app.js').Measures} Measures */
/** @typedef {import('./goal_conditions.js').Condition} Condition */

/** Why a text is no goal, or ''. @param {string} text */
export const goalFault = (text) => faultOfGoal(text, { control_modes, terms });

export class GoalBar {
  #row = element('goal');
  #list = element('goal-list');
  #open = true;
  /** The state in the last event. */
  #reported = '';
  #met = false;

  /** @param {App} app @param {import('./api.js').Gaitsmith} gaitsmith  dispatches the events @param {string} text */
  constructor(app, gaitsmith, text) {
    this.app = app;
    this.gaitsmith = gaitsmith;
    this.text = text;
    this.conditions = parseGoal(text, { control_modes, terms });
  }

  show() {
    this.#row.hidden = false;
    this.update();
  }

  close() {
    this.#open = false;
    this.#row.hidden = true;
  }

  /** Call when the motion or the language may have changed. */
  update() {
    if (!this.#open) return;
    const measures = this.app.measures();
    const met = this.conditions.map((condition) => isMet(condition, measures));
    const all = !met.includes(false);
    this.#row.classList.toggle('met', all);
    this.#list.replaceChildren(...this.conditions.map((condition, i) => {
      const item = document.createElement('li');
      // On a phone a guard is shown only when it fails.
      const guard = condition.name === 'world' || condition.wanted === 'opened';
      item.className = met[i] ? `met${guard ? ' guard' : ''}` : '';
      const mark = document.createElement('span');
      mark.className = 'mark';
      mark.setAttribute('role', 'img');
      mark.setAttribute('aria-label', met[i] ? tr('reached') : tr('not yet'));
      item.append(mark, ` ${conditionText(condition, measures)}`);
      return item;
    }));
    const state = JSON.stringify([met, measures]);
    if (state === this.#reported) return;
    this.#reported = state;
    if (all && !this.#met) announce(tr('The goal is reached.'));
    this.#met = all;
    this.gaitsmith.dispatchEvent(new CustomEvent('goal', { detail: { goal: this.text, met: all, measures: this.gaitsmith.measures() } }));
  }
}

/** "Distance ≥ 8 m (now 5.21 m)" @param {Condition} condition @param {Measures} measures */
function conditionText({ name, relation, wanted }, measures) {
  if (name === 'sense') return tr('decided by {1}', tr(control_modes.find((mode) => mode.name === wanted)?.words ?? ''));
  if (name === 'world') return wanted === 'earth' ? tr('on level ground on Earth') : tr('in the usual world');
  if (name === 'controller') return wanted === 'new' ? tr('found here by your own search') : tr('only with rules that were opened');
  const sign = { '>=': '≥', '<=': '≤', '!=': '≠' }[/** @type {string} */ (relation)] ?? relation;
  if (name === 'rules') return tr('{1} {2} {3} (now {4})', tr('Rules'), sign, wanted, measures.rules);
  const { label, unit, decimals, value } = /** @type {import('../app/app.js').Measure} */ (measures.terms.find((term) => term.name === name));
  const amount = (/** @type {number} */ number, /** @type {number} */ places) => `${fixed(number, places)}${unit && ` ${unit}`}`;
  // Rounds away from the goal, so that a motion that just misses it does not seem to reach it.
  const round = relation.startsWith('>') ? Math.floor : relation.startsWith('<') ? Math.ceil : Math.round;
  const shown = value === null ? null : round(value * 10 ** decimals) / 10 ** decimals;
  const places = Math.min(decimals, (String(wanted).split('.')[1] ?? '').length);
  return tr('{1} {2} {3} (now {4})', label, sign, amount(Number(wanted), places), shown === null ? '–' : amount(shown, decimals));
}
