// SPDX-License-Identifier: MIT
// A package of each lesson in each language for learning systems, in both versions of SCORM. Each holds the site, so that it needs no other
// host; the API reference is left out.
//
//   node web/package/scorm.mjs <folder of the sealed site> <folder for the packages>
import { mkdir, readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { isPackaged, scormFiles } from '../share/scorm_package.js';
import { filesOf, namesIn, zipped } from '../build/zipped.mjs';

const [folder, out] = process.argv.slice(2);
if (!folder || !out) throw new Error('scorm: which folder, and where to?');

const names = (await namesIn(folder)).filter(isPackaged);
const site = await filesOf(folder, names);
await mkdir(out, { recursive: true });
/** @type {{name: string, title: string, file: string, page: string}[]} */
const lessons = [];
for (const [, language] of names.map((name) => /^book\/((?:\w\w\/)?)lessons\.json$/.exec(name) ?? []).filter(([found]) => found !== undefined)) {
  const listed = /** @type {{name: string, title: string}[]} */ (JSON.parse(await readFile(join(folder, `book/${language}lessons.json`), 'utf8')));
  // A lesson without a translation has its English package.
  lessons.push(...listed.map(({ name, title }) => ({ name, title, file: language.replace('/', '-') + name, page: `book/${language}lessons/${name}.html` })).filter(({ page }) => names.includes(page)));
}
for (const { title, file, page } of lessons) {
  for (const version of /** @type {const} */ (['1.2', '2004'])) {
    const added = scormFiles({ name: file, title, version, launch: `${page}?scorm`, files: names });
    const texts = Object.fromEntries(Object.entries(added).map(([file, text]) => [file, new TextEncoder().encode(text)]));
    await writeFile(join(out, `${file}-scorm-${version}.zip`), zipped({ ...site, ...texts }));
  }
}
console.log(`== ${2 * lessons.length} SCORM packages in ${out}`);
