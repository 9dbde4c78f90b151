// SPDX-License-Identifier: MIT
// The roles of a worker. A message makes it coordinate a search, evaluate for one or map transitions. Another role may
// follow. The roles run in a worker (worker.js) or, if the browser allows none, in the page (page_worker.js).
import { Coordinator } from './worker_coordinator.js';
import { Engine, EngineError } from './engine.js';
import { startEvaluator } from './worker_evaluator.js';
import { startMapper } from './worker_mapper.js';
import { unreachable } from './messages.js';

/** @typedef {import('./messages.js').Role} Role */
/** @typedef {import('./messages.js').PageToCoordinator} PageToCoordinator */
/** @typedef {import('./messages.js').CoordinatorMessage} CoordinatorMessage */
/** @typedef {import('./messages.js').MapperMessage} MapperMessage */
/**
 * @typedef {{disconnect: () => void, free: () => void}} ActiveRole  disconnect: stops receiving messages; free: frees
 * its objects in the engine
 */
/** @typedef {(message: (import('./messages.js').Loaded | CoordinatorMessage | MapperMessage) & {run?: number}, transfer?: Transferable[]) => void} Post */

export class WorkerRoles {
  /** @type {Promise<Engine> | null} */
  #engine = null;
  /** @type {Coordinator | null} */
  #coordinator = null;
  /** @type {ActiveRole | null} */
  #activeRole = null;
  #queue = Promise.resolve();
  #run = 0; // of the role's search; 0: none
  // After an error, which may have left the search half changed, the worker neither sends nor receives.
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
      this.#activeRole?.disconnect();
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
  onMessage(message) {
    const isRole = ['stand-by', 'coordinate', 'evaluate', 'map-transitions'].includes(message.type);
    this.#queue = this.#queue
      .then(() => {
        if (this.#dead) return;
        return isRole ? this.#startRole(/** @type {Role} */ (message)) : this.#receive(/** @type {PageToCoordinator} */ (message));
      })
      .catch(this.die);
  }

  /** Leaves the role and starts no other, not even one whose message has already arrived. */
  end() {
    this.leave();
    this.#queue = this.#queue.then(() => this.leave(), () => {});
  }

  leave() {
    const activeRole = this.#activeRole;
    this.#activeRole = this.#coordinator = null;
    activeRole?.disconnect();
    if (!this.#dead) activeRole?.free(); // an engine that trapped must not be called
  }

  /** @param {PageToCoordinator} message */
  #receive(message) {
    if (message.run === this.#run) this.#coordinator?.receive(message); // else the message is for an earlier run
  }

  /** @param {Role} message */
  async #startRole(message) {
    const run = 'run' in message ? message.run : 0;
    if (run > 0 && run === this.#run) return; // a repeated message
    this.#run = run;
    /** @type {Post} */
    const post = run > 0 ? (reply, transfer) => this.post({ ...reply, run }, transfer) : this.post;
    try {
      this.leave();
      this.#engine ??= Engine.load(message.engine);
      const engine = await this.#engine;
      switch (message.type) {
        case 'stand-by':
          return;
        case 'coordinate':
          this.#activeRole = this.#coordinator = new Coordinator(engine, message, post, this.die, this.longestMs);
          break;
        case 'evaluate':
          this.#activeRole = startEvaluator(engine, message, this.die);
          break;
        case 'map-transitions':
          this.#activeRole = startMapper(engine, message, post, this.die, this.longestMs);
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
