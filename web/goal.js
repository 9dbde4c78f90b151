// SPDX-License-Identifier: MIT
// A goal: what the motion shown has to be, such as "distance >= 8, rotations >= 1, sense = physical". A row under the
// header says how far it is, and ticks what is reached.
import { announce } from './announcer.js';
import { element } from './dom.js';
import { fixed, tr } from './language.js';

/** @typedef {import('./app.js').App} App */
/** @typedef {import('./app.js').Measures} Measures */
/** @typedef {'>=' | '<=' | '>' | '<' | '='} Relation */
/** @typedef {{name: string, relation: Relation, wanted: number | string}} Condition  wanted: a text of the sense alone */

const TERMS = ['distance', 'travel', 'max_cm_height', 'slip_sum', 'rotations', 'effort', 'upright', 'smoothness', 'head_height'];
const SENSES = { physical: 'physical senses', timer: 'timer', network: 'network' };
const MOST = 6;

/** @param {string} text @returns {Condition[]} throws an Error that says what is wrong */
export function parseGoal(text) {
  const parts = text.split(',').map((part) => part.trim()).filter((part) => part !== '');
  if (parts.length === 0 || parts.length > MOST) throw new Error(tr('goal: give one to {1} conditions, with commas between them', MOST));
  return parts.map((part) => {
    const [, name, relation, value] = /^([a-z_]+)\s*(>=|<=|>|<|=)\s*(\S+)$/.exec(part) ?? [];
    const number = Number(value);
    const known = name === 'sense' ? relation === '=' && Object.hasOwn(SENSES, value)
      : (TERMS.includes(name) || name === 'rules') && Number.isFinite(number);
    if (!known) throw new Error(tr('goal: “{1}” is no condition, such as distance >= 8 or sense = physical', part));
    return { name, relation: /** @type {Relation} */ (relation), wanted: name === 'sense' ? value : number };
  });
}

/** @param {Condition} condition @param {Measures} measures */
export function isMet({ name, relation, wanted }, measures) {
  if (measures.broke) return false;
  if (name === 'sense') return measures.sense === wanted;
  const has = name === 'rules' ? measures.rules : measures.terms.find((term) => term.name === name)?.value ?? NaN;
  const than = Number(wanted);
  switch (relation) {
    case '>=': return has >= than;
    case '<=': return has <= than;
    case '>': return has > than;
    case '<': return has < than;
    default: return has === than;
  }
}

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
    this.conditions = parseGoal(text);
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
  const { label, unit, decimals, value } = /** @type {import('./app.js').Measure} */ (measures.terms.find((term) => term.name === name));
  const amount = (/** @type {number} */ number, /** @type {number} */ places) => `${fixed(number, places)}${unit && ` ${unit}`}`;
  // What is nearly enough does not read as enough.
  const cut = relation.startsWith('>') ? Math.floor : relation.startsWith('<') ? Math.ceil : Math.round;
  const shown = value === null ? null : cut(value * 10 ** decimals) / 10 ** decimals;
  const places = Math.min(decimals, (String(wanted).split('.')[1] ?? '').length);
  return tr('{1} {2} {3} (now {4})', label, sign, amount(Number(wanted), places), shown === null ? '–' : amount(shown, decimals));
}
