// SPDX-License-Identifier: MIT
// The page's side of transition maps. They have their own worker, so that no search waits for them. The application
// requests one map at a time, with a generation number. Answers of earlier generations are ignored.
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
const IDLE_MS = 5 * 60000;

export class TransitionMaps {
  /** @type {Worker | null} */
  #worker = null;
  /** @type {WebAssembly.Module | null} */
  #compiled = null;
  #generation = 0; // of the requested map; 0: none
  /** @type {Role | null} */
  #request = null;
  #received = 0; // number of moments received without a gap
  #retried = false; // the map was requested a second time
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #timer;

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
    this.#limitSilence(START_MS);
    try {
      const engine = this.#compiled ??= await this.engine();
      if (generation !== this.#generation) return;
      this.#worker ??= this.#startWorker();
      this.#request = { type: 'map-transitions', engine, document, generation };
      this.#send(false);
    } catch {
      if (generation === this.#generation) this.#fail();
    }
  }

  /** @param {boolean} retried */
  #send(retried) {
    this.#received = 0;
    this.#retried = retried;
    if (this.#request) this.#worker?.postMessage(this.#request);
  }

  /** Abandons the requested map. */
  stop() {
    if (this.#generation === 0) return;
    if (this.#compiled) this.#worker?.postMessage(/** @type {Role} */ ({ type: 'stand-by', engine: this.#compiled }));
    this.#becomeIdle();
  }

  /** Ends the worker at once. */
  close() {
    this.#generation = 0;
    clearTimeout(this.#timer);
    this.#endWorker();
  }

  #becomeIdle() {
    this.#generation = 0;
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.#endWorker(), IDLE_MS);
  }

  #startWorker() {
    const worker = this.createWorker();
    /** @param {MessageEvent<MapperToPage>} event */
    worker.onmessage = ({ data }) => { if (worker === this.#worker) this.#onMessage(data); };
    worker.onerror = (event) => {
      event.preventDefault?.();
      if (worker === this.#worker) this.#fail();
    };
    return worker;
  }

  #endWorker() {
    this.#worker?.terminate();
    this.#worker = null;
  }

  /** @param {MapperToPage} message */
  #onMessage(message) {
    if (this.#generation === 0) return;
    switch (message.type) {
      case 'loaded':
      case 'ready':
        break;
      case 'mapped':
        if (message.generation !== this.#generation) return;
        this.#limitSilence(SILENCE_MS);
        if (message.first <= this.#received) this.#received = Math.max(this.#received, message.first + message.scores.length);
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

  /** Handles the last part. If an earlier part was lost, requests the map once more. @param {number} count  of moments */
  #end(count) {
    if (this.#received >= count) this.#becomeIdle();
    else if (this.#retried) setTimeout(() => this.#fail());
    else this.#send(true);
  }

  /** Fails if no message arrives in this time. @param {number} ms */
  #limitSilence(ms) {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => (ms > TICK_MS ? this.#limitSilence(ms - TICK_MS) : this.#fail()), TICK_MS);
  }

  #fail() {
    const generation = this.#generation;
    this.#generation = 0;
    clearTimeout(this.#timer);
    this.#endWorker();
    if (generation !== 0) this.listener.failed(generation);
  }
}
