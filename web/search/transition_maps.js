// SPDX-License-Identifier: MIT
// The page's side of transition maps, with a worker of their own, so that no search waits for them. The application
// requests one map at a time and knows its generation. Answers of earlier generations are outdated.
import { unreachable } from './messages.js';

/** @typedef {import('./messages.js').MapperToPage} MapperToPage */
/** @typedef {import('./messages.js').Mapped} Mapped */
/** @typedef {import('./messages.js').Role} Role */

/**
 * @typedef {object} MapListener
 * @property {(part: Mapped) => void} mapped
 * @property {(generation: number) => void} failed  its worker died or went silent, or core refused the document
 */

// Scripts may load over a slow line.
const START_MS = 30000;
// A part takes a tenth of a second.
const SILENCE_MS = 10000;
// Silence is counted in ticks, so that a machine's sleep counts as one tick.
const TICK_MS = 1000;
// How long the worker is kept for the next map, as for workers of searches.
const REST_MS = 5 * 60000;

export class TransitionMaps {
  /** @type {Worker | null} */
  #worker = null;
  /** @type {WebAssembly.Module | null} */
  #compiled = null;
  #generation = 0; // of the requested map; 0: none
  /** @type {Role | null} */
  #wanted = null;
  #told = 0; // number of moments received without a gap
  #again = false; // the map was requested again
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #watch;

  /**
   * @param {object} options
   * @param {() => Promise<WebAssembly.Module>} options.engine
   * @param {() => Worker} options.createWorker  of worker.js
   * @param {MapListener} options.listener
   */
  constructor({ engine, createWorker, listener }) {
    this.engine = engine;
    this.createWorker = createWorker;
    this.listener = listener;
  }

  /**
   * Computes a map and abandons an unfinished one.
   * @param {Uint8Array} document  binary form, whose search names the clip
   * @param {number} generation    not 0
   */
  async start(document, generation) {
    this.#generation = generation;
    this.#expect(START_MS);
    try {
      const engine = this.#compiled ??= await this.engine();
      if (generation !== this.#generation) return;
      this.#worker ??= this.#hire();
      this.#wanted = { type: 'map-transitions', engine, document, generation };
      this.#ask(false);
    } catch {
      if (generation === this.#generation) this.#fail();
    }
  }

  /** @param {boolean} again */
  #ask(again) {
    this.#told = 0;
    this.#again = again;
    if (this.#wanted) this.#worker?.postMessage(this.#wanted);
  }

  /** Abandons the requested map. */
  stop() {
    if (this.#generation === 0) return;
    if (this.#compiled) this.#worker?.postMessage(/** @type {Role} */ ({ type: 'stand-by', engine: this.#compiled }));
    this.#rest();
  }

  /** Ends the worker at once. */
  close() {
    this.#generation = 0;
    clearTimeout(this.#watch);
    this.#dismiss();
  }

  #rest() {
    this.#generation = 0;
    clearTimeout(this.#watch);
    this.#watch = setTimeout(() => this.#dismiss(), REST_MS);
  }

  #hire() {
    const worker = this.createWorker();
    /** @param {MessageEvent<MapperToPage>} event */
    worker.onmessage = ({ data }) => { if (worker === this.#worker) this.#hear(data); };
    worker.onerror = (event) => {
      event.preventDefault?.();
      if (worker === this.#worker) this.#fail();
    };
    return worker;
  }

  #dismiss() {
    this.#worker?.terminate();
    this.#worker = null;
  }

  /** @param {MapperToPage} message */
  #hear(message) {
    if (this.#generation === 0) return;
    switch (message.type) {
      case 'loaded':
      case 'ready':
        break;
      case 'mapped':
        if (message.generation !== this.#generation) return;
        this.#expect(SILENCE_MS);
        if (message.first <= this.#told) this.#told = Math.max(this.#told, message.first + message.scores.length);
        if (message.first + message.scores.length >= message.count) this.#end(message.count);
        this.listener.mapped(message);
        break;
      case 'failed':
        this.#fail();
        break;
      default:
        unreachable(message);
    }
  }

  /** Handles the last part. If an earlier part was lost, requests all parts again. @param {number} count  of moments */
  #end(count) {
    if (this.#told >= count) this.#rest();
    else if (this.#again) setTimeout(() => this.#fail());
    else this.#ask(true);
  }

  /** @param {number} ms */
  #expect(ms) {
    clearTimeout(this.#watch);
    this.#watch = setTimeout(() => (ms > TICK_MS ? this.#expect(ms - TICK_MS) : this.#fail()), TICK_MS);
  }

  #fail() {
    const generation = this.#generation;
    this.#generation = 0;
    clearTimeout(this.#watch);
    this.#dismiss();
    if (generation !== 0) this.listener.failed(generation);
  }
}
