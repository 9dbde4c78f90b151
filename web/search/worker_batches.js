// SPDX-License-Identifier: MIT
// How many genomes the coordinator has proposed at once, and how it cuts them into slices.

/** Number of motions that the engine simulates in parallel. A slice that is not a multiple leaves lanes empty. */
export const LANES = 4;

// Genomes per evaluator and batch. Larger batches lose less time between batches. But a search that looks ahead wastes
// more, above all at its start, when every fourth guess is an improvement. So the size follows the waste, measured over
// several batches. It never changes the result.
const SIZES = [LANES, 2 * LANES, 3 * LANES, 5 * LANES, 10 * LANES];
const FIRST_SIZE = 2;
const BATCHES_PER_MEASURE = 16;
// Simulated ÷ counted. Measured over the first 20,000 evaluations of a population of ten: 1.07 with 40 a batch, 1.17
// with 80.
const HIGH_WASTE = 1.12;
const LOW_WASTE = 1.04;

export class BatchSize {
  #size = FIRST_SIZE; // index into SIZES
  #batches = 0; // since the size was chosen; the numbers below are from then
  #simulated = 0;
  #evaluations;

  /** @param {number} evaluations  that the search has counted */
  constructor(evaluations) { this.#evaluations = evaluations; }

  get perEvaluator() { return SIZES[this.#size]; }

  /** After every batch. @param {number} simulated  in all @param {number} evaluations  of these, counted by the search */
  fit(simulated, evaluations) {
    if (++this.#batches < BATCHES_PER_MEASURE) return;
    const waste = (simulated - this.#simulated) / Math.max(1, evaluations - this.#evaluations);
    if (waste > HIGH_WASTE) this.#size = Math.max(0, this.#size - 1);
    if (waste < LOW_WASTE) this.#size = Math.min(SIZES.length - 1, this.#size + 1);
    this.#batches = 0;
    this.#simulated = simulated;
    this.#evaluations = evaluations;
  }
}

/**
 * Cuts genomes into slices of at most `max`, as evenly as whole lanes allow.
 * @param {number} count  of genomes @param {number} max
 * @returns {{first: number, count: number}[]}
 */
export function cut(count, max) {
  const rows = Math.ceil(count / LANES);
  const slices = Math.max(1, Math.ceil(rows / Math.ceil(max / LANES)));
  return Array.from({ length: slices }, (_, i) => {
    const first = LANES * Math.floor((i * rows) / slices);
    return { first, count: Math.min(count, LANES * Math.floor(((i + 1) * rows) / slices)) - first };
  });
}
