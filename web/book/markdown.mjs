// SPDX-License-Identifier: MIT
// Renders a page's Markdown, and extracts its headings, its first sentence and its text for the search.
import MarkdownIt from 'markdown-it';
import { BLOCKS } from './blocks.mjs';
import { cards } from './cards.mjs';
import { firstSentence, HeadingNames } from './headings.mjs';
import { attributes, escaped } from './html.mjs';
import { sections as lessonSections } from './sections.mjs';
import { laidOver } from './languages/overlay.mjs';
import { stripPictures } from './strip_pictures.mjs';

/** @typedef {import('markdown-it/lib/token.mjs').default} Token */
/** @typedef {import('./headings.mjs').Heading} Heading */
/** @typedef {import('./links.mjs').Links} Links */
/** @typedef {import('./links.mjs').Opens} Opens */
/** @typedef {import('./pages.mjs').Page} Page */
/** Text under a heading. @typedef {{heading: string, id: string, text: string}} Section */
/** The first film strip of a page, and its words. @typedef {{name: string, strips: import('./playground.mjs').Strips, alt: string}} Strip */
/** @typedef {{html: string, title: string, sentence: string, headings: Heading[], sections: Section[], strip?: Strip}} Rendered */

const NUMBER = /^[-−+<>≤≥±~≈]?\s*\d[\d.,]*(\s*[\p{L}%²/·]+)?$/u;
const WIDE_CODE = 30; // characters; wider code may need scrolling, also with keys

/** A link's data for the lesson's script. @param {Opens} opens */
const opening = ({ payload, panels, lock, goal }) => ({ 'data-open': payload, 'data-panels': panels, 'data-lock': lock, 'data-goal': goal });

export class Markdown {
  #markdown = new MarkdownIt({ html: false });
  /** @type {Map<Page, Strip>} */
  #firstStrips = new Map();
  /** Of pages with translations. @type {Map<Page, {headings: Heading[], blocks: string[]}>} */
  #originals = new Map();

  /** @param {Links} links */
  constructor(links) {
    this.links = links;
    this.faults = links.faults;
    const { rules } = this.#markdown.renderer;
    rules.table_open = () => '<div class="scroll" tabindex="0"><table>\n';
    rules.table_close = () => '</table></div>\n';
    // The empty corner cell of a table is not a header.
    const name = (/** @type {string} */ content, end = false) => (content === '' ? 'td' : end ? 'th' : 'th scope="col"');
    rules.th_open = (tokens, i) => `<${name(tokens[i + 1].content)}${attributes({ class: cellClass(tokens[i], '') })}>`;
    rules.th_close = (tokens, i) => `</${name(tokens[i - 1].content, true)}>`;
    rules.td_open = (tokens, i) => `<td${attributes({ class: cellClass(tokens[i], tokens[i + 1].content) })}>`;
    rules.fence = rules.code_block = (tokens, i) => {
      const { meta, content } = tokens[i];
      const wide = content.split('\n').some((line) => line.length > WIDE_CODE);
      return meta?.html ?? `<pre${wide ? ' tabindex="0"' : ''}><code>${escaped(content)}</code></pre>\n`;
    };
  }

