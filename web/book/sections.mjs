// SPDX-License-Identifier: MIT
// What a lesson's sections bring with them: Notice waits until the goal is reached, Explain has a field to write in.
import Token from 'markdown-it/lib/token.mjs';

/** @param {string} content @returns {Token} */
function html(content) {
  const token = new Token('html_block', '', 0);
  token.content = content;
  return token;
}

const FIELD = `<p class="write"><label for="sentences">Your sentences</label>
<textarea id="sentences" rows="4" maxlength="4000"></textarea></p>
`;

/** @param {Token[]} tokens  of a lesson @returns {Token[]} */
export function sections(tokens) {
  /** @type {Token[]} */
  const out = [];
  let section = '', written = false;
  const end = () => { if (section === 'Notice') out.push(html('</div>\n')); };
  for (const [i, token] of tokens.entries()) {
    if (token.type === 'heading_open' && token.tag === 'h2') {
      end();
      section = tokens[i + 1].content;
    }
    out.push(token);
    if (section === 'Notice' && token.type === 'heading_close' && token.tag === 'h2') out.push(html('<div id="observations">\n'));
    if (section === 'Explain' && token.type === 'paragraph_close' && !written) {
      written = true;
      out.push(html(FIELD));
    }
  }
  end();
  return out;
}
