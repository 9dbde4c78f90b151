// SPDX-License-Identifier: MIT
// Replaces a Worker if the browser allows none, such as in a frame without an origin. It has the same roles, and runs
// in the page itself, in slices so short that the page keeps drawing.
import { WorkerRoles } from './worker_roles.js';

const SLICE_MS = 8;

export class PageWorker {
  /** @type {((event: {data: any}) => void) | null} */
  onmessage = null;
  /** @type {((event: {message: string, preventDefault?: () => void}) => void) | null} */
  onerror = null;
  #open = true;
  #roles = new WorkerRoles(
    (data) => this.#later(() => this.onmessage?.({ data })),
    (error) => this.#later(() => this.onerror?.({ message: String(error) })),
    { longestMs: SLICE_MS },
  );

  constructor() { this.#roles.begin(); }

  /** @param {any} message */
  postMessage(message) { this.#later(() => this.#roles.onMessage(message)); }

  terminate() {
    this.#open = false;
    this.#roles.end();
  }

  /** Asynchronous, as between threads. @param {() => void} action */
  #later(action) { setTimeout(() => { if (this.#open) action(); }); }
}
