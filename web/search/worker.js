// SPDX-License-Identifier: MIT
// A worker: plays the roles of worker_roles.js.
import { WorkerRoles } from './worker_roles.js';

// Only an error that leaves the event loop reaches the page as the worker's 'error' event, not a rejected promise; the page
// then replaces this worker.
const die = (/** @type {unknown} */ error) => { setTimeout(() => { throw error; }); };

const roles = new WorkerRoles((message, transfer = []) => self.postMessage(message, { transfer }), die);
self.addEventListener('message', ({ data }) => roles.hear(data));
roles.begin();
