// SPDX-License-Identifier: MIT
// Reads the book's pages from docs/, in order, and the front matter of lessons.
import { readdir, readFile } from 'node:fs/promises';
import { basename, join } from 'node:path';
import { frontMatter } from './front_matter.mjs';
import { readTranslations } from './languages/translations.mjs';
import { ENGLISH, readLanguages } from './languages/words.mjs';

/** @typedef {import('./faults.mjs').Faults} Faults */
/** @typedef {import('./front_matter.mjs').Field} Field */
/**
 * @typedef {object} Page
 * @property {string} source   its file in the repository
 * @property {string} address  its file in the book
 * @property {string} name     without folder and ending
 * @property {string} body     Markdown
 * @property {number} before   lines of the file before the body
 * @property {Lesson} [lesson]
 * @property {import('./languages/words.mjs').Language} language
 * @property {Page} [original]  the English page, of a translation
 */
/** @typedef {import('../classroom/judge.js').Question} Question */
/**
 * goals, predictions and quizzes: in their order in the text; opens: payloads of its documents. Known once it is rendered.
 * @typedef {{number: number, title: string, minutes: number, fields: Map<string, Field>, goals: string[], predictions: Question[], quizzes: Question[], opens: Set<string>}} Lesson
 */

const KEYS = ['title', 'minutes', 'open', 'panels', 'lock', 'goal'];
const NEEDED = ['title', 'minutes', 'open'];

/** @param {string} folder */
async function markdownIn(folder) {
  const names = await readdir(folder).catch(() => /** @type {string[]} */ ([]));
  return names.filter((name) => name.endsWith('.md')).sort();
}

/** @param {string} root  of the repository @param {Faults} faults @param {import('./languages/words.mjs').Language[]} [languages]  English first @returns {Promise<Page[]>} lessons first, in their order; translations after all English pages */
export async function readPages(root, faults, languages = undefined) {
  const pages = await Promise.all((await markdownIn(join(root, 'docs'))).map(async (file) => {
    const body = await readFile(join(root, 'docs', file), 'utf8');
    const name = basename(file, '.md');
    return { source: `docs/${file}`, address: `${name}.html`, name, body, before: 0, language: ENGLISH };
  }));
  const lessons = await Promise.all((await markdownIn(join(root, 'docs/lessons'))).map((file) => readLesson(root, file, faults)));
  lessons.sort((a, b) => a.lesson.number - b.lesson.number);
  lessons.forEach((page, i) => {
    if (i > 0 && lessons[i - 1].lesson.number === page.lesson.number) faults.add(page.source, 1, `there are two lessons ${page.lesson.number}`);
  });
  /** @type {Page[]} */
  const originals = [...lessons, ...pages];
  const [, ...others] = languages ?? await readLanguages(root);
  const translations = await Promise.all(others.map((language) => readTranslations(root, language, originals, faults)));
  return [...originals, ...translations.flat()];
}

/** @param {string} root @param {string} file @param {Faults} faults */
async function readLesson(root, file, faults) {
  const source = `docs/lessons/${file}`;
  const name = basename(file, '.md');
  const { fields, body, before } = frontMatter(await readFile(join(root, source), 'utf8'), source, KEYS, faults);
  for (const key of NEEDED) if (!fields.has(key)) faults.add(source, 1, `a lesson needs "${key}:" between its --- lines`);
  const minutes = Number(fields.get('minutes')?.value ?? 1);
  if (!(Number.isInteger(minutes) && minutes > 0)) faults.add(source, fields.get('minutes')?.line ?? 1, '"minutes" is a whole number');
  const number = Number(/^(\d+)-/.exec(name)?.[1]);
  if (!(number > 0)) faults.add(source, 1, 'a lesson\'s file begins with its number and a hyphen');
  const lesson = { number, title: fields.get('title')?.value ?? name, minutes, fields, goals: [], predictions: [], quizzes: [], opens: new Set() };
  return { source, address: `lessons/${name}.html`, name, body, before, lesson, language: ENGLISH };
}
