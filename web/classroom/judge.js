// SPDX-License-Identifier: MIT
// Simulates what was handed in and compares it with its lesson. Nothing that a link claims is believed, except what a
// student wrote and chose.
import { fixedText, tr, trLater, trSentence } from '../languages/language.js';
import { isMet, parseGoal } from '../page/goal_conditions.js';

/** @typedef {import('../search/engine.js').Engine} Engine */
/** @typedef {import('../search/engine.js').RecordedMotion} RecordedMotion */
/** @typedef {import('../page/goal_conditions.js').Condition} Condition */
/** @typedef {import('../page/goal_conditions.js').Tables} Tables */
/** @typedef {import('./collected.js').Entry} Entry */
/** A choice (answers) or a slider (unit). right: its number; none in a prediction. @typedef {{question: string, answers: string[], unit?: string, right?: number}} Question */
/**
 * A lesson as the book's build writes it. worlds: of the documents that it opens, as of worldOf(); figures: their figures, as JSON.
 * @typedef {{name: string, title: string, goals: string[], predictions: Question[], quizzes: Question[], worlds: string[][], figures: string[]}} LessonFacts
 */
/** @typedef {{question: string, given: string, right: boolean | null}} Answer  right: null in a prediction or if there is no answer */
/** met: null: it cannot be judged by the motion. @typedef {{text: string, met: boolean | null}} Judged */
/**
 * @typedef {object} Row
 * @property {string} name
 * @property {string} lesson       its title
 * @property {string} fault        why there is no motion; '': there is one, or none was handed in
 * @property {RecordedMotion | null} motion
 * @property {string} link         payload of the motion
 * @property {Judged[]} conditions
 * @property {boolean | null} met  null: there was no goal, or no motion
 * @property {string[]} changed    what differs from what the lesson opens
 * @property {string} hash
 * @property {Answer[]} predictions
 * @property {Answer[]} answers
 * @property {string} text
 */

/** Conditions about the way to a motion, which only the page where it was made knows. */
const UNSEEN = ['controller', 'seed', 'generations'];
const STEP_S = 0.01;
/** The physical models whose joints are as strong as needed, and limited, and what a rod's strength is that is not written (core/physics/figure.h). */
const STRONG_MODEL = 1, LIMITED_MODEL = 2, STANDARD_STRENGTH = 2;
/** What worldOf() says of usual changes. Other fields of a document have their own names. */
[trLater('slope {1}°'), trLater('drawn ground with {1} corners'), trLater('gravity {1} m/s²'), trLater('friction {1}'), trLater('no pushes'), trLater('{1} push'), trLater('{1} pushes'), trLater('velocity x {1}'), trLater('velocity y {1}'), trLater('joint strength {1}')].forEach(String);
const SIGNS = { '>=': '≥', '<=': '≤', '>': '>', '<': '<', '=': '=', '!=': '≠' };

/** The world of a document in words, such as ["slope 2°", "friction 0.8", "1 push"]. Limited joints belong to it. @param {any} document  JSON @returns {string[]} */
export function worldOf({ model = STRONG_MODEL, figure = { rods: [] }, environment = {}, start = {}, pushes = [] }) {
  const words = Object.entries({ ...environment, ...start }).map(([name, value]) => {
    if (name === 'slope_rad') return `slope ${rounded((Number(value) * 180) / Math.PI)}°`;
    if (name === 'ground') return `drawn ground with ${/** @type {any[]} */ (value).length} corners`;
    if (name === 'gravity_mps2') return `gravity ${rounded(Number(value))} m/s²`;
    return `${name.replace(/_(mps|radps|m|rad)$/, '').replaceAll('_', ' ')} ${typeof value === 'number' ? rounded(value) : JSON.stringify(value)}`;
  });
  const joints = model !== LIMITED_MODEL ? [] : [...new Set(jointsOf(figure).map(({ strength = STANDARD_STRENGTH }) => `joint strength ${rounded(strength)}`))];
  return [...words, ...joints, pushes.length === 1 ? '1 push' : `${pushes.length === 0 ? 'no' : pushes.length} pushes`];
}

/** Without the joints' strength, which belongs to the world. @param {any} document  JSON */
export const figureOf = ({ figure }) => JSON.stringify([figure.rods, figure.nodes, figure.springs], (name, value) => (name === 'strength' || name === 'stiffness' ? undefined : value));

/** The rods that have a joint: all but the root. @param {any} figure  JSON @returns {{strength?: number}[]} */
const jointsOf = ({ rods = [] }) => rods.filter((/** @type {{parent?: number}} */ { parent = -1 }) => parent >= 0);

/** Without limits of the joints. Figures of springs have none. @param {any} document  JSON */
const unlimited = (document) => (document.model === LIMITED_MODEL ? { ...document, model: STRONG_MODEL } : document);

export class Judge {
  /** @param {Engine} engine @param {Tables} tables @param {LessonFacts[]} lessons */
  constructor(engine, tables, lessons) {
    this.engine = engine;
    this.tables = tables;
    this.lessons = lessons;
  }

