// SPDX-License-Identifier: MIT
// The evaluator's role: scores genomes as they arrive, without knowing their search.

/** @typedef {import('./messages.js').CoordinatorToEvaluator} CoordinatorToEvaluator */
/** @typedef {import('./messages.js').EvaluatorToCoordinator} EvaluatorToCoordinator */

/**
 * @param {import('./engine.js').Engine} engine
 * @param {import('./messages.js').Evaluate} role
 * @param {(error: unknown) => void} die  ends the role after an error
 * @returns {import('./worker_roles.js').ActiveRole}
 */
export function startEvaluator(engine, { document, port, breeds }, die) {
  const evaluator = engine.evaluator(document, breeds);
  /** @param {MessageEvent<CoordinatorToEvaluator>} event */
  port.onmessage = ({ data }) => {
    let scores;
    try {
      scores = evaluator.score(data.genomes);
    } catch (error) {
      die(error);
      return;
    }
    /** @type {EvaluatorToCoordinator} */
    const reply = { type: 'scored', slice: data.slice, scores };
    port.postMessage(reply, [scores.buffer]);
  };
  return {
    disconnect: () => {
      port.onmessage = null; // because an earlier message still arrives if both ends are in one page
      port.close();
    },
    free: () => evaluator.close(),
  };
}
