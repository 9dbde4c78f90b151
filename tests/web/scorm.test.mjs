// SPDX-License-Identifier: MIT
// SCORM packages that are made in the page: run in build/wasm/web.
import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';

const foreign = createRequire(join(import.meta.dirname, '../../web/package.json'));
const { unzipSync } = foreign('fflate');
const { makeScormPackage } = await import(pathToFileURL(join(process.cwd(), 'share/scorm_maker.js')).href);

const FILES = /** @type {Record<string, string>} */ ({ 'index.html': '<p>', 'a/b.js': 'export {};', 'a/c & d.js': '' });

/** A site of three files. @param {string} [missing] */
const siteWithout = (missing) => /** @type {typeof fetch} */ (async (address, options) => {
  options?.signal?.throwIfAborted();
  const name = decodeURIComponent(String(address).replace('https://example.org/g/', ''));
  if (name === missing) return new Response('', { status: 404 });
  if (name === 'files.json') return Response.json(Object.fromEntries(Object.keys(FILES).map((file) => [file, `sha256-${file}`])));
  assert.equal(options?.integrity, `sha256-${name}`, 'a file of another version is refused');
  return new Response(FILES[name]);
});
const order = () => ({
  name: 'hop', title: 'Hop & run', launch: 'index.html?goal=distance%3E%3D8&scorm#AZ4', version: /** @type {'1.2' | '2004'} */ ('1.2'),
  signal: new AbortController().signal, onProgress: () => {}, site: 'https://example.org/g/', fetchFile: siteWithout(),
});

test('scorm: a package has the files of the site, and a manifest that lists them', async () => {
  /** @type {number[]} */
  const shares = [];
  for (const version of /** @type {const} */ (['1.2', '2004'])) {
    const bytes = new Uint8Array(await (await makeScormPackage({ ...order(), version, onProgress: (/** @type {number} */ share) => shares.push(share) })).arrayBuffer());
    const files = Object.fromEntries(Object.entries(unzipSync(bytes)).map(([name, part]) => [name, new TextDecoder().decode(/** @type {Uint8Array} */ (part))]));
    assert.deepEqual(Object.keys(files).sort(), ['imsmanifest.xml', 'launch.html', ...Object.keys(FILES)].sort());
    for (const [name, text] of Object.entries(FILES)) assert.equal(files[name], text);
    assert.match(files['imsmanifest.xml'], /<title>Hop &amp; run<\/title>[\s\S]*<file href="a\/c &amp; d.js"\/>/);
    assert.match(files['launch.html'], /url=index\.html\?goal=distance%3E%3D8&amp;scorm#AZ4"/);
  }
  assert.equal(shares.at(-1), 1);
});

test('scorm: the same site gives the same bytes', async () => {
  const bytes = async () => Buffer.from(await (await makeScormPackage(order())).arrayBuffer()).toString('base64');
  assert.equal(await bytes(), await bytes());
});

test('scorm: a file that is missing is named, and so is a site without a list', async () => {
  await assert.rejects(makeScormPackage({ ...order(), fetchFile: siteWithout('a/b.js') }), /a\/b\.js could not be loaded/);
  await assert.rejects(makeScormPackage({ ...order(), fetchFile: siteWithout('files.json') }), /no list of its files/);
});

test('scorm: a package can be cancelled', async () => {
  const making = new AbortController();
  const made = makeScormPackage({ ...order(), signal: making.signal, onProgress: () => {}, fetchFile: /** @type {typeof fetch} */ (async (address, options) => {
    if (String(address).endsWith('b.js')) making.abort();
    return siteWithout()(address, options);
  }) });
  await assert.rejects(made, { name: 'AbortError' });
});