  /** A translation after its original. @param {Page} page @returns {Promise<Rendered>} */
  async render(page) {
    const tokens = this.#markdown.parse(page.body, {});
    const names = new HeadingNames();
    /** @type {Heading[]} */
    const headings = [];
    /** @type {Section[]} */
    const sections = [{ heading: page.lesson?.title ?? '', id: '', text: '' }];
    const original = page.original && this.#originals.get(page.original);
    /** @type {string[]} */
    const blocks = [];
    let paragraph = '';
    for (const [i, token] of tokens.entries()) {
      const line = page.before + (token.map?.[0] ?? 0) + 1;
      if (token.type === 'heading_open') {
        const text = plain(tokens[i + 1]);
        // A heading has the same name in all languages, so that a change of language stays at the place.
        const heading = { level: Number(token.tag.slice(1)), text, id: original?.headings[headings.length]?.id ?? names.name(text) };
        headings.push(heading);
        if (heading.level === 1) sections[0].heading = text;
        else {
          token.attrSet('id', heading.id);
          sections.push({ heading: text, id: heading.id, text: '' });
        }
      } else if (token.type === 'inline') {
        if (tokens[i - 1].type === 'paragraph_open') paragraph ||= plain(token);
        if (tokens[i - 1].type !== 'heading_open') sections[sections.length - 1].text += `${plain(token)}\n`;
        await this.#connect(page, token, line);
      } else if (token.type === 'fence') {
        token.content = laidOver(token.info.trim(), original?.blocks[blocks.length] ?? '', page, line, token.content, this.faults);
        blocks.push(token.content);
        await this.#block(page, token, line);
        if (!token.meta) sections[sections.length - 1].text += `${token.content}\n`;
      }
    }
    const titles = headings.filter(({ level }) => level === 1);
    if (titles.length !== (page.lesson ? 0 : 1)) {
      this.faults.add(page.source, page.before + 1, page.lesson ? 'the title of a lesson stands between its --- lines, not in a heading of its own' : 'a page has one heading of the first order');
    }
    const html = this.#markdown.renderer.render(page.lesson ? lessonSections(tokens, page.language.tr) : cards(tokens), { html: false }, {});
    if (!page.original) this.#originals.set(page, { headings, blocks });
    return { html, title: sections[0].heading, sentence: firstSentence(paragraph), headings, sections, strip: this.#firstStrips.get(page) };
  }

  /** Renders inline text of a block. @param {Page} page @param {number} line @param {string} text */
  async inline(page, line, text) {
    const tokens = this.#markdown.parseInline(text, {});
    for (const token of tokens) await this.#connect(page, token, line);
    return this.#markdown.renderer.render(tokens, { html: false }, {});
  }

  /** Resolves the links and images in a text. @param {Page} page @param {Token} inline @param {number} first  its line */
  async #connect(page, inline, first) {
    const { children } = inline;
    if (!children) return;
    let linked = false;
    let leads = true;
    for (const child of children) {
      const href = String(child.attrGet(child.type === 'image' ? 'src' : 'href') ?? '');
      const line = first + Math.max(0, inline.content.split('\n').findIndex((text) => text.includes(href)));
      if (child.type === 'link_open') {
        linked = true;
        const { href: way, opens } = await this.links.resolve(page, line, href);
        child.attrSet('href', way);
        leads = way !== '';
        child.hidden = !leads;
        if (opens) child.meta = { opens };
        if (opens && page.lesson) for (const [name, value] of Object.entries(opening(opens))) if (value !== undefined) child.attrSet(name, value);
      } else if (child.type === 'link_close') {
        linked = false;
        child.hidden = !leads;
      } else if (child.type === 'image') {
        if (/\.json(\?|$)|#./.test(href)) await this.#strip(page, child, line, href, linked);
        else child.attrSet('src', this.links.image(page, line, href));
        child.attrSet('loading', 'lazy');
      }
    }
  }

  /** Renders an image of a document as its film strip. @param {Page} page @param {Token} image @param {number} line @param {string} path @param {boolean} linked */
  async #strip(page, image, line, path, linked) {
    const { href, opens } = await this.links.resolve(page, line, path);
    if (!opens) return image.attrSet('src', href);
    const strip = await this.links.strip(page, path);
    const alt = image.content;
    if (!this.#firstStrips.has(page)) this.#firstStrips.set(page, { ...strip, alt });
    if (alt.trim() === '') this.faults.add(page.source, line, 'a film strip needs words in its square brackets, for who cannot see it');
    const pictures = stripPictures(strip, alt, (address) => this.links.way(page, address));
    const shown = `<span class="strip">${pictures}</span>`;
    image.type = 'html_inline';
    image.content = linked ? shown : `<a${attributes({ class: 'strip', href, ...(page.lesson ? opening(opens) : {}) })}>${pictures}</a>`;
    image.meta = { unlinked: shown };
  }

  /** @param {Page} page @param {Token} token @param {number} line */
  async #block(page, token, line) {
    const kind = token.info.trim();
    if (!Object.hasOwn(BLOCKS, kind)) return;
    if (!page.lesson && kind !== 'stage') {
      this.faults.add(page.source, line, `only lessons have blocks of the kind "${kind}"`);
      return;
    }
    token.meta = { html: await BLOCKS[kind](this, page, token.content, line) };
  }
}

/** Classes for a cell's alignment, because the page's security policy forbids style attributes. @param {Token} cell @param {string} content */
function cellClass(cell, content) {
  const [, alignment] = /text-align:(center|right)/.exec(String(cell.attrGet('style') ?? '')) ?? [];
  return [alignment, NUMBER.test(content) ? 'number' : ''].filter(Boolean).join(' ') || undefined;
}

/** The text of a line, without markup. @param {Token} token */
function plain(token) {
  return (token.children ?? []).map(({ type, content }) => (type === 'softbreak' || type === 'hardbreak' ? ' ' : ['text', 'code_inline', 'image'].includes(type) ? content : '')).join('');
}
