// SPDX-License-Identifier: MIT
// A worker: plays the roles of worker_roles.js.
import { WorkerRoles } from './worker_roles.js';

// The page receives an 'error' event, and replaces the worker, only for an error that leaves the event loop. A rejected
// promise does not cause one.
const die = (/** @type {unknown} */ error) => { setTimeout(() => { throw error; }); };

const roles = new WorkerRoles((message, transfer = []) => self.postMessage(message, { transfer }), die);
self.addEventListener('message', ({ data }) => roles.hear(data));
roles.begin();
