// SPDX-License-Identifier: MIT
// The conditions of a goal, such as "distance >= 8, rotations >= 1, sense = physical": reads them from text and
// compares them with a motion's measures. The book's build also uses this file, to check the goals of lessons.
import { tr } from '../languages/language.js';

/** @typedef {import('../app/app.js').Measures} Measures */
/** @typedef {'>=' | '<=' | '>' | '<' | '=' | '!='} Relation */
/** @typedef {'sense' | 'controller' | 'world'} WordName */
/** @typedef {{name: string, relation: Relation, wanted: number | string}} Condition  wanted: a string only for a WordName */

/** @typedef {{readonly terms: readonly {readonly name: string}[], readonly control_modes: readonly {readonly name: string}[]}} Tables */

/** Numbers that are not terms of the style (docs/embedding.md). */
const NUMBERS = ['distance', 'travel', 'rules', 'seed', 'pushes', 'push_right', 'push_time', 'switch', 'generations', 'strength'];
const MAX_CONDITIONS = 6;

/**
 * @param {string} text
 * @param {Tables} tables  the catalogue's; a parameter, because only the built site has it
 * @returns {Condition[]} throws an Error with a sentence if the text is invalid
 */
export function parseGoal(text, { terms, control_modes: modes }) {
  const numbers = [...NUMBERS, ...terms.map(({ name }) => name)];
  /** @type {Record<string, string[]>} */
  const words = { sense: modes.map(({ name }) => name), controller: ['opened', 'new'], world: ['usual', 'earth'] };
  const parts = text.split(',').map((part) => part.trim()).filter((part) => part !== '');
  if (parts.length === 0 || parts.length > MAX_CONDITIONS) throw new Error(tr('goal: give one to {1} conditions, with commas between them', MAX_CONDITIONS));
  return parts.map((part) => {
    const [, name, relation, value] = /^([a-z_]+)\s*(>=|<=|!=|>|<|=)\s*(\S+)$/.exec(part) ?? [];
    const number = Number(value);
    const isWord = Object.hasOwn(words, name);
    const known = isWord ? relation === '=' && words[name].includes(value) : numbers.includes(name) && Number.isFinite(number);
    if (!known) throw new Error(tr('goal: “{1}” is not a condition. Examples: distance >= 8, sense = physical', part));
    return { name, relation: /** @type {Relation} */ (relation), wanted: isWord ? value : number };
  });
}

/** Why a text is no goal, or ''. @param {string} text @param {Tables} tables */
export function faultOfGoal(text, tables) {
  try {
    parseGoal(text, tables);
    return '';
  } catch (error) {
    return /** @type {Error} */ (error).message;
  }
}

/** @param {Condition} condition @param {Measures} measures */
export function isMet({ name, relation, wanted }, measures) {
  if (measures.broke) return false;
  // On earth means: usual, but joints may be limited.
  if (wanted === 'earth' && measures.world === 'usual') return true;
  if (typeof wanted === 'string') return measures[/** @type {WordName} */ (name)] === wanted;
  // A number that the motion does not have meets nothing, also not "!=".
  const measured = name === 'rules' ? measures.rules : measures.terms.find((term) => term.name === name)?.value ?? null;
  if (measured === null) return false;
  switch (relation) {
    case '>=': return measured >= wanted;
    case '<=': return measured <= wanted;
    case '>': return measured > wanted;
    case '<': return measured < wanted;
    case '!=': return measured !== wanted;
    default: return measured === wanted;
  }
}
