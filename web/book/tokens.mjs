// SPDX-License-Identifier: MIT
// Takes the book's colours from the playground's style sheet, so that they are always the same.
import { readFile } from 'node:fs/promises';

/** @param {string} stylesheet  web/page/style.css @returns {Promise<string>} CSS */
export async function tokens(stylesheet) {
  const css = await readFile(stylesheet, 'utf8');
  /** By theme. '': the default. @type {Map<string, string>} */
  const themes = new Map();
  for (const [, , theme = '', colours] of css.matchAll(/^:root(\[data-theme="([\w-]+)"\])? \{([^}]*--paper:[^}]*)\}/gm)) themes.set(theme, colours.trim());
  for (const theme of ['', 'dark', 'strong-light', 'strong-dark']) if (!themes.has(theme)) throw new Error(`web/page/style.css has no colours for the theme "${theme}"`);
  const unnamed = (/** @type {string} */ query, /** @type {string} */ theme) => `@media ${query} { :root:not([data-theme]) { ${themes.get(theme)} } }`;
  return ['/* SPDX-License-Identifier: MIT */', `:root { ${themes.get('')} }`,
    // Without JavaScript the system's theme applies.
    unnamed('(prefers-color-scheme: dark)', 'dark'),
    unnamed('(prefers-contrast: more)', 'strong-light'),
    unnamed('(prefers-contrast: more) and (prefers-color-scheme: dark)', 'strong-dark'),
    ...[...themes].filter(([theme]) => theme !== '').map(([theme, colours]) => `:root[data-theme="${theme}"] { ${colours} }`),
    `@media print { :root:root { ${themes.get('')} } }`, ''].join('\n');
}
