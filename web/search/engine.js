// SPDX-License-Identifier: MIT
// The engine for JavaScript: documents, evaluators and searches as objects, errors as exceptions. Works in a
// page, in a worker and under Node.
import createEngine from './engine_module.js';
import { BODY_LENGTH, RecordedMotion } from './recorded_motion.js';

export { BODY_LENGTH, RecordedMotion };

/** @typedef {import('./engine_module.js').EngineModule} EngineModule */
/** An error of core and its place. @typedef {{code: string, where: string, what: string}} Fault */

/**
 * The fitness of a population's members that have a motion, if there are at least two.
 * @typedef {{members: number, least: number, lowerQuartile: number, median: number, upperQuartile: number, best: number}} Spread
 */

/** An error of core as an exception, with core's sentence as its message. */
export class EngineError extends Error {
  /** @param {Fault} fault */
  constructor(fault) {
    super(fault.where ? `${fault.where}: ${fault.what}` : fault.what);
    this.name = 'EngineError';
    this.fault = fault;
  }
}

export class Engine {
  /** @param {EngineModule} module */
  constructor(module) {
    this.module = module;
  }

  /**
   * @param {WebAssembly.Module} [compiled]  a module compiled before, e.g. by the page; else engine_module.wasm is
   * fetched
   * @param {typeof createEngine} [create]  of another build of the engine
   * @returns {Promise<Engine>}
   */
  static async load(compiled, create = createEngine) {
    if (!compiled) return new Engine(await create());
    return new Engine(await new Promise((resolve, reject) => {
      createEngine({
        instantiateWasm(imports, receive) {
          // Report the error ourselves: Emscripten waits for `receive` forever if there is no memory left, for example.
          WebAssembly.instantiate(compiled, imports).then((instance) => receive(instance, compiled)).catch(reject);
          return {};
        },
      }).then(resolve, reject);
    }));
  }

  /** Bytes of WebAssembly memory in use. */
  get memoryBytes() { return this.module.HEAPU8.length; }

  /**
   * The binary form of a document, which evaluators and searches need.
   * @param {string} text  JSON, or a link
   */
  documentFromText(text) {
    return this.#document(this.module._gs_document_from_text(this.put(new TextEncoder().encode(text))));
  }

  /** A document as JSON. @param {Uint8Array} document @returns {object} */
  json(document) { return JSON.parse(this.textAt(this.orThrow(this.module._gs_document_json(this.put(document))))); }

  /** The payload of a document's link. @param {Uint8Array} document */
  link(document) { return this.textAt(this.orThrow(this.module._gs_document_link(this.put(document)))); }

  /** @param {Uint8Array} document @param {boolean} [traits]  whether they are measured, too @returns {Evaluator} */
  evaluator(document, traits = false) {
    return new Evaluator(this, this.orThrow(this.module._gs_evaluator_open(this.put(document), traits ? 1 : 0)));
  }

  /** @param {Uint8Array} document @returns {Search} */
  search(document) {
    return new Search(this, this.orThrow(this.module._gs_search_open(this.put(document))));
  }

  /** A search for the children of a nursery. @param {Uint8Array} nursery @returns {Search} */
  brood(nursery) {
    return new Search(this, this.orThrow(this.module._gs_brood_open(this.put(nursery))));
  }

  /**
   * The document in which the children of a round of a lineage are bred.
   * @param {Uint8Array} document @param {number} round
   * @param {Uint16Array[]} litter  children of the round's parent, in their order
   */
  nursery(document, round, litter) {
    return this.#document(this.module._gs_nursery(this.#putWithGenomes(document, litter), round));
  }

  /** A document that shows a child. @param {Uint8Array} document  with a lineage @param {Uint16Array} genome */
  child(document, genome) {
    return this.#document(this.module._gs_child(this.#putWithGenomes(document, [genome])));
  }

  /** A document that shows a genome of its search. @param {Uint8Array} document @param {Uint16Array} genome */
  shown(document, genome) {
    return this.#document(this.module._gs_shown(this.#putWithGenomes(document, [genome])));
  }

  /** How the motion of a document looks. @param {Uint8Array} document @returns {Float32Array} a number for each trait */
  traitsOf(document) {
    const at = this.orThrow(this.module._gs_document_traits(this.put(document)));
    return new Float32Array(this.bytesAt(at, 4 * TRAITS).buffer);
  }

  /** How motions look, in numbers (core/signal/traits.h). @returns {{name: string, unit: string, scale: number}[]} */
  get traits() { return JSON.parse(this.textAt(this.module._gs_traits())); }

  /** @param {Comparison[]} comparisons @returns {Taste} */
  taste(comparisons) {
    this.put(Float32Array.from(comparisons.flatMap(({ first, second, verdict }) => [...first, ...second, verdict])));
    return new Taste(this, this.orThrow(this.module._gs_taste_open(comparisons.length)));
  }

  /** @param {Uint8Array} document  whose search names the clip @returns {TransitionMap} */
  transitionMap(document) {
    return new TransitionMap(this, this.orThrow(this.module._gs_map_open(this.put(document))));
  }

