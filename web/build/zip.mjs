// SPDX-License-Identifier: MIT
// The whole site as one file, for a school's server or a USB stick.
//
//   node web/build/zip.mjs <folder of the sealed site> <file.zip>
//
// Then puts the file into the site, where the teachers' page links it. Seal the site again afterwards.
import { copyFile, readFile, stat, writeFile } from 'node:fs/promises';
import { basename, join } from 'node:path';
import { filesOf, namesIn, zipped } from './zipped.mjs';

const TOP = 'gaitsmith/'; // the folder in the ZIP
const PAGE = 'book/teachers.html';
const WORDS = 'Take the whole site with you';

const [folder, file] = process.argv.slice(2);
if (!folder || !file) throw new Error('zip: which folder, and which file?');

const names = await namesIn(folder);
await writeFile(file, zipped(await filesOf(folder, names), TOP));
const { size } = await stat(file);

const page = await readFile(join(folder, PAGE), 'utf8');
const linked = page.replace(`<strong>${WORDS}</strong>`, `<a href="../${basename(file)}" download>${WORDS}</a> (${(size / 1e6).toFixed(1)} MB)`);
if (linked === page) throw new Error(`zip: ${PAGE} has no words "${WORDS}" to link`);
await writeFile(join(folder, PAGE), linked);
await copyFile(file, join(folder, basename(file)));
console.log(`== ${names.length} files in ${file}, ${Math.round(size / 1000)} KB`);