  /** @param {Entry} entry @param {string} goal  for motions without a lesson @returns {Row} */
  judge(entry, goal) {
    /** @type {Row} */
    const row = { name: '', lesson: '', fault: '', motion: null, link: '', conditions: [], met: null, changed: [], hash: '', predictions: [], answers: [], text: '' };
    if (entry.fault !== undefined) return { ...row, name: entry.source, fault: entry.fault };
    const { work } = entry;
    const facts = this.lessons.find(({ name }) => name === work.lesson);
    row.name = work.name;
    row.text = work.text;
    row.lesson = facts?.title ?? work.lesson;
    if (facts) {
      row.predictions = facts.predictions.map((question, i) => answered(question, work.predictions[i] ?? null));
      row.answers = facts.quizzes.map((question, i) => answered(question, work.answers[i] ?? null));
    }
    const text = entry.document ?? work.motion;
    if (text === '') return row;
    try {
      this.#simulate(row, text, facts, facts ? facts.goals : [goal].filter(Boolean));
    } catch (error) {
      row.fault = trSentence(error instanceof Error ? error.message : String(error));
    }
    return row;
  }

  /** @param {Row} row @param {string} text  link or JSON @param {LessonFacts | undefined} facts @param {string[]} goals */
  #simulate(row, text, facts, goals) {
    const bytes = this.engine.documentFromText(text);
    const document = /** @type {any} */ (this.engine.json(bytes));
    row.link = this.engine.link(bytes);
    row.motion = this.engine.motion(bytes);
    const measured = row.motion.measures();
    row.hash = measured.hash;
    const usualWorld = worldOf(this.engine.json(this.engine.documentFromText(JSON.stringify({ ...unlimited(document), environment: undefined, start: undefined, pushes: undefined }))));
    const measures = { ...measured, ...ofDocument(document), world: sameWorld(document, usualWorld) ? 'usual' : sameWorld(unlimited(document), usualWorld) ? 'earth' : 'other' };
    measures.terms = [...measured.terms, ...measures.numbers];
    row.conditions = goals.flatMap((each) => parseGoal(each, this.tables)).map((condition) => judged(condition, measures));
    const seen = row.conditions.filter(({ met }) => met !== null);
    row.met = seen.length === 0 ? null : seen.every(({ met }) => met);
    const world = worldOf(document);
    const changes = (facts?.worlds ?? [usualWorld]).map((known) => world.filter((part) => !known.includes(part))).sort((one, other) => one.length - other.length);
    row.changed.push(...(changes[0] ?? []).map(trSentence));
    if (facts && !facts.figures.includes(figureOf(document))) row.changed.push(tr('another figure'));
  }
}

/** @param {Question} question @param {number | null} given @returns {Answer} */
function answered({ question, answers, unit, right }, given) {
  const words = given === null ? '' : unit === undefined ? answers[given] ?? '' : `${given} ${unit}`.trim();
  return { question, given: words, right: right === undefined || words === '' ? null : given === right };
}

/** What goals ask of a document. @param {any} document  JSON */
function ofDocument({ model = STRONG_MODEL, figure = { rods: [] }, controllers = [], timeline = [], pushes = [] }) {
  const controller = controllers[timeline[0]?.controller ?? -1];
  const push = pushes.length === 1 ? pushes[0] : null;
  return {
    rules: controller?.rules?.length ?? 0,
    sense: controller === undefined ? '' : controller.kind === 'network' ? 'network' : controller.senses?.kind ?? 'physical',
    numbers: [
      { name: 'pushes', value: pushes.length }, { name: 'push_right', value: push && push.impulse_x_ns }, { name: 'push_time', value: push && push.step * STEP_S },
      { name: 'switch', value: timeline.length > 1 ? timeline.at(-1).start_step * STEP_S : null },
      { name: 'strength', value: model !== LIMITED_MODEL ? null : Math.max(0, ...jointsOf(figure).map(({ strength = STANDARD_STRENGTH }) => strength)) },
    ],
  };
}

/** But for pushes, which have a condition of their own. @param {any} document  JSON @param {string[]} usual  worldOf() */
const sameWorld = (document, usual) => worldOf({ ...document, pushes: [] }).every((part) => usual.includes(part));

/** @param {Condition} condition @param {any} measures @returns {Judged} */
function judged(condition, measures) {
  const { name, relation, wanted } = condition;
  if (UNSEEN.includes(name)) return { text: tr('{1}: not seen in a motion', `${name} ${SIGNS[relation]} ${wanted}`), met: null };
  const value = measures[name] ?? measures.terms.find((/** @type {{name: string}} */ term) => term.name === name)?.value;
  const shown = typeof value === 'number' ? fixedText(Math.round(value * 100) / 100) : value ?? '–';
  return { text: `${name} ${shown} (${SIGNS[relation]} ${wanted})`, met: isMet(condition, measures) };
}

/** @param {number} value */
const rounded = (value) => String(Math.round(value * 100) / 100);
