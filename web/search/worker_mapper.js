// SPDX-License-Identifier: MIT
// The mapper's role: scores the moments at which a clip could take over, and sends the scores part by part.

/** @typedef {import('./messages.js').MapperMessage} MapperMessage */

// Longest time for a part. The first parts are a coarse picture of the whole.
const PART_MS = 100;
const STRIDE = 4; // moments between two readings of the clock

/**
 * @param {import('./engine.js').Engine} engine
 * @param {import('./messages.js').MapTransitions} role
 * @param {(message: MapperMessage, transfer?: Transferable[]) => void} post
 * @param {(error: unknown) => void} die  ends the role after an error
 * @param {number} [partMs]  time after which a part is sent
 * @returns {import('./worker_roles.js').ActiveRole}
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
    if (next < count) timer = setTimeout(part); // lets messages in between parts
  };
  let timer = setTimeout(part);
  return { disconnect: () => clearTimeout(timer), free: () => map.close() };
}
