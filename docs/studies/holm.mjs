// SPDX-License-Identifier: MIT
/** Adjusted for all of one family [Holm 1979]. @param {number[]} p */
export function holm(p) {
  let most = 0;
  const adjusted = new Map([...p.entries()].sort(([, a], [, b]) => a - b)
    .map(([at, value], rank) => [at, most = Math.max(most, Math.min(1, value * (p.length - rank)))]));
  return p.map((_, at) => adjusted.get(at) ?? 1);
}
