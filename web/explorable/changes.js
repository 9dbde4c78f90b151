// SPDX-License-Identifier: MIT
// What the explorable changes in a document, and the motions that come of it. Everything is a document as JSON; the engine
// does the physics.

/** @typedef {import('../search/engine.js').Engine} Engine */
/** A document as JSON. @typedef {any} Json */

/** The document without its recorded hash: it is about to change. @param {Json} json @returns {Json} */
const open = (json) => ({ ...structuredClone(json), hash: undefined });

/** Keeps only these rules of the first controller. @param {Json} json @param {number[]} kept  from 0 */
export function withRules(json, kept) {
  const changed = open(json);
  changed.controllers[0].rules = changed.controllers[0].rules.filter((/** @type {unknown} */ _, /** @type {number} */ i) => kept.includes(i));
  return changed;
}

/** Changes how quickly a rule's pose is taken up. @param {Json} json @param {number} rule @param {number} gene  0 (quick) to 65535 */
export function withTau(json, rule, gene) {
  const changed = open(json);
  changed.controllers[0].rules[rule].tau = Math.round(gene);
  return changed;
}

/** @param {Json} json @param {number} gravity  [m/s²] */
export function withGravity(json, gravity) {
  const changed = open(json);
  changed.environment.gravity_mps2 = gravity;
  return changed;
}

/** @param {Json} json @param {number} degrees  uphill to the right */
export function withSlope(json, degrees) {
  const changed = open(json);
  changed.environment.slope_rad = (degrees * Math.PI) / 180;
  return changed;
}

/** One push on the body. @param {Json} json @param {number} seconds @param {number} impulse  to the right [N s]; 0: no push */
export function withPush(json, seconds, impulse) {
  const changed = open(json);
  changed.pushes = impulse === 0 ? [] : [{ step: Math.round(seconds * 100), endpoint: -1, impulse_x_ns: impulse, impulse_y_ns: 0 }];
  return changed;
}

/** @param {Json} json @param {number} rod @param {number} metres */
export function withLength(json, rod, metres) {
  const changed = open(json);
  changed.figure.rods[rod].length_m = metres;
  return changed;
}

/** The same task for another search. @param {Json} json @param {{algorithm: string, seed: number, evaluations: number, weights?: Record<string, number>, task?: object}} search */
export function searched(json, { weights, task, ...search }) {
  const changed = open(json);
  changed.search = { ...changed.search, ...search };
  changed.task = { ...changed.task, ...task, weights: { ...changed.task.weights, ...weights } };
  return changed;
}

/** A search that goes on in small pieces and remembers every improvement. */
export class Climb {
  /** Each improvement: number of tries until then, score and genome. @type {{tries: number, score: number, genome: Uint16Array}[]} */
  history = [];

  /** @param {Engine} engine @param {Json} json  with the search that is wanted */
  constructor(engine, json) {
    this.engine = engine;
    this.document = engine.documentFromText(JSON.stringify(json));
    this.search = engine.search(this.document);
  }

  get tries() { return this.search.evaluations; }
  get done() { return this.search.done; }
  get budget() { return this.search.budget; }

  /** @param {number} ms  time to search [ms] */
  goOn(ms) {
    const end = performance.now() + ms;
    while (!this.search.done && performance.now() < end) this.step();
  }

  /** A few tries. */
  step() {
    this.search.ask(8);
    this.search.scoreHere();
    const score = this.search.bestFitness;
    if (score > (this.history.at(-1)?.score ?? -Infinity)) this.history.push({ tries: this.search.evaluations, score, genome: this.search.bestGenome });
  }

  /** A document with the best motion found within this number of tries. @param {number} [tries] @returns {Uint8Array | null} null: none is found yet */
  best(tries = Infinity) {
    const found = this.history.filter((each) => each.tries <= tries).at(-1) ?? this.history[0];
    return found ? this.engine.shown(this.document, found.genome) : null;
  }

  close() { this.search.close(); }
}

/** The motion of random rules: the first that a search which only guesses would try. @param {Engine} engine @param {Json} json @param {number} seed */
export function random(engine, json, seed) {
  const climb = new Climb(engine, searched(json, { algorithm: 'rgt', seed, evaluations: 8 }));
  climb.search.ask(1);
  const genes = engine.module._gs_search_genomes(climb.search.handle);
  const genome = new Uint16Array(engine.bytesAt(genes, 2 * climb.search.genes).buffer);
  climb.close();
  return engine.shown(climb.document, genome);
}

/** @param {import('../search/engine.js').RecordedMotion} motion @param {string} name  of a term, or 'travel' */
export const measured = (motion, name) => motion.measures().terms.find((term) => term.name === name)?.value ?? NaN;
