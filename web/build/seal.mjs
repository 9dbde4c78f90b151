// SPDX-License-Identifier: MIT
// The last step of building a site. Writes the site's files and their hashes into the service worker, and those that a
// SCORM package holds into files.json (web/share/scorm_maker.js). Writes the public address, if there is one, into the
// pages, for link previews in chat programs.
//
//   node web/build/seal.mjs <folder> [address, e.g. https://example.org/gaitsmith/]
import { createHash } from 'node:crypto';
import { readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { isPackaged } from '../share/scorm_package.js';
import { namesIn } from './zipped.mjs';

const MAX_BOOK_GZIP = 1.5e6; // what a visitor's idle page may fetch for later

const [folder, address = ''] = process.argv.slice(2);
if (!folder) throw new Error('seal: which folder?');
const base = address && new URL(address.endsWith('/') ? address : `${address}/`).href;

const WRITTEN = ['service_worker.js', 'files.json'];
const names = (await namesIn(folder)).filter((name) => !WRITTEN.includes(name));

// Programs that read og:image expect an absolute address. Some also understand a relative one.
for (const name of names.filter((each) => each.endsWith('.html'))) {
  const path = join(folder, name);
  const text = await readFile(path, 'utf8');
  const whole = text.replace(/(<meta property="og:(?:image|url)" content=")(?!https?:)([^"]*)"/g,
    (_, before, target) => `${before}${base ? new URL(target, new URL(name, base)).href : target}"`);
  if (whole !== text) await writeFile(path, whole);
}

/** @type {Record<string, string>} */
const hashes = {};
const all = createHash('sha256');
/** @param {string} name */
async function addHash(name) {
  hashes[name] = `sha256-${createHash('sha256').update(await readFile(join(folder, name))).digest('base64')}`;
  all.update(`${name}\n${hashes[name]}\n`);
}
for (const name of names) await addHash(name);
await writeFile(join(folder, 'files.json'), JSON.stringify(Object.fromEntries(names.filter(isPackaged).map((name) => [name, hashes[name]]))));
names.push('files.json');
await addHash('files.json');
// The playground, and what the page for missing pages needs, are stored at once. The book follows when the page is idle.
// The API reference, the large pictures, the design decisions, what writes lessons, the packages, what games use and the licences of libraries are only stored
// when they are read.
const atOnce = (/** @type {string} */ name) => /^book\/(missing\.html|tokens\.css|book\.css|look\.js)$/.test(name)
  || (!/^(book|package|runtime)\//.test(name) && !/(^|\/)(LICENSE|preview\.png)$/.test(name) && !name.endsWith('.txt'));
const page = names.filter(atOnce);
const book = names.filter((name) => (/^book\/(?!reference\/|pictures[./]|design(?:\.html|_search\.json)|(?:\w\w\/)?new[-_]lesson\.|sources\.json)/.test(name) || name === 'LICENSE') && !name.endsWith('.txt') && !atOnce(name));
// A visitor stores the book in English and in the page's language.
/** By language; '': English and what all need. @type {Map<string, number>} */
const sizes = new Map();
for (const name of book) {
  const language = /^book\/(?:words\/)?([a-z]{2})(?:\/|\.js$)/.exec(name)?.[1] ?? '';
  sizes.set(language, (sizes.get(language) ?? 0) + gzipSync(await readFile(join(folder, name))).length);
}
const { '': english = 0, ...others } = Object.fromEntries(sizes);
const gzip = english + Math.max(0, ...Object.values(others));
if (gzip > MAX_BOOK_GZIP) throw new Error(`seal: the stored part of the book has ${gzip} bytes, compressed, and may have ${MAX_BOOK_GZIP}`);
const site = { version: all.digest('hex').slice(0, 16), page, book, hashes };
const script = await readFile(new URL('../storage/service_worker.js', import.meta.url), 'utf8');
await writeFile(join(folder, 'service_worker.js'), `self.SITE = ${JSON.stringify(site)};\n${script}`);
console.log(`== ${names.length} files sealed, ${page.length} for the page without a network, ${book.length} for the book (${Math.round(english / 1000)} KB, compressed${Object.entries(others).map(([code, size]) => `, ${code} ${Math.round(size / 1000)} KB`).join('')}); version ${site.version}`);
