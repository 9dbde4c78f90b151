// SPDX-License-Identifier: MIT
// The planner for JavaScript: carries out a document's plan and reports on the way. Works in a worker and under Node.
import createPlanner from './planner_module.js';

/** @typedef {import('./planner_module.js').PlannerModule} PlannerModule */
/** @typedef {import('./planner_module.js').PlannerOptions['reported']} Reported */

/**
 * How a plan is getting on: core/planning/planning.h.
 * @typedef {object} Progress
 * @property {'relaxing' | 'coarse' | 'fine' | 'played' | 'refused'} stage  the last is 'played' or 'refused'
 * @property {Uint8Array} document    with the motion in its plan, in binary form; of a refused plan empty
 * @property {number} iterations      of the solver since the beginning
 * @property {number} cost            of the motion
 * @property {number} playedMiss      m
 * @property {number} firstMiss       m
 * @property {number} corrections
 * @property {Float64Array} misses    four numbers for each: kind, index, which and amount of a PlanMiss
 */

export class Planner {
  #module;
  /** @type {(progress: Progress) => void} */
  #listener = () => {};

  /** @param {WebAssembly.Module} compiled  planner_module.wasm @returns {Promise<Planner>} */
  static load(compiled) {
    return new Promise((resolve, reject) => {
      /** @type {Planner} */
      let planner;
      createPlanner({
        reported: (...report) => planner.#report(...report),
        instantiateWasm(imports, receive) {
          // Report the error ourselves: Emscripten waits for `receive` forever if there is no memory left, for example.
          WebAssembly.instantiate(compiled, imports).then((instance) => receive(instance, compiled)).catch(reject);
          return {};
        },
      }).then((module) => resolve(planner = new Planner(module)), reject);
    });
  }

  /** @param {PlannerModule} module */
  constructor(module) {
    this.#module = module;
  }

  /**
   * Returns when the plan is carried out, or refused.
   * @param {Uint8Array} document  binary form
   * @param {(progress: Progress) => void} listener  at most 25 motions a second that relax, and every other stage
   * @returns {boolean} false: core refuses the document, or it cannot be planned
   */
  carryOut(document, listener) {
    this.#listener = listener;
    const at = this.#module._gs_input(document.length); // may grow the memory: read HEAPU8 afterwards
    this.#module.HEAPU8.set(document, at);
    return Boolean(this.#module._gs_plan(document.length));
  }

  /** @type {Reported} */
  #report(stage, letters, document, bytes, iterations, cost, playedMiss, firstMiss, corrections, misses, count) {
    const copy = (/** @type {number} */ at, /** @type {number} */ length) => this.#module.HEAPU8.slice(at, at + length);
    this.#listener({
      stage: /** @type {Progress['stage']} */ (new TextDecoder().decode(copy(stage, letters))),
      document: copy(document, bytes), iterations, cost, playedMiss, firstMiss, corrections,
      misses: new Float64Array(copy(misses, 8 * count).buffer),
    });
  }
}
