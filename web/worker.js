// SPDX-License-Identifier: MIT
// A worker: plays the roles of worker_roles.js.
import { WorkerRoles } from './worker_roles.js';

// Only an error that leaves the event loop reaches the page as the worker's 'error' event, not a rejected promise; the page
// then replaces this worker.
const die = (/** @type {unknown} */ error) => {
  dead = true;
  setTimeout(() => { throw error; });
};

// Until the page ends it, it says nothing more: it may have stopped half way through a change of the search.
let dead = false;
self.addEventListener('error', () => { dead = true; });

const roles = new WorkerRoles((message, transfer = []) => { if (!dead) self.postMessage(message, { transfer }); }, die);
self.addEventListener('message', ({ data }) => roles.hear(data));
roles.begin();
