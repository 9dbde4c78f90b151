// SPDX-License-Identifier: MIT
// The page's side of plans. They have their own worker and their own module, which is loaded when the first plan is
// started. The application requests one plan at a time, with a generation number. Reports of earlier generations are
// ignored. A frame without an origin has no workers, and every plan fails: the solver would stop the page while it works.
import { compiledModule } from '../browser/compiled_module.js';
import { scriptAddress } from '../browser/trusted.js';

/** @typedef {import('./worker.js').PlanRequest} PlanRequest */
/** @typedef {import('./worker.js').PlanReport} PlanReport */
/** @typedef {import('./worker.js').PlanFailure} PlanFailure */

/**
 * @typedef {object} PlanListener
 * @property {(report: PlanReport) => void} reported
 * @property {(generation: number) => void} failed  its worker died or went silent, or core refused the document
 */

// Scripts may load over a slow line.
const START_MS = 30000;
// An iteration takes a tenth of a second at most, but not each can be shown.
const SILENCE_MS = 30000;
// Silence is counted in ticks, so that a machine's sleep counts as one tick.
const TICK_MS = 1000;
// How long the worker is kept for the next plan, as for workers of searches.
const IDLE_MS = 5 * 60000;

export class Plans {
  /** @type {Worker | null} */
  #worker = null;
  /** @type {Promise<WebAssembly.Module> | null} */
  #compiled = null;
  #generation = 0; // of the requested plan; 0: none
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #timer;

  /**
   * @param {PlanListener} listener
   * @param {object} [options]
   * @param {() => Promise<WebAssembly.Module>} [options.planner]  planner_module.wasm
   * @param {() => Worker} [options.createWorker]  of worker.js
   * @param {number} [options.startMs]    until the first report
   * @param {number} [options.silenceMs]  between two reports
   */
  constructor(listener, {
    planner = () => compiledModule(new URL('../plan/planner_module.wasm', import.meta.url)),
    createWorker = () => new Worker(scriptAddress('plan/worker.js'), { type: 'module' }),
    startMs = START_MS, silenceMs = SILENCE_MS,
  } = {}) {
    this.listener = listener;
    this.planner = planner;
    this.createWorker = createWorker;
    this.startMs = startMs;
    this.silenceMs = silenceMs;
  }

  /**
   * Carries out a document's plan and abandons an unfinished one.
   * @param {Uint8Array} document  binary form
   * @param {number} generation    not 0
   */
  async start(document, generation) {
    this.stop();
    this.#generation = generation;
    this.#limitSilence(this.startMs);
    try {
      const code = await this.#code();
      if (generation !== this.#generation) return;
      this.#worker ??= this.#startWorker();
      this.#worker.postMessage(/** @type {PlanRequest} */ ({ type: 'plan', code, document, generation }));
    } catch {
      if (generation === this.#generation) this.#fail();
    }
  }

  /** Abandons the requested plan. Its worker is at work and takes no messages, so it is ended. */
  stop() { if (this.#generation !== 0) this.close(); }

  /** Ends the worker at once. */
  close() {
    this.#generation = 0;
    clearTimeout(this.#timer);
    this.#worker?.terminate();
    this.#worker = null;
  }

  /** Compiled once for all workers. After a failure the next plan tries again. */
  #code() {
    const compiled = this.#compiled ??= this.planner();
    compiled.catch(() => { this.#compiled = null; });
    return compiled;
  }

  #startWorker() {
    const worker = this.createWorker();
    /** @param {MessageEvent<PlanReport | PlanFailure>} event */
    worker.onmessage = ({ data }) => { if (worker === this.#worker && data.generation === this.#generation) this.#onMessage(data); };
    worker.onerror = (event) => {
      event.preventDefault?.();
      if (worker === this.#worker) this.#fail();
    };
    return worker;
  }

  /** @param {PlanReport | PlanFailure} message */
  #onMessage(message) {
    if (message.type === 'failed') return this.#fail();
    if (message.stage === 'played' || message.stage === 'refused') this.#becomeIdle();
    else this.#limitSilence(this.silenceMs);
    this.listener.reported(message);
  }

  #becomeIdle() {
    this.#generation = 0;
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.close(), IDLE_MS);
  }

  /** Fails if no message arrives in this time. @param {number} ms */
  #limitSilence(ms) {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => (ms > TICK_MS ? this.#limitSilence(ms - TICK_MS) : this.#fail()), Math.min(ms, TICK_MS));
  }

  #fail() {
    const generation = this.#generation;
    this.close();
    if (generation !== 0) this.listener.failed(generation);
  }
}
