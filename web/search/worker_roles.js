// SPDX-License-Identifier: MIT
// The roles of a worker. A message decides whether it coordinates a search, evaluates for one or maps transitions. When
// that is done, another role may follow. The roles run in a worker (worker.js) or, where there are none, in the page
// (page_worker.js).
import { Coordinator } from './worker_coordinator.js';
import { Engine, EngineError } from './engine.js';
import { startEvaluator } from './worker_evaluator.js';
import { startMapper } from './worker_mapper.js';
import { unreachable } from './messages.js';

/** @typedef {import('./messages.js').Role} Role */
/** @typedef {import('./messages.js').PageToCoordinator} PageToCoordinator */
/** @typedef {import('./messages.js').OfCoordinator} OfCoordinator */
/** @typedef {import('./messages.js').OfMapper} OfMapper */
/**
 * @typedef {{letGo: () => void, free: () => void}} Holdings  letGo: stops receiving messages; free: frees its objects
 * in the engine
 */
/** @typedef {(message: (import('./messages.js').Loaded | OfCoordinator | OfMapper) & {run?: number}, transfer?: Transferable[]) => void} Post */

export class WorkerRoles {
  /** @type {Promise<Engine> | null} */
  #engine = null;
  /** @type {Coordinator | null} */
  #coordinator = null;
  /** @type {Holdings | null} */
  #holdings = null;
  #before = Promise.resolve();
  #run = 0; // of the role's search; 0: none
  // Then it neither sends nor receives: an error may have left the search half changed.
  #dead = false;

  /**
   * @param {Post} post
   * @param {(error: unknown) => void} die
   * @param {{longestMs?: number}} [pace]  longest time of the work between two messages
   */
  constructor(post, die, { longestMs } = {}) {
    /** @type {Post} */
    this.post = (message, transfer) => { if (!this.#dead) post(message, transfer); };
    this.die = (/** @type {unknown} */ error) => {
      this.#dead = true;
      this.#holdings?.letGo();
      die(error);
    };
    this.longestMs = longestMs;
  }

  /** Reports that the scripts are loaded. */
  begin() { this.post({ type: 'loaded' }); }

  /**
   * Messages wait until the role of an earlier message has started, and keep their order.
   * @param {Role | PageToCoordinator} message
   */
  hear(message) {
    const isRole = ['stand-by', 'coordinate', 'evaluate', 'map-transitions'].includes(message.type);
    this.#before = this.#before
      .then(() => {
        if (this.#dead) return;
        return isRole ? this.#take(/** @type {Role} */ (message)) : this.#receive(/** @type {PageToCoordinator} */ (message));
      })
      .catch(this.die);
  }

  /** No role follows, not even one whose message is on its way. */
  end() {
    this.leave();
    this.#before = this.#before.then(() => this.leave(), () => {});
  }

  leave() {
    const holdings = this.#holdings;
    this.#holdings = this.#coordinator = null;
    holdings?.letGo();
    if (!this.#dead) holdings?.free(); // do not call an engine that trapped; it is discarded as a whole
  }

  /** @param {PageToCoordinator} message */
  #receive(message) {
    if (message.run === this.#run) this.#coordinator?.receive(message); // else the message is for an earlier run
  }

  /** @param {Role} message */
  async #take(message) {
    const run = 'run' in message ? message.run : 0;
    if (run > 0 && run === this.#run) return; // the message came twice
    this.#run = run;
    /** @type {Post} */
    const post = run > 0 ? (said, transfer) => this.post({ ...said, run }, transfer) : this.post;
    try {
      this.leave();
      this.#engine ??= Engine.load(message.engine);
      const engine = await this.#engine;
      switch (message.type) {
        case 'stand-by':
          return;
        case 'coordinate':
          this.#holdings = this.#coordinator = new Coordinator(engine, message, post, this.die, this.longestMs);
          break;
        case 'evaluate':
          this.#holdings = startEvaluator(engine, message, this.die);
          break;
        case 'map-transitions':
          this.#holdings = startMapper(engine, message, post, this.die, this.longestMs);
          break;
        default:
          unreachable(message);
      }
      post({ type: 'ready' });
    } catch (error) {
      if (error instanceof EngineError) post({ type: 'failed', fault: error.fault });
      else this.die(error);
    }
  }
}
