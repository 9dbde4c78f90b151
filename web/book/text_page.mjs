// SPDX-License-Identifier: MIT
// The page of a text in docs/.
import { escaped } from './html.mjs';

/** @typedef {import('./markdown.mjs').Rendered} Rendered */
/** @typedef {import('./pages.mjs').Page} Page */

const DATE = / \(\d{4}-\d\d-\d\d\)$/; // of a decision, left out of the contents
const MIN_HEADINGS = 4; // for a table of contents

/** @param {Page} page @param {Rendered} rendered @param {string} group @returns {import('./template.mjs').Sheet} */
export function textPage(page, { html, title, sentence, headings }, group) {
  const { language } = page;
  const { tr } = language;
  const parts = headings.filter(({ level }) => level === 2);
  const contents = parts.length < MIN_HEADINGS ? '' : `<nav class="contents" aria-label="${tr('On this page')}">
<p>${tr('On this page')}</p>
<ul>
${parts.map(({ id, text }) => `<li><a href="#${id}">${escaped(text.replace(DATE, ''))}</a></li>`).join('\n')}
</ul>
</nav>
`;
  return {
    title, description: sentence, address: page.address, language,
    kind: page.name === 'gallery' ? 'page wide' : 'page',
    ...html.includes('<figure class="stage"') ? { styles: ['explorable.css'], scripts: ['../explorable/explorable.js'], engine: true } : {},
    body: `<div class="spread">
<main id="main" tabindex="-1">
${tr(group) === title ? '' : `<p class="group">${escaped(tr(group))}</p>\n`}${html}</main>
${contents}</div>`,
  };
}
