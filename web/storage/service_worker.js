// SPDX-License-Identifier: MIT
// Stores one version of the site. web/build/seal.mjs writes the version and the SHA-256 of every file before this
// script, so that every version has a different script. A file with another hash belongs to another version and is
// refused.

/** page: files of the playground; book: files that are stored when the page is idle
 * @typedef {{version: string, page: string[], book: string[], hashes: Record<string, string>}} Site */

const site = /** @type {{SITE: Site}} */ (/** @type {unknown} */ (self)).SITE;
// `any`, because TypeScript cannot combine its types for service workers and for pages.
const worker = /** @type {any} */ (self);
const ROOT = new URL('./', worker.location.href).href;
// All copies of the site on a host share its storage.
const PREFIX = `gaitsmith-site ${new URL(ROOT).pathname} `;
const CACHE = PREFIX + site.version;
const MISSING = 'book/missing.html';
const AT_ONCE = 3; // files of the book

worker.addEventListener('install', (/** @type {any} */ event) => event.waitUntil(storePage().then(keepBook)));
worker.addEventListener('activate', (/** @type {any} */ event) => event.waitUntil(activate()));
worker.addEventListener('fetch', (/** @type {any} */ event) => {
  const path = pathOf(event.request);
  if (path !== null) event.respondWith(answer(event.request, path));
  else if (isNavigation(event.request)) event.respondWith(fetch(event.request).catch(() => missing(event.request)));
});
worker.addEventListener('message', (/** @type {any} */ event) => {
  if (event.data?.type === 'take-over') event.waitUntil(takeOver(event.ports[0]));
  if (event.data?.type === 'store-book') event.waitUntil(storeBook(event.data.language, event.ports[0]));
});

/** Stores the whole playground. If this fails, the old version stays active. */
async function storePage() {
  const cache = await caches.open(CACHE);
  await Promise.all(site.page.map(async (path) => {
    if (!(await cache.match(ROOT + path))) await cache.put(ROOT + path, await fetched(path));
  }));
}

/** Copies the book's unchanged files from older versions, so that an update fetches only the changed ones. */
async function keepBook() {
  try {
    const cache = await caches.open(CACHE);
    for (const name of (await caches.keys()).filter((each) => each.startsWith(PREFIX) && each !== CACHE)) {
      const old = await caches.open(name);
      const stored = await storedIn(old);
      for (const path of site.book.filter((each) => stored.has(ROOT + each))) {
        const response = await old.match(ROOT + path);
        if (response && await hashOf(response.clone()) === site.hashes[path]) await cache.put(ROOT + path, response);
      }
    }
  } catch { /* storeBook fetches what is missing */ }
}

/** Stores what is missing of the book in English and in one language, and reports whether it is complete. @param {string} language @param {MessagePort} port */
async function storeBook(language, port) {
  const cache = await caches.open(CACHE);
  const stored = await storedIn(cache);
  const waiting = site.book.filter((path) => [undefined, language].includes(languageOf(path)) && !stored.has(ROOT + path));
  const fetches = waiting.length;
  const fetchNext = async () => {
    for (let path = waiting.shift(); path !== undefined; path = waiting.shift()) await cache.put(ROOT + path, await fetched(path, 'low'));
  };
  const complete = await Promise.all(Array.from({ length: AT_ONCE }, fetchNext)).then(() => true, () => false);
  waiting.length = 0; // after a failure the next visit continues
  port.postMessage({ complete, fetched: fetches > 0 });
}

/** The language of a file of the book. undefined: everybody needs it. @param {string} path */
const languageOf = (path) => /^book\/(?:words\/)?([a-z]{2})(?:\/|\.js$)/.exec(path)?.[1];

/** The addresses that a cache has. @param {Cache} cache */
const storedIn = async (cache) => new Set((await cache.keys()).map(({ url }) => url));

/** @param {Response} response */
async function hashOf(response) {
  const digest = new Uint8Array(await crypto.subtle.digest('SHA-256', await response.arrayBuffer()));
  return `sha256-${btoa(String.fromCharCode(...digest))}`;
}

