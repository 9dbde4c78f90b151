// SPDX-License-Identifier: MIT
// What a worker does: a message says whether it coordinates a search, evaluates for one or maps transitions; when that is
// done, the next role may follow. It runs in a worker (worker.js) or, where there are none, in the page (page_worker.js).
import { Coordinator } from './worker_coordinator.js';
import { Engine, EngineError } from './engine.js';
import { startEvaluator } from './worker_evaluator.js';
import { startMapper } from './worker_mapper.js';
import { unreachable } from './messages.js';

/** @typedef {import('./messages.js').Role} Role */
/** @typedef {import('./messages.js').PageToCoordinator} PageToCoordinator */
/** @typedef {import('./messages.js').CoordinatorToPage} CoordinatorToPage */
/** @typedef {import('./messages.js').MapperToPage} MapperToPage */
/** @typedef {(message: CoordinatorToPage | MapperToPage | {type: 'failed', fault: any} | {type: 'ready'}, transfer?: Transferable[]) => void} Post */

export class WorkerRoles {
  /** @type {Promise<Engine> | null} */
  #engine = null;
  /** @type {Coordinator | null} */
  #coordinator = null;
  /** Frees what the role before holds. */
  #leave = () => {};
  #before = Promise.resolve();

  /**
   * @param {Post} post
   * @param {(error: unknown) => void} die
   * @param {{longestMs?: number}} [pace]  of what is done between two messages
   */
  constructor(post, die, { longestMs } = {}) {
    this.post = post;
    this.die = die;
    this.longestMs = longestMs;
  }

  /** Messages wait for the role that one before them began, and keep their order. @param {Role | PageToCoordinator} message */
  hear(message) {
    const isRole = ['stand-by', 'coordinate', 'evaluate', 'map-transitions'].includes(message.type);
    this.#before = this.#before
      .then(() => (isRole ? this.#take(/** @type {Role} */ (message)) : this.#coordinator?.receive(/** @type {PageToCoordinator} */ (message))))
      .catch(this.die);
  }

  /** No role follows, not even one that is on its way. */
  end() {
    this.leave();
    this.#before = this.#before.then(() => this.leave(), () => {});
  }

  leave() {
    this.#leave();
    this.#leave = () => {};
    this.#coordinator = null;
  }

  /** @param {Role} message */
  async #take(message) {
    try {
      this.leave();
      this.#engine ??= Engine.load(message.engine);
      const engine = await this.#engine;
      switch (message.type) {
        case 'stand-by':
          return;
        case 'coordinate': {
          const mine = new Coordinator(engine, message, this.post, this.longestMs);
          this.#coordinator = mine;
          this.#leave = () => mine.close();
          break;
        }
        case 'evaluate':
          this.#leave = startEvaluator(engine, message);
          break;
        case 'map-transitions':
          this.#leave = startMapper(engine, message, this.post, this.longestMs);
          break;
        default:
          unreachable(message);
      }
      this.post({ type: 'ready' });
    } catch (error) {
      if (error instanceof EngineError) this.post({ type: 'failed', fault: error.fault });
      else this.die(error);
    }
  }
}
