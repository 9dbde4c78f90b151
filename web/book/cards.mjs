// SPDX-License-Identifier: MIT
// Cards, as in the gallery: a heading that consists of a link to a document, a picture and text. Consecutive cards are
// shown side by side. The whole card is one link, that of its heading.
import Token from 'markdown-it/lib/token.mjs';

/** @param {string} content @returns {Token} */
function html(content) {
  const token = new Token('html_block', '', 0);
  token.content = content;
  return token;
}

/** @param {Token[]} tokens @param {number} i */
function opensCard(tokens, i) {
  const [open, inline] = [tokens[i], tokens[i + 1]];
  const parts = inline?.children ?? [];
  return open.type === 'heading_open' && parts[0]?.meta?.opens && parts[parts.length - 1].type === 'link_close'
    && parts.filter(({ type }) => type === 'link_open').length === 1;
}

/** @param {Token[]} tokens  of a page @returns {Token[]} */
export function cards(tokens) {
  /** @type {Token[]} */
  const out = [];
  let inCards = false;
  for (const [i, token] of tokens.entries()) {
    if (token.type === 'heading_open' && token.level === 0) {
      const next = opensCard(tokens, i);
      if (inCards) out.push(html(next ? '</article>\n' : '</article>\n</div>\n'));
      if (next) out.push(html(inCards ? '<article class="card">\n' : '<div class="cards">\n<article class="card">\n'));
      inCards = next;
    }
    if (inCards && token.type === 'inline') for (const child of token.children ?? []) if (child.meta?.unlinked) child.content = child.meta.unlinked;
    out.push(token);
  }
  if (inCards) out.push(html('</article>\n</div>\n'));
  return out;
}
