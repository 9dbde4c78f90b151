// SPDX-License-Identifier: MIT
// The parts of the browser's module Worker that the page uses, with Node's worker threads. So the tests run the page's
// own worker.js.
import { fileURLToPath } from 'node:url';
import { isMainThread, parentPort, Worker as Thread, workerData } from 'node:worker_threads';

/** Replaces the browser's Worker. */
export class NodeWorker {
  /** @type {((event: {data: any}) => void) | null} */
  onmessage = null;
  /** @type {((event: {message: string}) => void) | null} */
  onerror = null;

  /** @param {string} script  path of a module */
  constructor(script) {
    this.thread = new Thread(fileURLToPath(import.meta.url), { workerData: { script } });
    this.thread.on('message', (data) => this.onmessage?.({ data }));
    this.thread.on('error', (error) => this.onerror?.({ message: String(error) }));
  }

  /** @param {unknown} message @param {any[]} [transfer] */
  postMessage(message, transfer) { this.thread.postMessage(message, transfer); }

  terminate() { void this.thread.terminate(); }
}

// In the thread: the worker's global scope, then the worker's script.
if (!isMainThread && parentPort && workerData?.script) {
  const port = parentPort;
  // In a browser, a rejected promise does not end the worker or cause an 'error' event on the page. In Node it would.
  process.on('unhandledRejection', () => {});
  /** @type {any[]} */
  const early = [];
  const buffer = (/** @type {any} */ data) => early.push(data);
  port.on('message', buffer);
  const scope = Object.assign(globalThis, {
    self: globalThis,
    postMessage: (/** @type {any} */ message, /** @type {any} */ options) =>
      port.postMessage(message, options?.transfer ?? []),
    addEventListener: (/** @type {string} */ type, /** @type {(event: {data: any}) => void} */ listener) => {
      if (type === 'message') port.on('message', (data) => listener({ data }));
      if (type === 'message') for (const data of early.splice(0)) listener({ data });
    },
  });
  await import(workerData.script);
  port.off('message', buffer);
  void scope;
}
