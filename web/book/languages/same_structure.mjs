// SPDX-License-Identifier: MIT
// Compares a translated page with its English original. A lesson, or a text with live stages, has the same paragraphs,
// lists, tables, blocks, links and numbers. Other texts have the same headings: their paragraphs may differ.
import { posix } from 'node:path';
import MarkdownIt from 'markdown-it';
import { numbersIn } from './numbers.mjs';
import { isStrict } from './overlay.mjs';

/** @typedef {import('markdown-it/lib/token.mjs').default} Token */
/** @typedef {import('../faults.mjs').Faults} Faults */
/** @typedef {import('../pages.mjs').Page} Page */

const NAMES = /** @type {Record<string, string>} */ ({
  paragraph_open: 'a paragraph', bullet_list_open: 'a list', ordered_list_open: 'a numbered list', list_item_open: 'an item of a list', table_open: 'a table',
  tr_open: 'a row of a table', td_open: 'a cell', th_open: 'a cell', blockquote_open: 'a quotation', code_block: 'code',
});

/** @param {Page} page  a translation @param {Faults} faults */
export function compareWithOriginal(page, faults) {
  const { original } = page;
  if (!original) return;
  const strict = isStrict(original);
  const [wanted, given] = [original, page].map(({ body }) => partsOf(body, strict));
  for (let i = 0; i < Math.max(wanted.length, given.length); i++) {
    const [one, other] = [wanted[i], given[i]];
    const line = page.before + (other?.map?.[0] ?? page.body.trimEnd().split('\n').length - 1) + 1;
    const where = one ? `${original.source}:${original.before + (one.map?.[0] ?? 0) + 1}` : original.source;
    if (!one || !other || shapeOf(one) !== shapeOf(other)) {
      faults.add(page.source, line, `${where} has ${one ? nameOf(one) : 'nothing more'} here, this page has ${other ? nameOf(other) : 'nothing more'}`);
      return;
    }
    if (!strict || one.type !== 'inline') continue;
    const [links, otherLinks] = [linksOf(one, original), linksOf(other, page)];
    if (links !== otherLinks) faults.add(page.source, line, `${where} links ${links || 'nothing'}, this page ${otherLinks || 'nothing'}`);
    const [numbers, otherNumbers] = [numbersIn(textOf(one), original), numbersIn(textOf(other), page)];
    if (numbers !== otherNumbers) faults.add(page.source, line, `${where} has the numbers ${numbers || '(none)'}, this page ${otherNumbers || '(none)'}`);
  }
}

/** The parts that must agree. @param {string} body @param {boolean} strict */
function partsOf(body, strict) {
  const tokens = new MarkdownIt({ html: false }).parse(body, {});
  return tokens.filter(({ type }) => (strict ? !type.endsWith('_close') : type === 'heading_open'));
}

/** @param {Token} token */
const shapeOf = ({ type, tag, info, content }) => ((type === 'fence' && !info.trim()) || type === 'code_block' ? content : `${type} ${tag} ${info.trim()}`);

/** @param {Token} token */
const nameOf = ({ type, tag, info }) => NAMES[type] ?? (type === 'heading_open' ? `a heading ${'#'.repeat(Number(tag.slice(1)))}`
  : type === 'fence' ? `a block of the kind "${info.trim()}"` : `a part of the kind "${type}"`);

/** Its links and pictures, as paths of the English files. @param {Token} inline @param {Page} page */
function linksOf({ children }, page) {
  return (children ?? []).flatMap((token) => {
    const address = String(token.attrGet(token.type === 'image' ? 'src' : 'href') ?? '');
    if (!address || !['image', 'link_open'].includes(token.type)) return [];
    if (/^(https?:|#)/.test(address)) return [address];
    const path = posix.normalize(posix.join(posix.dirname(page.source), address));
    return [path.replace(new RegExp(`^docs/${page.language.code}/`), 'docs/')];
  }).sort().join(', ');
}

/** @param {Token} inline */
const textOf = ({ children }) => (children ?? []).map(({ type, content }) => (['text', 'code_inline', 'image'].includes(type) ? content : ' ')).join('');
