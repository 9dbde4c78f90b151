// SPDX-License-Identifier: MIT
// Keeps one version of the site. web/seal.mjs writes the version and the files with their SHA-256 in front of this script,
// so that it is another script for every version; a file that does not match comes from another version and is refused.

/** @typedef {{version: string, page: string[], hashes: Record<string, string>}} Site  page: what the playground needs, all at once */

const site = /** @type {{SITE: Site}} */ (/** @type {unknown} */ (self)).SITE;
// The types of service workers and of pages exclude each other.
const worker = /** @type {any} */ (self);
const PREFIX = 'gaitsmith-site-';
const CACHE = PREFIX + site.version;
const ROOT = new URL('./', worker.location.href).href;

worker.addEventListener('install', (/** @type {any} */ event) => event.waitUntil(keepPage()));
worker.addEventListener('activate', (/** @type {any} */ event) => event.waitUntil(forgetOthers()));
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

async function forgetOthers() {
  const names = await caches.keys();
  await Promise.all(names.filter((name) => name.startsWith(PREFIX) && name !== CACHE).map((name) => caches.delete(name)));
  await worker.clients.claim();
}

/** Only when no other page would find itself with another version than it began with. @param {MessagePort} port */
async function takeOver(port) {
  const pages = await worker.clients.matchAll({ type: 'window', includeUncontrolled: true });
  const alone = pages.length <= 1;
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
  const kept = await caches.match(ROOT + path, { cacheName: CACHE });
  if (kept) return kept;
  try {
    const response = await fetched(path);
    const cache = await caches.open(CACHE);
    await cache.put(ROOT + path, response.clone()).catch(() => {}); // the storage is full
    return response;
  } catch {
    // Of the pages of the book a newer one is better than none.
    return fetch(request);
  }
}

/** From the server, whole and of this version. @param {string} path */
async function fetched(path) {
  const response = await fetch(ROOT + path, { cache: 'no-cache', integrity: site.hashes[path], credentials: 'same-origin' });
  if (!response.ok) throw new Error(`${path}: ${response.status}`);
  return response;
}
