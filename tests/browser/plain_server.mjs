// SPDX-License-Identifier: MIT
// A minimal static host: a folder under a path, content types only for .html, .js and .css, and no other headers.
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname, join, normalize } from 'node:path';

const TYPES = /** @type {Record<string, string>} */ ({ '.html': 'text/html', '.js': 'text/javascript', '.css': 'text/css' });

export class PlainServer {
  /** The requested paths. @type {string[]} */
  requested = [];
  /** Additional pages, by path. @type {Record<string, string>} */
  pages = {};
  /** Whether the network is down. */
  away = false;
  /** Whether to redirect .../index.html to .../, and page.html to page, as some hosts do. */
  pretty = false;
  /** Additional headers. @type {Record<string, string>} */
  headers = {};

  /** @param {string} folder @param {string} path  such as /some/where/ */
  constructor(folder, path) {
    this.folder = folder;
    this.path = path;
    this.server = createServer((request, response) => void this.#answer(request, response));
  }

  /** @returns {Promise<void>} */
  start() { return new Promise((resolve) => this.server.listen(0, '127.0.0.1', () => resolve())); }

  close() {
    this.server.closeAllConnections();
    this.server.close();
  }

  /** @param {string} host  localhost and 127.0.0.1 are two origins on one machine */
  address(host = 'localhost') {
    const address = this.server.address();
    return `http://${host}:${address && typeof address === 'object' ? address.port : 0}${this.path}`;
  }

  /** @param {import('node:http').IncomingMessage} request @param {import('node:http').ServerResponse} response */
  async #answer(request, response) {
    const path = (request.url ?? '/').split(/[?#]/)[0];
    this.requested.push(path);
    if (this.away) {
      response.destroy();
      return;
    }
    const page = this.pages[path];
    if (this.pretty && path.endsWith('.html')) {
      response.writeHead(308, { location: path.replace(/(index)?\.html$/, '') }).end();
      return;
    }
    const inside = path.startsWith(this.path) ? normalize(path.slice(this.path.length)).replace(/^\.$|\/$|^$/, (end) => (end === '/' ? '/index.html' : 'index.html')) : null;
    const file = (/** @type {string} */ name) => readFile(join(this.folder, name)).catch(() => null);
    const bytes = page ?? (inside === null || inside.startsWith('..') ? null : await file(inside) ?? (this.pretty ? await file(`${inside}.html`) : null));
    if (bytes === null) response.writeHead(404).end('not found');
    else response.writeHead(200, { 'content-type': page ? 'text/html' : TYPES[extname(inside ?? '')] ?? (this.pretty && !extname(inside ?? '') ? 'text/html' : undefined) ?? 'application/octet-stream', 'cache-control': 'max-age=600', ...this.headers }).end(bytes);
  }
}
