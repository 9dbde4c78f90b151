// SPDX-License-Identifier: MIT
// Keeps one version of the site. web/build/seal.mjs writes the version and the files with their SHA-256 in front of this script,
// so that it is another script for every version; a file that does not match comes from another version and is refused.

/** @typedef {{version: string, page: string[], hashes: Record<string, string>}} Site  page: what the playground needs, all at once */

const site = /** @type {{SITE: Site}} */ (/** @type {unknown} */ (self)).SITE;
// The types of service workers and of pages exclude each other.
const worker = /** @type {any} */ (self);
const ROOT = new URL('./', worker.location.href).href;
// Storage belongs to the whole host, which may have several copies of the site.
const PREFIX = `gaitsmith-site ${new URL(ROOT).pathname} `;
const CACHE = PREFIX + site.version;

worker.addEventListener('install', (/** @type {any} */ event) => event.waitUntil(keepPage()));
worker.addEventListener('activate', (/** @type {any} */ event) => event.waitUntil(takeCharge()));
worker.addEventListener('fetch', (/** @type {any} */ event) => {
  const path = pathOf(event.request);
  if (path !== null) event.respondWith(answer(event.request, path));
});
worker.addEventListener('message', (/** @type {any} */ event) => {
  if (event.data?.type === 'take-over') event.waitUntil(takeOver(event.ports[0]));
});

/** All or nothing: what fails leaves the version before in charge. */
async function keepPage() {
  const cache = await caches.open(CACHE);
  await Promise.all(site.page.map(async (path) => {
    if (!(await cache.match(ROOT + path))) await cache.put(ROOT + path, await fetched(path));
  }));
}

/** Pages that are open go on as they began: they may have come out of the browser's own cache, and be older. */
async function takeCharge() {
  const names = await caches.keys();
  await Promise.all(names.filter((name) => name.startsWith(PREFIX) && name !== CACHE).map((name) => caches.delete(name)));
  await keepPage(); // the worker before may have taken this cache for an old one
}

/** Only when no other page would find itself with another version than it began with. @param {MessagePort} port */
async function takeOver(port) {
  const pages = await worker.clients.matchAll({ type: 'window', includeUncontrolled: true });
  const alone = pages.filter((/** @type {{url: string}} */ { url }) => url.startsWith(ROOT)).length <= 1;
  port.postMessage({ alone });
  if (alone) await worker.skipWaiting();
}

/** Of a file of the site; null: the network's concern. @param {Request} request */
function pathOf(request) {
  const address = request.url.split(/[?#]/)[0];
  if (request.method !== 'GET' || !address.startsWith(ROOT)) return null;
  const path = address.slice(ROOT.length);
  const file = path === '' || path.endsWith('/') ? `${path}index.html` : path;
  return Object.hasOwn(site.hashes, file) ? file : null;
}

/** @param {Request} request @param {string} path */
async function answer(request, path) {
  const kept = await caches.match(ROOT + path, { cacheName: CACHE }).catch(() => undefined);
  if (kept) return kept;
  try {
    const response = await fetched(path);
    const cache = await caches.open(CACHE);
    await cache.put(ROOT + path, response.clone()).catch(() => {}); // the storage is full
    return response;
  } catch {
    // Of the book a newer page is better than none; a part of the playground that is not of its version is not.
    return site.page.includes(path) && request.mode !== 'navigate' ? Response.error() : fetch(request);
  }
}

/** From the server, whole and of this version. @param {string} path */
async function fetched(path) {
  const response = await fetch(ROOT + path, { cache: 'no-cache', integrity: site.hashes[path], credentials: 'same-origin' });
  if (!response.ok) throw new Error(`${path}: ${response.status}`);
  // Hosts with pretty addresses send on, and browsers refuse such an answer to whoever opens a page.
  return response.redirected ? new Response(response.body, { headers: response.headers }) : response;
}
