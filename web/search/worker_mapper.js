// SPDX-License-Identifier: MIT
// The mapper's role: scores the moments at which a clip could take over, part by part, and tells each part.

/** @typedef {import('./messages.js').OfMapper} OfMapper */

// A part is told after this long, or sooner: the first ones are a coarse picture of the whole.
const PART_MS = 100;
const STRIDE = 4; // moments between two looks at the clock

/**
 * @param {import('./engine.js').Engine} engine
 * @param {import('./messages.js').MapTransitions} role
 * @param {(message: OfMapper, transfer?: Transferable[]) => void} post
 * @param {(error: unknown) => void} die  then it is let go
 * @param {number} [partMs]  after which a part is told
 * @returns {import('./worker_roles.js').Holdings}
 */
export function startMapper(engine, { document, generation }, post, die, partMs = PART_MS) {
  const map = engine.transitionMap(document);
  const { count, usual } = map;
  let next = 0;
  const part = () => {
    const start = performance.now();
    const first = next;
    /** @type {number[]} */
    const known = [];
    try {
      while (next < count && (known.length === 0 || performance.now() - start < partMs)) {
        const scores = map.scores(next, Math.min(STRIDE, count - next));
        known.push(...scores);
        next += scores.length;
      }
    } catch (error) {
      die(error);
      return;
    }
    const scores = Float32Array.from(known);
    post({ type: 'mapped', generation, count, first, scores, usual }, [scores.buffer]);
    if (next < count) timer = setTimeout(part); // messages come in between
  };
  let timer = setTimeout(part);
  return { letGo: () => clearTimeout(timer), free: () => map.close() };
}
