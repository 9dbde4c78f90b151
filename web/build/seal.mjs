// SPDX-License-Identifier: MIT
// The last step of building a site. Writes the site's files and their hashes into the service worker, and the public
// address, if there is one, into the pages, for link previews in chat programs.
//
//   node web/build/seal.mjs <folder> [address, e.g. https://example.org/gaitsmith/]
import { createHash } from 'node:crypto';
import { readdir, readFile, writeFile } from 'node:fs/promises';
import { join, relative, sep } from 'node:path';

const [folder, address = ''] = process.argv.slice(2);
if (!folder) throw new Error('seal: which folder?');
const base = address && new URL(address.endsWith('/') ? address : `${address}/`).href;

const names = (await readdir(folder, { recursive: true, withFileTypes: true }))
  .filter((entry) => entry.isFile())
  .map((entry) => relative(folder, join(entry.parentPath ?? entry.path, entry.name)).split(sep).join('/'))
  .filter((name) => name !== 'service_worker.js')
  .sort();

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
for (const name of names) {
  const bytes = await readFile(join(folder, name));
  hashes[name] = `sha256-${createHash('sha256').update(bytes).digest('base64')}`;
  all.update(`${name}\n${hashes[name]}\n`);
}
// The service worker stores the book, its pictures and the packages only when they are first read.
const page = names.filter((name) => !/^(book|package)\//.test(name) && !/(^|\/)(LICENSE|preview\.png)$/.test(name) && !name.endsWith('.txt'));
const site = { version: all.digest('hex').slice(0, 16), page, hashes };
const script = await readFile(new URL('../storage/service_worker.js', import.meta.url), 'utf8');
await writeFile(join(folder, 'service_worker.js'), `self.SITE = ${JSON.stringify(site)};\n${script}`);
console.log(`== ${names.length} files sealed, ${page.length} for the page without a network; version ${site.version}`);
