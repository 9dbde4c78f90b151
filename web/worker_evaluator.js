// SPDX-License-Identifier: MIT
// The evaluator's role: scores genomes as they arrive, and knows nothing of the search they belong to.

/** @typedef {import('./messages.js').CoordinatorToEvaluator} CoordinatorToEvaluator */
/** @typedef {import('./messages.js').EvaluatorToCoordinator} EvaluatorToCoordinator */

/**
 * @param {import('./engine.js').Engine} engine
 * @param {import('./messages.js').Evaluate} role
 * @returns {() => void} ends it
 */
export function startEvaluator(engine, { document, port }) {
  const evaluator = engine.evaluator(document);
  /** @param {MessageEvent<CoordinatorToEvaluator>} event */
  port.onmessage = ({ data }) => {
    let scores;
    try {
      scores = evaluator.score(data.genomes);
    } catch (error) {
      port.close(); // an engine that trapped scores nothing more
      throw error;
    }
    /** @type {EvaluatorToCoordinator} */
    const reply = { type: 'scored', slice: data.slice, scores };
    port.postMessage(reply, [scores.buffer]);
  };
  return () => {
    port.close();
    evaluator.close();
  };
}
