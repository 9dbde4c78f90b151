// SPDX-License-Identifier: MIT
// A worker. A message says whether it coordinates a search, evaluates for one or maps transitions; when that is done,
// the next role may follow.
import { Coordinator } from './worker_coordinator.js';
import { Engine, EngineError } from './engine.js';
import { startEvaluator } from './worker_evaluator.js';
import { startMapper } from './worker_mapper.js';
import { unreachable } from './messages.js';

/** @typedef {import('./messages.js').Role} Role */
/** @typedef {import('./messages.js').PageToCoordinator} PageToCoordinator */
/** @typedef {import('./messages.js').CoordinatorToPage} CoordinatorToPage */
/** @typedef {import('./messages.js').MapperToPage} MapperToPage */

/** @type {(message: CoordinatorToPage | MapperToPage, transfer?: Transferable[]) => void} */
const post = (message, transfer = []) => self.postMessage(message, { transfer });

/** @type {Promise<Engine> | null} */
let engine = null;
/** @type {Coordinator | null} */
let coordinator = null;
/** Frees what the role before holds. */
let leave = () => {};
let before = Promise.resolve();

// Messages wait for the role that one before them began, and keep their order.
self.addEventListener('message', ({ data }) => {
  const isRole = ['stand-by', 'coordinate', 'evaluate', 'map-transitions'].includes(data.type);
  before = before.then(() => (isRole ? take(data) : coordinator?.receive(data))).catch(die);
});

/** @param {Role} message */
async function take(message) {
  try {
    leave();
    leave = () => {};
    coordinator = null;
    engine ??= Engine.load(message.engine);
    const loaded = await engine;
    switch (message.type) {
      case 'stand-by':
        return;
      case 'coordinate': {
        const mine = new Coordinator(loaded, message, post);
        coordinator = mine;
        leave = () => mine.close();
        break;
      }
      case 'evaluate':
        leave = startEvaluator(loaded, message);
        break;
      case 'map-transitions':
        leave = startMapper(loaded, message, post);
        break;
      default:
        unreachable(message);
    }
    post({ type: 'ready' });
  } catch (error) {
    if (error instanceof EngineError) post({ type: 'failed', fault: error.fault });
    else die(error);
  }
}

/**
 * Only an error that leaves the event loop reaches the page as the worker's 'error' event, not a rejected promise;
 * the page then replaces this worker.
 * @param {unknown} error
 */
function die(error) {
  setTimeout(() => { throw error; });
}
