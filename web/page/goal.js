// SPDX-License-Identifier: MIT
// A goal: what the motion shown has to be (goal_conditions.js). A row under the header says how far it is,
// and ticks what is reached.
import { announce } from '../browser/announcer.js';
import { element } from '../browser/dom.js';
import { terms } from '../catalogue/catalogue.js';
import { SENSES, isMet, parseGoal } from './goal_conditions.js';
import { fixed, tr } from '../languages/language.js';

/** @typedef {import('../app/app.js').App} App */
/** @typedef {import('../app/app.js').Measures} Measures */
/** @typedef {import('./goal_conditions.js').Condition} Condition */

export class GoalBar {
  #row = element('goal');
  #list = element('goal-list');
  #open = true;
  /** As it was told last. */
  #told = '';
  #met = false;

  /** @param {App} app @param {import('./api.js').Gaitsmith} told  hears of it @param {string} text */
  constructor(app, told, text) {
    this.app = app;
    this.told = told;
    this.text = text;
    this.conditions = parseGoal(text, terms);
  }

  show() {
    this.#row.hidden = false;
    this.look();
  }

  close() {
    this.#open = false;
    this.#row.hidden = true;
  }

  /** The motion may be another one. */
  look() {
    if (!this.#open) return;
    const measures = this.app.measures();
    const met = this.conditions.map((condition) => isMet(condition, measures));
    const all = !met.includes(false);
    this.#row.classList.toggle('met', all);
    this.#list.replaceChildren(...this.conditions.map((condition, i) => {
      const item = document.createElement('li');
      item.className = met[i] ? 'met' : '';
      const mark = document.createElement('span');
      mark.className = 'mark';
      mark.setAttribute('role', 'img');
      mark.setAttribute('aria-label', met[i] ? tr('reached') : tr('not yet'));
      item.append(mark, ` ${words(condition, measures)}`);
      return item;
    }));
    const news = JSON.stringify([met, measures]);
    if (news === this.#told) return;
    this.#told = news;
    if (all && !this.#met) announce(tr('The goal is reached.'));
    this.#met = all;
    this.told.dispatchEvent(new CustomEvent('goal', { detail: { goal: this.text, met: all, measures: this.told.measures() } }));
  }
}

/** "Distance ≥ 8 m (now 5.21 m)" @param {Condition} condition @param {Measures} measures */
function words({ name, relation, wanted }, measures) {
  if (name === 'sense') return tr('decided by {1}', tr(SENSES[/** @type {keyof typeof SENSES} */ (wanted)]));
  const sign = { '>=': '≥', '<=': '≤' }[/** @type {string} */ (relation)] ?? relation;
  if (name === 'rules') return tr('{1} {2} {3} (now {4})', tr('Rules'), sign, wanted, measures.rules);
  const { label, unit, decimals, value } = /** @type {import('../app/app.js').Measure} */ (measures.terms.find((term) => term.name === name));
  const amount = (/** @type {number} */ number, /** @type {number} */ places) => `${fixed(number, places)}${unit && ` ${unit}`}`;
  // What is nearly enough does not read as enough.
  const cut = relation.startsWith('>') ? Math.floor : relation.startsWith('<') ? Math.ceil : Math.round;
  const shown = value === null ? null : cut(value * 10 ** decimals) / 10 ** decimals;
  const places = Math.min(decimals, (String(wanted).split('.')[1] ?? '').length);
  return tr('{1} {2} {3} (now {4})', label, sign, amount(Number(wanted), places), shown === null ? '–' : amount(shown, decimals));
}
