// SPDX-License-Identifier: MIT
// Adapts the engine's film strips, which are drawn for paper (shell/export/film_strip.cpp), to the book: without
// heading, in the page's colours, and with larger letters, since they are shown at half their size or less.

/** @typedef {import('./playground.mjs').Strip} Strip */

const HEADER = 80, SIDE = 31, FOOT = 24; // heading and margins [px]
const LEGEND_ROW = 24, LEGEND_GROWTH = 1.6;
const SHEET = '<rect width="100%" height="100%" fill="#ffffff"/>';
const LEGEND = /<rect x="([\d.]+)" y="([\d.]+)" width="18" height="4" rx="2"/;
const UNDERLINE = /(<rect x="[\d.]+" y=")([\d.]+)(" width="26" height="3.5")/g;
const TEXT = /<text ([^>]*?) y="([\d.]+)"([^>]*)>([^<]*)<\/text>\n?/g;

/** Text sizes on a strip with many and with few poses, and how far the texts move down [px]. Size 0: left out. */
const TYPE = {
  many: { letter: 24, letterDown: -1, time: 18, underlineDown: 1.5 },
  few: { letter: 40, letterDown: 16, time: 0, underlineDown: 18 },
};

/** The dark theme's colours by the light theme's. @type {Record<string, string>} */
const NIGHT = {
  '#1d2733': '#e8e6e1', '#5b6672': '#98a2ad', '#8a929b': '#6b7683', '#fbfaf6': '#1b2128', '#efebe3': '#2b333c',
  '#e3dfd6': '#2b333c', '#2f5fd0': '#7ea2ff', '#ffffff': '#14181d',
};

/** @param {string} drawn  by the engine @param {keyof typeof TYPE} kind @returns {Strip} */
export function dayStrip(drawn, kind) {
  const [, width = 0, height = 0] = (/ width="([\d.]+)" height="([\d.]+)"/.exec(drawn) ?? []).map(Number);
  if (!(width > 0) || !drawn.includes(SHEET)) throw new Error('a film strip is not drawn as it was: see web/book/strip_colours.mjs');
  const legend = LEGEND.exec(drawn);
  const [poses, words] = legend ? [drawn.slice(0, legend.index), drawn.slice(legend.index, drawn.indexOf('</svg>'))] : [drawn.replace('</svg>\n', ''), ''];
  const legendSvg = legend && kind === 'many' ? enlarged(words, Number(legend[1]), Number(legend[2])) : '';
  const size = { width: width - 2 * SIDE, height: Math.round(height - HEADER - FOOT + (legendSvg ? 8 : legend ? -LEGEND_ROW : 0)) };
  const svg = restyled(poses, TYPE[kind])
    .replace(/viewBox="[^"]*" width="[^"]*" height="[^"]*"/, `viewBox="${SIDE} ${HEADER} ${size.width} ${size.height}" width="${size.width}" height="${size.height}"`)
    .replace(SHEET, '');
  return { svg: `${svg}${legendSvg}</svg>\n`, ...size };
}

/** @param {Strip} strip @returns {Strip} */
export function nightStrip({ svg, ...size }) {
  return { svg: svg.replace(/#[0-9a-f]{6}/g, (colour) => NIGHT[colour] ?? colour), ...size };
}

/**
 * The same drawing for light and for dark: dark where its address ends in #night. One file in place of two, of which the second differed only in its colours.
 * @param {Strip} strip @returns {string}
 */
export function dayAndNight({ svg }) {
  const rules = Object.entries(NIGHT).flatMap(([day, night]) => ['fill', 'stroke'].filter((paint) => svg.includes(`${paint}="${day}"`))
    .map((paint) => `#night:target [${paint}="${day}"]{${paint}:${night}}`));
  return svg.replace(/<svg ([^>]*)>\n?/, (_, drawn) => `<svg id="night" ${drawn}>\n<style>#night:target{fill:${NIGHT['#1d2733']}}${rules.join('')}</style>\n`);
}

/** Enlarges the controllers' names. @param {string} legend @param {number} x @param {number} y  its place */
function enlarged(legend, x, y) {
  const growth = (origin = 0) => (origin * (1 - LEGEND_GROWTH)).toFixed(1);
  return `<g transform="translate(${growth(x)} ${growth(y - 4)}) scale(${LEGEND_GROWTH})">\n${legend}</g>\n`;
}

/** @param {string} svg @param {typeof TYPE.many} type */
function restyled(svg, { letter, letterDown, time, underlineDown }) {
  const sized = (/** @type {string} */ style, /** @type {number} */ size) => `${style.replace(/ ?font-size="[^"]*"/, '')} font-size="${size}"`;
  return svg
    .replace(UNDERLINE, (_, before, y, after) => `${before}${Number(y) + underlineDown}${after}`)
    .replace(TEXT, (_, before, y, style, words) => {
      if (/^[A-Z]$/.test(words)) return `<text ${before} y="${Number(y) + letterDown}"${sized(style, letter)}>${words}</text>\n`;
      return time > 0 && / s$/.test(words) && style.includes('middle') ? `<text ${before} y="${Number(y) + 4}"${sized(style, time)}>${words}</text>\n` : '';
    });
}
