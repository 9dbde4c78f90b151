// SPDX-License-Identifier: MIT
// Doxygen's descriptions as HTML: paragraphs, parameters and results.
import { escaped } from '../html.mjs';

/** @typedef {import('./names.mjs').Writer} Writer */
/** @typedef {import('./xml.mjs').Element} Element */
/** @typedef {{html: string, parameters: {names: string[], html: string}[], returns: string}} Description */

/** @type {Record<string, string>} */
const SIGNS = { ndash: '–', mdash: '—', nonbreakablespace: ' ', lsquo: '‘', rsquo: '’', ldquo: '“', rdquo: '”', sp: ' ', linebreak: ' ' };
/** @type {Record<string, string>} */
const MARKS = { emphasis: 'em', bold: 'strong', subscript: 'sub', superscript: 'sup' };
const WIDE = 30; // characters; wider code may need scrolling, as in markdown.mjs

/** @param {string} text */
export const drawing = (text) => `<pre${text.split('\n').some((line) => line.length > WIDE) ? ' tabindex="0"' : ''}><code>${escaped(text)}</code></pre>\n`;

/** The text of a paragraph. @param {(Element | string)[]} children @param {Writer} writer @returns {string} */
function inline(children, writer) {
  return children.map((child) => {
    if (typeof child === 'string') return writer.words(child.replace(/\s+/g, ' '));
    if (child.name in SIGNS) return SIGNS[child.name];
    if (child.name === 'computeroutput') return `<code>${writer.code(child.text)}</code>`;
    if (child.name in MARKS) return `<${MARKS[child.name]}>${inline(child.children, writer)}</${MARKS[child.name]}>`;
    return inline(child.children, writer);
  }).join('');
}

/** A paragraph of Doxygen, which may contain blocks. @param {Element} para @param {Writer} writer @param {Description} into */
function paragraph(para, writer, into) {
  /** @type {(Element | string)[]} */
  let words = [];
  /** @type {string[]} */
  let drawn = [];
  const flush = () => {
    const html = inline(words, writer).trim();
    if (html) into.html += `<p>${html}</p>\n`;
    if (drawn.length > 0) into.html += drawing(drawn.join('\n'));
    words = [];
    drawn = [];
  };
  for (const child of para.children) {
    const name = typeof child === 'string' ? '' : child.name;
    if (typeof child === 'string' && child.trim() === '' && drawn.length > 0) continue;
    if (typeof child === 'string' || !['preformatted', 'verbatim', 'parameterlist', 'simplesect', 'itemizedlist', 'orderedlist'].includes(name)) {
      if (drawn.length > 0) flush();
      words.push(child);
    } else if (name === 'preformatted' || name === 'verbatim') {
      drawn.push(child.text.replace(/\s+$/, ''));
    } else {
      flush();
      block(child, writer, into);
    }
  }
  flush();
}

/** @param {Element} element @param {Writer} writer @param {Description} into */
function block(element, writer, into) {
  const words = (/** @type {Element | undefined} */ one) => one?.all('para').map((para) => inline(para.children, writer).trim()).join(' ') ?? '';
  if (element.name === 'parameterlist') {
    for (const item of element.all('parameteritem')) {
      const names = item.all('parameternamelist').flatMap((list) => list.all('parametername')).flatMap(({ text }) => text.trim().split(/,\s*/));
      into.parameters.push({ names, html: words(item.one('parameterdescription')) });
    }
  } else if (element.name === 'simplesect') {
    if (element.attributes.kind === 'return') into.returns = words(element);
    else into.html += `<p>${words(element)}</p>\n`;
  } else {
    const tag = element.name === 'orderedlist' ? 'ol' : 'ul';
    into.html += `<${tag}>\n${element.all('listitem').map((item) => `<li>${words(item)}</li>`).join('\n')}\n</${tag}>\n`;
  }
}

/** The description of a symbol. @param {Element} element @param {Writer} writer @returns {Description} */
export function description(element, writer) {
  /** @type {Description} */
  const into = { html: '', parameters: [], returns: '' };
  for (const part of ['briefdescription', 'detaileddescription']) {
    for (const para of element.one(part)?.all('para') ?? []) paragraph(para, writer, into);
  }
  return into;
}
