// SPDX-License-Identifier: MIT
// A worker, with the roles of worker_roles.js.
import { WorkerRoles } from './worker_roles.js';

// The page receives an 'error' event, and replaces the worker, only if an error is thrown outside a promise.
const die = (/** @type {unknown} */ error) => { setTimeout(() => { throw error; }); };

const roles = new WorkerRoles((message, transfer = []) => self.postMessage(message, { transfer }), die);
self.addEventListener('message', ({ data }) => roles.onMessage(data));
roles.begin();
