// SPDX-License-Identifier: MIT
// The whole site as one file, for a school's server or a USB stick. The same site gives the same bytes: the names are
// sorted, and all times are equal.
//
//   node web/build/zip.mjs <folder of the sealed site> <file.zip>
//
// Then puts the file into the site, where the teachers' page links it. Seal the site again afterwards.
import { copyFile, readdir, readFile, stat, writeFile } from 'node:fs/promises';
import { basename, join, relative, sep } from 'node:path';
import { zipSync } from 'fflate';

const TOP = 'gaitsmith'; // the folder in the ZIP
const TIME = new Date(1980, 0, 1); // the earliest of a ZIP, in any time zone
const PAGE = 'book/teachers.html';
const WORDS = 'Take the whole site with you';

const [folder, file] = process.argv.slice(2);
if (!folder || !file) throw new Error('zip: which folder, and which file?');

const names = (await readdir(folder, { recursive: true, withFileTypes: true }))
  .filter((entry) => entry.isFile())
  .map((entry) => relative(folder, join(entry.parentPath ?? entry.path, entry.name)).split(sep).join('/'))
  .filter((name) => !name.endsWith('.zip'))
  .sort();
/** @type {import('fflate').Zippable} */
const files = {};
for (const name of names) files[`${TOP}/${name}`] = [await readFile(join(folder, name)), { level: 9, mtime: TIME }];
await writeFile(file, zipSync(files));
const { size } = await stat(file);

const page = await readFile(join(folder, PAGE), 'utf8');
const linked = page.replace(`<strong>${WORDS}</strong>`, `<a href="../${basename(file)}" download>${WORDS}</a> (${(size / 1e6).toFixed(1)} MB)`);
if (linked === page) throw new Error(`zip: ${PAGE} has no words "${WORDS}" to link`);
await writeFile(join(folder, PAGE), linked);
await copyFile(file, join(folder, basename(file)));
console.log(`== ${names.length} files in ${file}, ${Math.round(size / 1000)} KB`);
