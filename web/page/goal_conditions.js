// SPDX-License-Identifier: MIT
// What a goal asks of a motion, such as "distance >= 8, rotations >= 1, sense = physical": read from text and compared
// with what was measured. The book reads the goals of its lessons here, too.
import { tr } from '../languages/language.js';

/** @typedef {import('../app/app.js').Measures} Measures */
/** @typedef {'>=' | '<=' | '>' | '<' | '='} Relation */
/** @typedef {{name: string, relation: Relation, wanted: number | string}} Condition  wanted: a text of the sense alone */

/** Of the centre of mass, either way and to the right. */
const WAYS = ['distance', 'travel'];
export const SENSES = { physical: 'physical senses', timer: 'timer', network: 'network' };
const MOST = 6;

/**
 * @param {string} text
 * @param {readonly {readonly name: string}[]} terms  of the catalogue, which only the built site has
 * @returns {Condition[]} throws an Error that says what is wrong
 */
export function parseGoal(text, terms) {
  const numbers = [...WAYS, ...terms.map(({ name }) => name), 'rules'];
  const parts = text.split(',').map((part) => part.trim()).filter((part) => part !== '');
  if (parts.length === 0 || parts.length > MOST) throw new Error(tr('goal: give one to {1} conditions, with commas between them', MOST));
  return parts.map((part) => {
    const [, name, relation, value] = /^([a-z_]+)\s*(>=|<=|>|<|=)\s*(\S+)$/.exec(part) ?? [];
    const number = Number(value);
    const known = name === 'sense' ? relation === '=' && Object.hasOwn(SENSES, value)
      : numbers.includes(name) && Number.isFinite(number);
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
