// SPDX-License-Identifier: MIT
// Reads the translated pages: docs/<code>/ has the files of docs/ in another language, with the same names.
import { readdir, readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { frontMatter } from '../front_matter.mjs';
import { compareWithOriginal } from './same_structure.mjs';

/** @typedef {import('../faults.mjs').Faults} Faults */
/** @typedef {import('../pages.mjs').Page} Page */
/** @typedef {import('./words.mjs').Language} Language */

/** Everything else in the header of a lesson comes from the English file. */
const KEYS = ['title'];

/** @param {string} root  of the repository @param {Language} language @param {Page[]} originals @param {Faults} faults @returns {Promise<Page[]>} in the order of the originals */
export async function readTranslations(root, language, originals, faults) {
  const folder = `docs/${language.code}`;
  const files = (await readdir(join(root, folder), { recursive: true }).catch(() => /** @type {string[]} */ ([])))
    .map((file) => file.replaceAll('\\', '/')).filter((file) => file.endsWith('.md'));
  for (const file of files) {
    if (!originals.some(({ source }) => source === `docs/${file}`)) faults.add(`${folder}/${file}`, 1, `there is no English page docs/${file}`);
  }
  const pages = await Promise.all(originals.filter(({ source }) => files.includes(source.slice('docs/'.length)))
    .map((original) => readTranslation(root, `${folder}/${original.source.slice('docs/'.length)}`, language, original, faults)));
  for (const page of pages) compareWithOriginal(page, faults);
  return pages;
}

/** @param {string} root @param {string} source @param {Language} language @param {Page} original @param {Faults} faults @returns {Promise<Page>} */
async function readTranslation(root, source, language, original, faults) {
  const text = await readFile(join(root, source), 'utf8');
  const page = { source, address: language.folder + original.address, name: original.name, language, original };
  if (!original.lesson) return { ...page, body: text, before: 0 };
  const { fields, body, before } = frontMatter(text, source, KEYS, faults);
  const title = fields.get('title')?.value ?? '';
  if (title === '') faults.add(source, 1, 'a lesson needs "title:" between its --- lines');
  return { ...page, body, before, lesson: { ...original.lesson, title, goals: [], predictions: [], quizzes: [], opens: new Set() } };
}