  /** @param {Uint8Array} document @returns {RecordedMotion} */
  motion(document) {
    return new RecordedMotion(this, this.orThrow(this.module._gs_motion_open(this.put(document))));
  }

  /** As it is planned between keyframes. @param {Uint8Array} document @returns {RecordedMotion} */
  plannedMotion(document) {
    return new RecordedMotion(this, this.orThrow(this.module._gs_motion_open_planned(this.put(document))));
  }

  /**
   * One cycle of its motion, closed; an error that says why it has none.
   * @param {Uint8Array} document @param {{halves?: boolean, inPlace?: boolean}} [how]  halves: the second half is made of the
   * first, with limbs exchanged; inPlace: without its way along the ground
   * @returns {RecordedMotion}
   */
  loop(document, { halves = false, inPlace = false } = {}) {
    return new RecordedMotion(this, this.orThrow(this.module._gs_motion_open_loop(this.put(document), Number(halves), Number(inPlace))));
  }

  // Helpers for the classes below.

  /**
   * Copies a typed array into the engine's input area.
   * @param {Uint8Array | Uint16Array | Float32Array} data
   * @returns {number} its size in bytes
   */
  put(data) {
    const at = this.module._gs_input(data.byteLength); // may grow the memory: read HEAPU8 afterwards
    this.module.HEAPU8.set(new Uint8Array(data.buffer, data.byteOffset, data.byteLength), at);
    return data.byteLength;
  }

  /** Copies bytes, because the memory moves when it grows. @param {number} at @param {number} size */
  bytesAt(at, size) {
    return this.module.HEAPU8.slice(at, at + size);
  }

  /** @param {number} result  null or false after a failure */
  orThrow(result) {
    if (result) return result;
    throw new EngineError(JSON.parse(this.textAt(this.module._gs_error())));
  }

  /** @param {number} taste  a handle @param {Uint8Array} document */
  tasteDocument(taste, document) { return this.#document(this.module._gs_taste_document(taste, this.put(document))); }

  /** @param {number} at  of the kept document; 0 after a failure */
  #document(at) { return this.bytesAt(this.orThrow(at), this.module._gs_document_size()); }

  /** @param {Uint8Array} document @param {Uint16Array[]} genomes @returns {number} bytes of the document */
  #putWithGenomes(document, genomes) {
    const all = new Uint8Array(document.length + genomes.reduce((sum, { byteLength }) => sum + byteLength, 0));
    all.set(document);
    let at = document.length;
    for (const genome of genomes) {
      all.set(new Uint8Array(genome.buffer, genome.byteOffset, genome.byteLength), at);
      at += genome.byteLength;
    }
    this.put(all);
    return document.length;
  }

  /** A text that ends with a 0 byte. @param {number} at */
  textAt(at) {
    const heap = this.module.HEAPU8;
    return new TextDecoder().decode(heap.subarray(at, heap.indexOf(0, at)));
  }
}

/**
 * The children of a brood. genomes: one after another; scores: SCORE_LENGTH numbers for each
 * @typedef {{genomes: Uint16Array, scores: Float32Array}} Litter
 */

/** Numbers that say how a motion looks. */
export const TRAITS = 13;
/** Numbers in the score of a genome: fitness, greatest height, slip, rotations, then the traits. */
export const SCORE_LENGTH = 4 + TRAITS;

/** Scores genomes of one problem. */
export class Evaluator {
  /** @param {Engine} engine @param {number} handle */
  constructor(engine, handle) {
    this.engine = engine;
    this.handle = handle;
    /** Number of genes in a genome. */
    this.genes = engine.module._gs_evaluator_genes(handle);
  }

  /**
   * @param {Uint16Array} genomes  any number of them, one after another
   * @returns {Float32Array} SCORE_LENGTH numbers for each
   */
  score(genomes) {
    const count = Math.floor(genomes.length / this.genes);
    this.engine.put(genomes);
    if (count === 0) return new Float32Array(0);
    const at = this.engine.orThrow(this.engine.module._gs_evaluator_run(this.handle, count));
    return new Float32Array(this.engine.bytesAt(at, 4 * SCORE_LENGTH * count).buffer);
  }

  /** @param {Uint16Array} genomes @returns {Float32Array} fitness of each */
  evaluate(genomes) {
    return this.score(genomes).filter((_, i) => i % SCORE_LENGTH === 0);
  }

  close() { this.engine.module._gs_evaluator_close(this.handle); }
}

/** Decides which genomes to score next and keeps the best. */
export class Search {
  /** @param {Engine} engine @param {number} handle */
  constructor(engine, handle) {
    this.engine = engine;
    this.handle = handle;
    /** Number of genes in a genome. */
    this.genes = engine.module._gs_search_genes(handle);
    /** Total number of evaluations. */
    this.budget = engine.module._gs_search_budget(handle);
    /** Whether ask may be called again before tell has returned the scores of the first ask. */
    this.asksAhead = engine.module._gs_search_asks_ahead(handle) !== 0;
  }

