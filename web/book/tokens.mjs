// SPDX-License-Identifier: MIT
// The playground's colours for the book, taken from its style sheet so that the two cannot differ.
import { readFile } from 'node:fs/promises';

/** @param {string} stylesheet  web/page/style.css @returns {Promise<string>} CSS */
export async function tokens(stylesheet) {
  const css = await readFile(stylesheet, 'utf8');
  /** By theme; '': the one that needs no name. @type {Map<string, string>} */
  const themes = new Map();
  for (const [, , theme = '', colours] of css.matchAll(/^:root(\[data-theme="([\w-]+)"\])? \{([^}]*--paper:[^}]*)\}/gm)) themes.set(theme, colours.trim());
  for (const theme of ['', 'dark', 'strong-light', 'strong-dark']) if (!themes.has(theme)) throw new Error(`web/page/style.css has no colours for the theme "${theme}"`);
  const unnamed = (/** @type {string} */ query, /** @type {string} */ theme) => `@media ${query} { :root:not([data-theme]) { ${themes.get(theme)} } }`;
  return ['/* SPDX-License-Identifier: MIT */', `:root { ${themes.get('')} }`,
    // Where no script says what was chosen, the system does.
    unnamed('(prefers-color-scheme: dark)', 'dark'),
    unnamed('(prefers-contrast: more)', 'strong-light'),
    unnamed('(prefers-contrast: more) and (prefers-color-scheme: dark)', 'strong-dark'),
    ...[...themes].filter(([theme]) => theme !== '').map(([theme, colours]) => `:root[data-theme="${theme}"] { ${colours} }`),
    `@media print { :root:root { ${themes.get('')} } }`, ''].join('\n');
}
