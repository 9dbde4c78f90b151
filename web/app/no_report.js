// SPDX-License-Identifier: MIT
// The report of a search before its first: the page needs it long before it needs messages.js.

/** @typedef {import('../search/messages.js').SearchReport} SearchReport */

/** A search of which nothing is known yet. @type {Readonly<SearchReport>} */
export const NO_REPORT = Object.freeze({ state: 'running', evaluations: 0, budget: 0, simulated: 0, rate: 0,
  secondsLeft: 0, bestFitness: -Infinity, bestGenome: null, curve: null, spread: null, saved: null });