  /**
   * @param {number} wanted  approximate number of genomes
   * @returns {Uint16Array} genomes, one after another; empty while every proposal depends on scores that have not
   * arrived
   */
  ask(wanted) {
    const count = this.engine.module._gs_search_ask(this.handle, wanted);
    return this.#genesAt(this.engine.module._gs_search_genomes(this.handle), count);
  }

  /**
   * Call once for each ask, in the same order.
   * @param {Float32Array} scores  of each genome of the oldest ask without scores: SCORE_LENGTH numbers, or its fitness
   * alone
   */
  tell(scores) {
    this.engine.put(scores);
    this.engine.orThrow(this.engine.module._gs_search_tell(this.handle, scores.length));
  }

  /** Scores the genomes of the only ask without scores in this engine, and tells. */
  scoreHere() { this.engine.orThrow(this.engine.module._gs_search_score(this.handle)); }

  get evaluations() { return this.engine.module._gs_search_evaluations(this.handle); }
  get done() { return this.engine.module._gs_search_done(this.handle) !== 0; }
  get bestFitness() { return this.engine.module._gs_search_best_fitness(this.handle); }

  /** @returns {Uint16Array} the best genome so far; empty before the first tell */
  get bestGenome() {
    const at = this.engine.module._gs_search_best_genome(this.handle);
    return this.#genesAt(at, at ? 1 : 0);
  }

  /** Number of points in the best-so-far curve. */
  get curveLength() { return this.engine.module._gs_search_curve_length(this.handle); }

  /** The curve as core stores it: per point an int32 (evaluation) and a float32 (best). */
  get curve() {
    return this.engine.bytesAt(this.engine.module._gs_search_curve(this.handle), 8 * this.curveLength);
  }

  /** The spread of the population's fitness now. @returns {Spread | null} null if there is none */
  get spread() {
    const at = this.engine.module._gs_search_spread(this.handle);
    return at ? JSON.parse(this.engine.textAt(at)) : null;
  }

  /** @returns {Litter | null} null: it does not breed */
  get litter() {
    const { module } = this.engine;
    const count = module._gs_brood_children(this.handle);
    if (count === 0) return null;
    const genomes = this.#genesAt(module._gs_search_genomes(this.handle), count);
    return { genomes, scores: new Float32Array(this.engine.bytesAt(module._gs_brood_scores(this.handle), 4 * SCORE_LENGTH * count).buffer) };
  }

  /** The whole state, to continue later or elsewhere. Call only between a tell and an ask. */
  save() {
    const at = this.engine.module._gs_search_save(this.handle);
    return this.engine.bytesAt(at, this.engine.module._gs_search_saved_size(this.handle));
  }

  /** @param {Uint8Array} state  saved by a search of the same document */
  load(state) {
    this.engine.orThrow(this.engine.module._gs_search_load(this.handle, this.engine.put(state)));
  }

  close() { this.engine.module._gs_search_close(this.handle); }

  /** @param {number} at @param {number} count */
  #genesAt(at, count) {
    return new Uint16Array(this.engine.bytesAt(at, 2 * this.genes * count).buffer);
  }
}

/** The scores of a clip if it took over at other moments. */
export class TransitionMap {
  /** @param {Engine} engine @param {number} handle */
  constructor(engine, handle) {
    this.engine = engine;
    this.handle = handle;
    /** Number of moments. */
    this.count = engine.module._gs_map_count(handle);
    /** The score that a moment's score is compared with. */
    this.usual = engine.module._gs_map_usual_score(handle);
  }

  /** Scores in the map's order, coarse first. @param {number} first @param {number} count @returns {Float32Array} */
  scores(first, count) {
    const at = this.engine.orThrow(this.engine.module._gs_map_run(this.handle, first, count));
    return new Float32Array(this.engine.bytesAt(at, 4 * count).buffer);
  }

  close() { this.engine.module._gs_map_close(this.handle); }
}

/** verdict: 0 the first motion is preferred, 1 the second, 2 neither @typedef {{first: Float32Array, second: Float32Array, verdict: number}} Comparison */

/** A person's taste, learned from comparisons (core/breeding/taste.h). */
export class Taste {
  /** @param {Engine} engine @param {number} handle */
  constructor(engine, handle) {
    this.engine = engine;
    this.handle = handle;
    const numbers = (/** @type {number} */ at) => new Float32Array(engine.bytesAt(at, 4 * TRAITS).buffer);
    /** Of each trait: by how much a plain difference raises the log-odds that a motion is preferred. */
    this.weights = numbers(engine.module._gs_taste_weights(handle));
    /** Standard deviation of each weight. */
    this.doubts = numbers(engine.module._gs_taste_doubts(handle));
  }

  /** How much a comparison would tell, in nats. @param {Float32Array} first @param {Float32Array} second  traits */
  telling(first, second) {
    this.engine.put(Float32Array.of(...first, ...second));
    return this.engine.module._gs_taste_telling(this.handle);
  }

  /** The document with the taste as the weights of its task. @param {Uint8Array} document */
  weigh(document) { return this.engine.tasteDocument(this.handle, document); }

  close() { this.engine.module._gs_taste_close(this.handle); }
}
