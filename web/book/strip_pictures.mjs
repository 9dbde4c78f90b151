// SPDX-License-Identifier: MIT
// A film strip as HTML: one drawing for light and one for dark themes, each with fewer poses for narrow places.
import { attributes } from './html.mjs';

/**
 * @param {{name: string, strips: import('./playground.mjs').Strips}} strip @param {string} alt
 * @param {(address: string) => string} way  from the page to an address of the book @param {{few?: boolean}} [options]  few: never all poses
 */
export function stripPictures({ name, strips: { many, few } }, alt, way, { few: onlyFew = false } = {}) {
  const picture = (/** @type {string} */ when, /** @type {string} */ ending) => {
    const file = (/** @type {string} */ which) => way(`strips/${name}${which}.svg${ending}`);
    const size = (/** @type {{width: number, height: number}} */ { width, height }) => ({ width: String(width), height: String(height) });
    const source = onlyFew ? '' : `<source media="(max-width: 40em)"${attributes({ srcset: file('-few'), ...size(few) })}>`;
    return `<picture class="${when}">${source}<img${attributes({ src: file(onlyFew ? '-few' : ''), alt, ...size(onlyFew ? few : many), loading: 'lazy' })}></picture>`;
  };
  return picture('by-day', '') + picture('by-night', '#night');
}
