// SPDX-License-Identifier: MIT
// Grows the children of a round, in workers of its own.
import { SCORE_LENGTH } from '../search/engine.js';
import { SearchClient } from '../search/search_client.js';
import { createWorker, hasWorkers } from '../search/compiled_engine.js';

/** @typedef {import('../search/engine.js').Litter} Litter */
/** A child, or a founder. @typedef {{genome: Uint16Array, fitness: number, traits: Float32Array}} Child */

const MAX_WORKERS = 8;
const STYLE_NUMBERS = 3; // of a score, between fitness and traits

export class Nursery {
  /** @type {{resolve: (children: Child[]) => void, reject: (error: Error) => void} | null} */
  #settle = null;
  #client;

  /**
   * @param {WebAssembly.Module} engine
   * @param {(tries: number, budget: number) => void} progress
   */
  constructor(engine, progress) {
    this.#client = new SearchClient({
      engine,
      createWorker,
      listener: {
        progress: (report, litter) => {
          progress(report.evaluations, report.budget);
          if (report.state === 'done') this.#end((settle) => settle.resolve(litter ? childrenOf(litter) : []));
          if (report.state === 'stopped') this.#end((settle) => settle.reject(new Error('stopped')));
        },
        incident: () => {},
        failed: (error) => this.#end((settle) => settle.reject(error)),
      },
    });
  }

  /**
   * Ends what grows already.
   * @param {Uint8Array} nursery  a document of core/breeding/litter.h
   * @returns {Promise<Child[]>} rejected if the workers fail, or if another litter is begun before
   */
  grow(nursery) {
    this.#end((settle) => settle.reject(new Error('replaced')));
    return new Promise((resolve, reject) => {
      this.#settle = { resolve, reject };
      this.#client.start(nursery, hasWorkers ? Math.min(navigator.hardwareConcurrency || 2, MAX_WORKERS) : 1, true);
    });
  }

  close() {
    this.#client.close();
    this.#end((settle) => settle.reject(new Error('closed')));
  }

  /** @param {(settle: {resolve: (children: Child[]) => void, reject: (error: Error) => void}) => void} use */
  #end(use) {
    const settle = this.#settle;
    this.#settle = null;
    if (settle) use(settle);
  }
}

/** @param {Litter} litter @returns {Child[]} */
function childrenOf({ genomes, scores }) {
  const count = scores.length / SCORE_LENGTH;
  const genes = genomes.length / count;
  return Array.from({ length: count }, (_, i) => ({
    genome: genomes.slice(i * genes, (i + 1) * genes),
    fitness: scores[i * SCORE_LENGTH],
    traits: scores.slice(i * SCORE_LENGTH + 1 + STYLE_NUMBERS, (i + 1) * SCORE_LENGTH),
  }));
}
