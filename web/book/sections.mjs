// SPDX-License-Identifier: MIT
// What a lesson's sections bring with them: Notice waits until the goal is reached, Explain has a field to write in.
import Token from 'markdown-it/lib/token.mjs';

/** @param {string} content @returns {Token} */
function html(content) {
  const token = new Token('html_block', '', 0);
  token.content = content;
  return token;
}

/** @param {Translate} tr */
const field = (tr) => `<p class="write"><label for="sentences">${tr('Your sentences')}</label>
<textarea id="sentences" rows="4" maxlength="4000"></textarea></p>
`;

/** @typedef {import('./languages/words.mjs').Translate} Translate */

/** @param {Token[]} tokens  of a lesson, with the names of the English headings @param {Translate} tr @returns {Token[]} */
export function sections(tokens, tr) {
  /** @type {Token[]} */
  const out = [];
  let section = '', written = false;
  const end = () => { if (section === 'notice') out.push(html('</div>\n')); };
  for (const token of tokens) {
    if (token.type === 'heading_open' && token.tag === 'h2') {
      end();
      section = String(token.attrGet('id'));
    }
    out.push(token);
    if (section === 'notice' && token.type === 'heading_close' && token.tag === 'h2') out.push(html('<div id="observations">\n'));
    if (section === 'explain' && token.type === 'paragraph_close' && !written) {
      written = true;
      out.push(html(field(tr)));
    }
  }
  end();
  return out;
}