/** Does not take control of open pages, which the browser's own cache may have loaded from an older version. */
async function activate() {
  const names = await caches.keys();
  await Promise.all(names.filter((name) => name.startsWith(PREFIX) && name !== CACHE).map((name) => caches.delete(name)));
  await storePage(); // the previous worker may have deleted this cache as an old one
}

/** Takes over only if no other page is open, so that no page changes its version while it runs. @param {MessagePort} port */
async function takeOver(port) {
  const pages = await worker.clients.matchAll({ type: 'window', includeUncontrolled: true });
  const alone = pages.filter((/** @type {{url: string}} */ { url }) => url.startsWith(ROOT)).length <= 1;
  port.postMessage({ alone });
  if (alone) await worker.skipWaiting();
}

/** The path of a file of the site. @param {Request} request @returns {string | null} null: not a file of the site */
function pathOf(request) {
  const address = request.url.split(/[?#]/)[0];
  if (request.method !== 'GET' || !address.startsWith(ROOT)) return null;
  const path = address.slice(ROOT.length);
  // Some hosts name pages without .html.
  const file = [path === '' || path.endsWith('/') ? `${path}index.html` : path, `${path}.html`].find((each) => Object.hasOwn(site.hashes, each));
  return file ?? null;
}

/** @param {Request} request */
const isNavigation = ({ method, mode, url }) => method === 'GET' && mode === 'navigate' && url.startsWith(ROOT);

/** @param {Request} request @param {string} path */
async function answer(request, path) {
  const cached = await caches.match(ROOT + path, { cacheName: CACHE }).catch(() => undefined);
  if (cached) return cached;
  try {
    const response = await fetched(path);
    const cache = await caches.open(CACHE);
    await cache.put(ROOT + path, response.clone()).catch(() => {}); // the storage may be full
    return response;
  } catch {
    // A page of the book may come from another version, but a part of the playground must not.
    if (isNavigation(request)) return fetch(request).catch(() => missing(request));
    return site.page.includes(path) ? Response.error() : fetch(request);
  }
}

/** Our own page instead of the browser's error: what is missing, and links to what is stored. @param {Request} request */
async function missing(request) {
  const cache = await caches.open(CACHE);
  const page = await cache.match(ROOT + MISSING);
  if (!page) return Response.error();
  const stored = await storedIn(cache);
  const path = request.url.split(/[?#]/)[0].slice(ROOT.length);
  const kind = /^book\/(reference|pictures|design)[./]/.exec(path)?.[1] ?? (pathOf(request) ? 'page' : 'unknown');
  const absolute = (/** @type {string} */ address) => new URL(address, ROOT + MISSING).href;
  const text = (await page.text())
    .replace(/<p data-of="(\w+)">.*?<\/p>\n?/gs, (whole, of) => (of === kind ? whole : ''))
    .replace(/<li class="stored"><a href="([^"#]*).*?<\/li>\n?/gs, (whole, address) => (stored.has(absolute(address).replace(/\/$/, '/index.html')) ? whole : ''))
    .replace('{page}', path.replace(/[&<]/g, (sign) => (sign === '&' ? '&amp;' : '&lt;')))
    .replace(/(href|src|action)="([^"#][^"]*)"/g, (_, name, address) => `${name}="${absolute(address)}"`);
  return new Response(text, { status: 503, headers: { 'content-type': 'text/html; charset=utf-8' } });
}

/** Fetches a file of this version from the server. @param {string} path @param {RequestPriority} [priority] */
async function fetched(path, priority = 'auto') {
  const response = await fetch(ROOT + path, { priority, cache: 'no-cache', integrity: site.hashes[path], credentials: 'same-origin' });
  if (!response.ok) throw new Error(`${path}: ${response.status}`);
  // Some hosts redirect index.html. Browsers refuse a redirected response to a navigation.
  return response.redirected ? new Response(response.body, { headers: response.headers }) : response;
}
