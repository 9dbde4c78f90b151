// SPDX-License-Identifier: MIT
// A search worker. Its first message says whether it coordinates a search or evaluates for one.
import { Coordinator } from './worker_coordinator.js';
import { Engine, EngineError } from './engine.js';
import { startEvaluator } from './worker_evaluator.js';
import { unreachable } from './messages.js';

/** @typedef {import('./messages.js').Role} Role */
/** @typedef {import('./messages.js').PageToCoordinator} PageToCoordinator */
/** @typedef {import('./messages.js').CoordinatorToPage} CoordinatorToPage */

/** @type {(message: CoordinatorToPage, transfer?: Transferable[]) => void} */
const post = (message, transfer = []) => self.postMessage(message, { transfer });

/** @type {Promise<Coordinator | null> | null} */
let role = null;

// Later messages wait for the role that the first one began, and keep their order.
self.addEventListener('message', ({ data }) => {
  if (!role) role = take(data);
  else role.then((coordinator) => coordinator?.receive(data)).catch(die);
});

/** @param {Role} message */
async function take(message) {
  try {
    const engine = await Engine.load(message.engine);
    switch (message.type) {
      case 'coordinate': {
        const coordinator = new Coordinator(engine, message, post);
        post({ type: 'ready' });
        return coordinator;
      }
      case 'evaluate':
        startEvaluator(engine, message);
        post({ type: 'ready' });
        return null;
      default:
        return unreachable(message);
    }
  } catch (error) {
    if (error instanceof EngineError) post({ type: 'failed', fault: error.fault });
    else die(error);
    return null;
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
