// SPDX-License-Identifier: MIT
// Resolves the links and images of a page. Its Markdown names files of the repository, which have other addresses in
// the book.
import { existsSync } from 'node:fs';
import { join, posix } from 'node:path';
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
const SHIPPED = { 'web/index.html': 'index.html', 'web/book/player.js': 'player.js', 'web/book/wall_page.mjs': 'book/wall.html', LICENSE: 'LICENSE' };
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
   * @param {string} root @param {Page[]} pages @param {Playground} playground @param {Faults} faults
   * @param {Map<string, string>} [reference]  addresses of core's headers and folders; without it links to them are text
   */
  constructor(root, pages, playground, faults, reference) {
    this.root = root;
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
    if (file in SHIPPED) return { href: this.way(page, `../${SHIPPED[file]}${query && `?${query}`}`) };
    if (!existsSync(join(this.root, file))) return this.#fault(page, line, `there is no file "${file}" to link to`);
    const reference = file.replace(/\/$/, '');
    if (this.reference?.has(reference)) return { href: this.way(page, this.reference.get(reference) ?? '') };
    if (!this.reference && /^core(\/|$)/.test(reference)) return { href: '' };
    if (file.endsWith('.json')) return this.#document(page, line, file, query);
    if (IMAGE.test(file)) return { href: this.image(page, line, path) };
    return this.#fault(page, line, `"${file}" is not on the site: name it without a link`);
  }

  /** The address of an image. The image is copied later. @param {Page} page @param {number} line @param {string} path */
  image(page, line, path) {
    const file = this.file(page.source, path);
    if (!IMAGE.test(file) || !file.startsWith('docs/') || !existsSync(join(this.root, file))) {
      return this.#fault(page, line, `"${file}" is no image in docs/`).href;
    }
    const address = file.slice('docs/'.length);
    this.images.set(file, address);
    return this.way(page, address);
  }

  /** A document's film strips and their file name. @param {Page} page @param {string} path */
  async strip(page, path) {
    const file = this.file(page.source, path);
    const name = file.replace(/^examples\//, '').replace(/\.json$/, '').replace(/[^\w-]+/g, '-');
    const strips = this.strips.get(name) ?? await this.playground.strips(join(this.root, file));
    this.strips.set(name, strips);
    return { name, strips };
  }

  /** @param {Page} page @param {number} line @param {string} file @param {string} query @returns {Promise<Link>} */
  async #document(page, line, file, query) {
    const parameters = new URLSearchParams(query);
    for (const key of parameters.keys()) {
      if (!PARAMETERS.includes(key)) this.faults.add(page.source, line, `a document is opened with ${PARAMETERS.join(', ')}, not "${key}"`);
    }
    try {
      const payload = await this.playground.payload(join(this.root, file));
      page.lesson?.opens.add(payload);
      const opens = { payload, ...Object.fromEntries(parameters) };
      // Without ?edit a link to a bare document opens the viewer.
      const query = parameters.size ? parameters : new URLSearchParams('edit');
      return { href: this.way(page, `../${playgroundAddress(payload, query)}`), opens };
    } catch (error) {
      return this.#fault(page, line, `"${file}" does not open in the playground: ${error instanceof Error ? error.message : error}`);
    }
  }

  /** The path in the repository. @param {string} source  the file that names it @param {string} path */
  file(source, path) {
    return posix.normalize(posix.join(posix.dirname(source), decodeURI(path.replace(/[?#].*$/, ''))));
  }

  /** @param {Page} page @param {number} line @param {string} sentence @returns {Link} */
  #fault(page, line, sentence) {
    this.faults.add(page.source, line, sentence);
    return { href: '#' };
  }
}
