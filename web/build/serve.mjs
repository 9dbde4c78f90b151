// SPDX-License-Identifier: MIT
// Serves a folder on this machine:  node web/build/serve.mjs [folder, default build/site] [port, default 8080]
// Prints the address. If the port is taken or 0, uses a free one. Replaces the service worker by one that unregisters
// itself, so that a page under development never comes from a cache. With --offline as the last argument it serves the
// site's own service worker.
import { createReadStream } from 'node:fs';
import { stat } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname, join, resolve, sep } from 'node:path';

const TYPES = {
  '.css': 'text/css; charset=utf-8', '.html': 'text/html; charset=utf-8', '.js': 'text/javascript; charset=utf-8',
  '.json': 'application/json', '.md': 'text/plain; charset=utf-8', '.mjs': 'text/javascript; charset=utf-8', '.svg': 'image/svg+xml',
  '.png': 'image/png', '.txt': 'text/plain; charset=utf-8', '.wasm': 'application/wasm', '.webmanifest': 'application/manifest+json',
};
const NO_WORKER = `addEventListener('install', () => skipWaiting());
addEventListener('activate', (event) => event.waitUntil(registration.unregister()));
`;
const folder = resolve(process.argv[2] ?? 'build/site');
const port = Number(process.argv[3]?.replace('--offline', '8080') ?? 8080);
const offline = process.argv.at(-1) === '--offline';

const server = createServer(async (request, response) => {
  const path = new URL(request.url ?? '/', 'http://localhost').pathname; // no file of ours needs escapes
  const file = join(folder, path.replace(/\/$/, '/index.html'));
  const found = file.startsWith(folder + sep) && (await stat(file).catch(() => null));
  if (!found || !found.isFile()) {
    response.writeHead(404, { 'content-type': 'text/plain' }).end('not found\n');
    return;
  }
  if (!offline && path.endsWith('/service_worker.js')) {
    response.writeHead(200, { 'content-type': 'text/javascript' }).end(NO_WORKER);
    return;
  }
  const type = TYPES[/** @type {keyof typeof TYPES} */ (extname(file))] ?? 'application/octet-stream';
  response.writeHead(200, { 'content-type': type, 'content-length': found.size, 'cache-control': 'no-cache' });
  createReadStream(file).pipe(response);
});
server.once('error', () => server.listen(0, '127.0.0.1')); // the port is taken
server.on('listening', () => {
  const address = server.address();
  if (address && typeof address === 'object') console.log(`http://localhost:${address.port}/`);
});
server.listen(port, '127.0.0.1');
