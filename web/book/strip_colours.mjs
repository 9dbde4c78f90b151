// SPDX-License-Identifier: MIT
// Film strips as the book shows them: without their own heading, on the page's colours, and for small screens with
// nothing to read but the letters. The engine draws strips for paper (shell/export/film_strip.cpp).

/** @typedef {import('./playground.mjs').Strip} Strip */

const HEADER = 80, SIDE = 24, FOOT = 24; // what the heading and the margins take [px]
const SHEET = '<rect width="100%" height="100%" fill="#ffffff"/>';

/** The dark theme's tokens for the light theme's. @type {Record<string, string>} */
const NIGHT = {
  '#1d2733': '#e8e6e1', '#5b6672': '#98a2ad', '#8a929b': '#6b7683', '#fbfaf6': '#1b2128', '#efebe3': '#2b333c',
  '#e3dfd6': '#2b333c', '#2f5fd0': '#7ea2ff', '#ffffff': '#14181d',
};

/** @param {string} drawn  by the engine @returns {Strip} */
export function dayStrip(drawn) {
  const [, width = 0, height = 0] = (/ width="([\d.]+)" height="([\d.]+)"/.exec(drawn) ?? []).map(Number);
  if (!(width > 0) || !drawn.includes(SHEET)) throw new Error('a film strip is not drawn as it was: see web/book/strip_colours.mjs');
  const size = { width: width - 2 * SIDE, height: Math.round(height - HEADER - FOOT) };
  const svg = drawn.replace(/viewBox="[^"]*" width="[^"]*" height="[^"]*"/,
    `viewBox="${SIDE} ${HEADER} ${size.width} ${size.height}" width="${size.width}" height="${size.height}"`)
    .replace(SHEET, '');
  return { svg, ...size };
}

/** @param {Strip} strip @returns {Strip} */
export function nightStrip({ svg, ...size }) {
  return { svg: svg.replace(/#[0-9a-f]{6}/g, (colour) => NIGHT[colour] ?? colour), ...size };
}

/** Letters three times as large, in place of everything else that is written. @param {Strip} strip @returns {Strip} */
export function fewWords({ svg, ...size }) {
  return {
    svg: svg.replace(/<text ([^>]*)>([^<]*)<\/text>\n?/g, (_, style, words) => (!/^[A-Z]$/.test(words) ? ''
      : `<text ${style.replace(/ y="([\d.]+)"/, (/** @type {string} */ _y, /** @type {string} */ y) => ` y="${Number(y) + 18}"`)
        .replace(/font-size="[^"]*"/, 'font-size="38"')}>${words}</text>\n`)),
    ...size,
  };
}
