// SPDX-License-Identifier: MIT
// Stores one version of the site. web/build/seal.mjs writes the version and the SHA-256 of every file before this
// script, so that every version has a different script. A file with another hash belongs to another version and is
// refused.

/** @typedef {{version: string, page: string[], hashes: Record<string, string>}} Site  page: the playground's files */

const site = /** @type {{SITE: Site}} */ (/** @type {unknown} */ (self)).SITE;
// `any`, because TypeScript cannot combine its types for service workers and for pages.
const worker = /** @type {any} */ (self);
const ROOT = new URL('./', worker.location.href).href;
// All copies of the site on a host share its storage.
const PREFIX = `gaitsmith-site ${new URL(ROOT).pathname} `;
const CACHE = PREFIX + site.version;

worker.addEventListener('install', (/** @type {any} */ event) => event.waitUntil(storePage()));
worker.addEventListener('activate', (/** @type {any} */ event) => event.waitUntil(activate()));
worker.addEventListener('fetch', (/** @type {any} */ event) => {
  const path = pathOf(event.request);
  if (path !== null) event.respondWith(answer(event.request, path));
});
worker.addEventListener('message', (/** @type {any} */ event) => {
  if (event.data?.type === 'take-over') event.waitUntil(takeOver(event.ports[0]));
});

/** Stores the whole playground. If this fails, the old version stays active. */
async function storePage() {
  const cache = await caches.open(CACHE);
  await Promise.all(site.page.map(async (path) => {
    if (!(await cache.match(ROOT + path))) await cache.put(ROOT + path, await fetched(path));
  }));
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
  const file = path === '' || path.endsWith('/') ? `${path}index.html` : path;
  return Object.hasOwn(site.hashes, file) ? file : null;
}

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
    return site.page.includes(path) && request.mode !== 'navigate' ? Response.error() : fetch(request);
  }
}

/** Fetches a file of this version from the server. @param {string} path */
async function fetched(path) {
  const response = await fetch(ROOT + path, { cache: 'no-cache', integrity: site.hashes[path], credentials: 'same-origin' });
  if (!response.ok) throw new Error(`${path}: ${response.status}`);
  // Some hosts redirect index.html. Browsers refuse a redirected response to a navigation.
  return response.redirected ? new Response(response.body, { headers: response.headers }) : response;
}
