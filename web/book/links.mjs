// SPDX-License-Identifier: MIT
// Resolves the links and images of a page. Its Markdown names files of the repository, which have other addresses in
// the book. Also runs in the page that previews a lesson, so it reads no files itself.
import { stamp } from '../share/stamp.js';
import { upFrom } from './html.mjs';
import { playgroundAddress } from './playground.mjs';

/** @typedef {import('./faults.mjs').Faults} Faults */
/** @typedef {import('./pages.mjs').Page} Page */
/** @typedef {import('./playground.mjs').Playground} Playground */
/** @typedef {import('./playground.mjs').Strips} Strips */
/** What a link opens in the playground. @typedef {{payload: string, panels?: string, lock?: string, goal?: string}} Opens */
/** href: empty if there is no target. @typedef {{href: string, opens?: Opens}} Link */
/** @typedef {{source: string, line: number, page: Page, anchor: string}} Reference */

/** Files of the repository that the site contains, and their addresses. @type {Record<string, string>} */
const SHIPPED = { 'web/index.html': 'index.html', 'web/book/player.js': 'player.js', LICENSE: 'LICENSE',
  'core/runtime/gaitsmith.h': 'runtime/gaitsmith.h', 'web/runtime/runtime.js': 'runtime/runtime.js', 'web/runtime/runtime.d.ts': 'runtime/runtime.d.ts' };
/** Pages of the book that are no text, in each language. @type {Record<string, string>} */
const TOOLS = {
  'web/book/wall_page.mjs': 'wall.html', 'web/book/teaching/packages_page.mjs': 'packages.html', 'web/book/teaching/new_lesson_page.mjs': 'new-lesson.html', 'web/book/teaching/quiz_page.mjs': 'quiz.html',
};
/** A link to this file with a motion behind the '#' opens that motion. */
export const PLAYGROUND = 'web/index.html';
const PARAMETERS = ['panels', 'lock', 'goal'];
const IMAGE = /\.(png|svg|jpg|webp)$/;

export class Links {
  /** Links to headings, to be checked when all pages are read. @type {Reference[]} */
  references = [];
  /** Images to copy: from the repository into the book. @type {Map<string, string>} */
  images = new Map();
  /** The film strips of all pages, by file name. @type {Map<string, Strips>} */
  strips = new Map();

  /**
   * @param {(file: string) => boolean} has  whether the repository has a file @param {Page[]} pages @param {Playground} playground @param {Faults} faults
   * @param {Map<string, string>} [reference]  addresses of core's headers and folders; without it links to them are text
   */
  constructor(has, pages, playground, faults, reference) {
    this.has = has;
    this.playground = playground;
    this.faults = faults;
    this.reference = reference;
    this.pages = new Map(pages.map((page) => [page.source, page]));
  }

  /** The relative address, from a page, of an address in the book ('../': in the site). @param {Page} page @param {string} address */
  way(page, address) {
    return upFrom(page.address) + address;
  }

  /** @param {Page} page @param {number} line @param {string} href @param {string} [source]  the file that names it @returns {Promise<Link>} */
  async resolve(page, line, href, source = page.source) {
    if (/^(https?:|mailto:)/.test(href)) return { href };
    const [path, query = '', anchor] = /^([^?#]*)(?:\?([^#]*))?(?:#(.*))?$/.exec(href)?.slice(1) ?? [href];
    const file = path ? this.file(source, path) : page.source;
    // What is not translated yet is shown in English.
    const other = this.pages.get(file) ?? this.pages.get(file.replace(`docs/${page.language.folder}`, 'docs/'));
    if (other) {
      if (anchor !== undefined) this.references.push({ source: page.source, line, page: other, anchor });
      const at = anchor === undefined ? '' : `#${anchor}`;
      return { href: path ? this.way(page, other.address) + at : at };
    }
    if (file === PLAYGROUND && anchor) return this.#motion(page, line, 'this motion', () => this.playground.payloadOf(anchor), query);
    if (Object.hasOwn(SHIPPED, file)) return { href: this.way(page, `../${SHIPPED[file]}${query && `?${query}`}`) };
    if (Object.hasOwn(TOOLS, file)) return { href: this.way(page, page.language.folder + TOOLS[file] + (query && `?${query}`)) };
    if (!this.has(file)) return this.#fault(page, line, `there is no file "${file}" to link to`);
    const reference = file.replace(/\/$/, '');
    if (this.reference?.has(reference)) return { href: this.way(page, this.reference.get(reference) ?? '') };
    if (!this.reference && /^core(\/|$)/.test(reference)) return { href: '' };
    if (file.endsWith('.json')) return this.#motion(page, line, `"${file}"`, () => this.playground.payload(file), query);
    if (IMAGE.test(file)) return { href: this.image(page, line, path) };
    return this.#fault(page, line, `"${file}" is not on the site: name it without a link`);
  }

  /** The address of an image. The image is copied later. @param {Page} page @param {number} line @param {string} path */
  image(page, line, path) {
    const file = this.file(page.source, path);
    if (!IMAGE.test(file) || !file.startsWith('docs/') || !this.has(file)) {
      return this.#fault(page, line, `"${file}" is no image in docs/`).href;
    }
    const address = file.slice('docs/'.length);
    this.images.set(file, address);
    return this.way(page, address);
  }

  /** The film strips of a document, or of a motion in a link, and their file name. @param {Page} page @param {string} path */
  async strip(page, path) {
    const file = this.file(page.source, path), [, payload = ''] = path.split('#');
    const name = file === PLAYGROUND ? `motion-${stamp(payload)}` : file.replace(/^examples\//, '').replace(/\.json$/, '').replace(/[^\w-]+/g, '-');
    const strips = this.strips.get(name) ?? await (file === PLAYGROUND ? this.playground.stripsOf(payload) : this.playground.strips(file));
    this.strips.set(name, strips);
    return { name, strips };
  }

  /** Adds a fault for each link to a heading that is not there. @param {(page: Page) => string[]} idsOf  of its headings */
  checkAnchors(idsOf) {
    for (const { source, line, page, anchor } of this.references) {
      if (!idsOf(page).includes(anchor)) this.faults.add(source, line, `${page.source} has no heading "#${anchor}"`);
    }
  }

  /** @param {Page} page @param {number} line @param {string} name @param {() => Promise<string>} read  its payload @param {string} query @returns {Promise<Link>} */
  async #motion(page, line, name, read, query) {
    const parameters = new URLSearchParams(query);
    for (const key of parameters.keys()) {
      if (!PARAMETERS.includes(key)) this.faults.add(page.source, line, `a document is opened with ${PARAMETERS.join(', ')}, not "${key}"`);
    }
    try {
      const payload = await read();
      page.lesson?.opens.add(payload);
      const opens = { payload, ...Object.fromEntries(parameters) };
      // Without ?edit a link to a bare document opens the viewer.
      const query = parameters.size ? parameters : new URLSearchParams('edit');
      return { href: this.way(page, `../${playgroundAddress(payload, query)}`), opens };
    } catch (error) {
      return this.#fault(page, line, `${name} does not open in the playground: ${error instanceof Error ? error.message : error}`);
    }
  }

  /** The path in the repository. @param {string} source  the file that names it @param {string} path */
  file(source, path) {
    try {
      return decodeURI(new URL(path.replace(/[?#].*$/, ''), `file:///${source}`).pathname.slice(1));
    } catch {
      return path; // no address at all, and no file
    }
  }

  /** @param {Page} page @param {number} line @param {string} sentence @returns {Link} */
  #fault(page, line, sentence) {
    this.faults.add(page.source, line, sentence);
    return { href: '#' };
  }
}
