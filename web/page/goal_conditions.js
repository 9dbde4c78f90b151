// SPDX-License-Identifier: MIT
// The conditions of a goal, such as "distance >= 8, rotations >= 1, sense = physical": reads them from text and
// compares them with a motion's measures. The book's build also uses this file, to check the goals of lessons.
import { tr } from '../languages/language.js';

/** @typedef {import('../app/app.js').Measures} Measures */
/** @typedef {'>=' | '<=' | '>' | '<' | '='} Relation */
/** @typedef {{name: string, relation: Relation, wanted: number | string}} Condition  wanted: a string only for the sense */

/** @typedef {{readonly terms: readonly {readonly name: string}[], readonly control_modes: readonly {readonly name: string}[]}} Tables */

/** Distances of the centre of mass: in either direction, and to the right. */
const DISTANCES = ['distance', 'travel'];
const MAX_CONDITIONS = 6;

/**
 * @param {string} text
 * @param {Tables} tables  the catalogue's; a parameter, because only the built site has it
 * @returns {Condition[]} throws an Error with a sentence if the text is invalid
 */
export function parseGoal(text, { terms, control_modes: modes }) {
  const numbers = [...DISTANCES, ...terms.map(({ name }) => name), 'rules'];
  const parts = text.split(',').map((part) => part.trim()).filter((part) => part !== '');
  if (parts.length === 0 || parts.length > MAX_CONDITIONS) throw new Error(tr('goal: give one to {1} conditions, with commas between them', MAX_CONDITIONS));
  return parts.map((part) => {
    const [, name, relation, value] = /^([a-z_]+)\s*(>=|<=|>|<|=)\s*(\S+)$/.exec(part) ?? [];
    const number = Number(value);
    const known = name === 'sense' ? relation === '=' && modes.some((mode) => mode.name === value)
      : numbers.includes(name) && Number.isFinite(number);
    if (!known) throw new Error(tr('goal: “{1}” is not a condition. Examples: distance >= 8, sense = physical', part));
    return { name, relation: /** @type {Relation} */ (relation), wanted: name === 'sense' ? value : number };
  });
}

/** @param {Condition} condition @param {Measures} measures */
export function isMet({ name, relation, wanted }, measures) {
  if (measures.broke) return false;
  if (name === 'sense') return measures.sense === wanted;
  const measured = name === 'rules' ? measures.rules : measures.terms.find((term) => term.name === name)?.value ?? NaN;
  const limit = Number(wanted);
  switch (relation) {
    case '>=': return measured >= limit;
    case '<=': return measured <= limit;
    case '>': return measured > limit;
    case '<': return measured < limit;
    default: return measured === limit;
  }
}
