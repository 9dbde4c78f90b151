// SPDX-License-Identifier: MIT
// Makes the page of a lesson from its file's text as the book's build does, in the browser.
import { Faults } from '../faults.mjs';
import { ENGLISH } from '../languages/english.mjs';
import { lessonPage } from '../lesson_page.mjs';
import { Links } from '../links.mjs';
import { Markdown } from '../markdown.mjs';
import { Playground } from '../playground.mjs';
import { lessonOf } from './lesson_file.mjs';

/** @typedef {import('./sources.mjs').Sources} Sources */
/** line: of the file, from 1 @typedef {{line: number, sentence: string}} Fault */

/** A film strip's address in the book, for its place among Links.strips. */
const STRIP = /^strips\/(.*?)(-few)?\.svg(#night)?$/;

/** Film strips are not files yet: their addresses hold them. */
class PreviewLinks extends Links {
  /** @param {import('../pages.mjs').Page} page @param {string} address */
  way(page, address) {
    const [, name = '', few, night] = STRIP.exec(address) ?? [];
    const strips = this.strips.get(name);
    if (!strips) return super.way(page, address);
    const { svg } = strips[few ? (night ? 'fewByNight' : 'few') : night ? 'manyByNight' : 'many'];
    return `data:image/svg+xml,${encodeURIComponent(svg)}`;
  }
}

export class Preview {
  #pages;
  #ids;
  #known;
  /** Kept from one preview to the next, because motions are simulated for them. */
  #strips = new Map();

  /** @param {import('../../search/engine.js').Engine} engine @param {import('../../page/goal_conditions.js').Tables} tables @param {Sources} sources */
  constructor(engine, tables, { pages, images, documents }) {
    this.#pages = pages.map(({ source, address }) => ({ source, address, name: '', body: '', before: 0, language: ENGLISH }));
    this.#ids = new Map(pages.map(({ source, ids }) => [source, ids]));
    this.#known = new Set([...pages.map(({ source }) => source), ...images, ...Object.keys(documents)]);
    this.playground = new Playground(engine, tables, async (file) => documents[file]);
  }

  /** @param {string} text  of the file @param {string} file  its name @returns {Promise<{html: string, faults: Fault[], before: number}>} before: lines before the body */
  async render(text, file) {
    const faults = new Faults();
    const page = lessonOf(text, file, faults);
    page.lesson.number ||= this.#pages.filter(({ source }) => source.startsWith('docs/lessons/')).length + 1;
    const others = this.#pages.filter(({ source }) => source !== page.source);
    const links = new PreviewLinks((name) => this.#known.has(name) || /^core(\/|$)/.test(name), [page, ...others], this.playground, faults);
    links.strips = this.#strips;
    const rendered = await new Markdown(links).render(page);
    links.checkAnchors(({ source }) => (source === page.source ? rendered.headings.map(({ id }) => id) : this.#ids.get(source) ?? []));
    const { body } = await lessonPage(page, rendered, [page], links);
    const found = faults.sentences.map((sentence) => {
      const [, line, words] = /^.*?:(\d+): (.*)$/s.exec(sentence) ?? [];
      return { line: Number(line), sentence: words };
    });
    return { html: body, faults: found, before: page.before };
  }
}
