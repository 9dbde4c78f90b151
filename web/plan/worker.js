// SPDX-License-Identifier: MIT
// A worker that carries out plans, one after another. The solver takes no messages while it is at work: the page ends
// the worker to cancel a plan.
import { Planner } from './planner.js';

/** Page → worker. @typedef {{type: 'plan', code: WebAssembly.Module, document: Uint8Array, generation: number}} PlanRequest */
/** Worker → page. @typedef {{type: 'report', generation: number} & import('./planner.js').Progress} PlanReport */
/** Core refused the document. Worker → page. @typedef {{type: 'failed', generation: number}} PlanFailure */

/** @type {Promise<Planner> | null} */
let planner = null;

/** @param {PlanReport | PlanFailure} message @param {Transferable[]} [transfer] */
const post = (message, transfer = []) => self.postMessage(message, { transfer });

/** @param {PlanRequest} request */
async function carryOut({ code, document, generation }) {
  planner ??= Planner.load(code);
  const planned = (await planner).carryOut(document, (progress) =>
    post({ type: 'report', generation, ...progress }, [progress.document.buffer, progress.misses.buffer]));
  if (!planned) post({ type: 'failed', generation });
}

self.addEventListener('message', ({ data }) => {
  // The page receives an 'error' event only if an error is thrown outside a promise.
  carryOut(data).catch((error) => { setTimeout(() => { throw error; }); });
});
