// SPDX-License-Identifier: MIT
// The manual page of the program: docs/command-line.md in the language of man.
import MarkdownIt from 'markdown-it';

/** @typedef {import('markdown-it/lib/token.mjs').default} Token */

/** Text that roff takes as it is. @param {string} text */
const escaped = (text) => text.replaceAll('\\', '\\e').replaceAll('-', '\\-').replaceAll('\'', '\\(aq').replaceAll('`', '\\(ga');

/** One line of roff, which does not begin as a request. @param {Token | undefined} token */
function lineOf(token) {
  const line = (token?.children ?? []).map(({ type, content }) => {
    switch (type) {
      case 'text': return escaped(content);
      case 'code_inline': return `\\fB${escaped(content).replaceAll(',', ',\\:')}\\fR`; // a long list may break after a comma
      case 'softbreak': return ' ';
      case 'link_open': case 'link_close': return '';
      default: throw new Error(`the manual page has no ${type}`);
    }
  }).join('').trim();
  return line.startsWith('.') ? `\\&${line}` : line;
}

/** A table as a list. In wider ones the further columns have their names with them. @param {string[][]} rows */
function listOf([head, ...rows]) {
  return rows.flatMap(([first, second, ...others]) => ['.TP', first,
    [second, ...others.map((text, i) => `${head[i + 2]}: ${text}`)].join('; ') || '\\&']);
}

/**
 * @param {string} markdown
 * @param {{version: string, description: string, date: string}} about  date: such as 2026-11-29
 */
export function manualPage(markdown, { version, description, date }) {
  const tokens = new MarkdownIt({ html: false }).parse(markdown, {});
  const lines = [
    `.TH GAITSMITH 1 ${date} "gaitsmith ${version}" "User Commands"`,
    '.ad l', '.nh',
    '.SH NAME', `gaitsmith \\- ${escaped(description)}`,
    '.SH SYNOPSIS', '\\fBgaitsmith\\fR \\fICOMMAND\\fR [\\fIargument\\fR ...]', '.br', '\\fBgaitsmith\\fR \\fICOMMAND\\fR \\fB\\-\\-help\\fR',
    '.SH DESCRIPTION',
  ];
  /** Of the table that is being read. @type {string[][]} */
  let rows = [];
  for (const [i, token] of tokens.entries()) {
    switch (token.type) {
      case 'heading_open':
        if (token.tag !== 'h1') lines.push(`.${token.tag === 'h2' ? 'SH' : 'SS'} ${lineOf(tokens[i + 1]).toUpperCase().replaceAll('\\FB', '').replaceAll('\\FR', '')}`);
        break;
      case 'paragraph_open': lines.push('.PP', lineOf(tokens[i + 1])); break;
      case 'code_block': case 'fence': lines.push('.PP', '.RS', '.nf', ...token.content.trimEnd().split('\n').map((line) => `\\&${escaped(line)}`), '.fi', '.RE'); break;
      case 'table_open': rows = []; break;
      case 'tr_open': rows.push([]); break;
      case 'th_open': case 'td_open': rows[rows.length - 1].push(lineOf(tokens[i + 1])); break;
      case 'table_close': lines.push(...listOf(rows)); break;
    }
  }
  return `${lines.join('\n')}\n`;
}
