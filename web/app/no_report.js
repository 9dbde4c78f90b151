// SPDX-License-Identifier: MIT
// A file of its own, because the page needs it long before messages.js.

/** @typedef {import('../search/messages.js').SearchReport} SearchReport */

/** The report of a search before its first report arrives. @type {Readonly<SearchReport>} */
export const NO_REPORT = Object.freeze({ state: 'running', evaluations: 0, budget: 0, simulated: 0, rate: 0,
  secondsLeft: 0, bestFitness: -Infinity, bestGenome: null, attempt: null, curve: null, spread: null, saved: null });
