// SPDX-License-Identifier: MIT
// Words for how motions look (core/signal/traits.h).
import { tr, trLater } from '../languages/language.js';

/** By name of the trait. */
const WORDS = /** @type {Record<string, string>} */ ({
  speed: trLater('Speed'),
  height: trLater('Height'),
  slip: trLater('Slipping'),
  turns: trLater('Turns'),
  effort: trLater('Much movement'),
  upright: trLater('Upright'),
  smoothness: trLater('Smooth'),
  head_height: trLater('Head up'),
  bounce: trLater('Bounce'),
  air: trLater('In the air'),
  support: trLater('On the ground'),
  steps: trLater('Steps'),
  still: trLater('Standing still'),
});

/** @typedef {{name: string, unit: string, scale: number}} Trait */

/** @param {string} name */
export const traitWords = (name) => tr(WORDS[name] ?? name);

const TELLING = 0.3; // scales from the others' mean
const MOST_NAMED = 3;

/**
 * What a motion has more and less of than the others beside it: at most three traits each, most different first, and at
 * least one in all.
 * @param {Float32Array} traits @param {Float32Array[]} others @param {Trait[]} table
 */
export function differences(traits, others, table) {
  const apart = table.map(({ name, scale }, i) => {
    const mean = others.reduce((sum, other) => sum + other[i], 0) / Math.max(1, others.length);
    return { name, apart: (traits[i] - mean) / scale };
  });
  const telling = Math.min(TELLING, Math.max(...apart.map((one) => Math.abs(one.apart))));
  const named = (/** @type {number} */ sign) => apart.filter((one) => sign * one.apart >= telling)
    .sort((a, b) => sign * (b.apart - a.apart)).slice(0, MOST_NAMED).map(({ name }) => traitWords(name));
  return { more: named(1), less: named(-1) };
}
