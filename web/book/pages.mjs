// SPDX-License-Identifier: MIT
// Reads the book's pages from docs/, in order.
import { readdir, readFile } from 'node:fs/promises';
import { basename, join } from 'node:path';
import { readTranslations } from './languages/translations.mjs';
import { ENGLISH, readLanguages } from './languages/words.mjs';
import { lessonOf } from './teaching/lesson_file.mjs';

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
  const lessons = await Promise.all((await markdownIn(join(root, 'docs/lessons'))).map(async (file) => lessonOf(await readFile(join(root, 'docs/lessons', file), 'utf8'), file, faults)));
  const numbered = lessons.filter(({ lesson }) => lesson.number > 0).sort((a, b) => a.lesson.number - b.lesson.number);
  numbered.forEach((page, i) => {
    if (i > 0 && numbered[i - 1].lesson.number === page.lesson.number) faults.add(page.source, 1, `there are two lessons ${page.lesson.number}`);
  });
  // Lessons without a number come behind the others, in the order of their names.
  const last = numbered.at(-1)?.lesson.number ?? 0;
  const others = lessons.filter(({ lesson }) => !(lesson.number > 0));
  others.forEach(({ lesson }, i) => { lesson.number = last + 1 + i; });
  /** @type {Page[]} */
  const originals = [...numbered, ...others, ...pages];
  const [, ...foreign] = languages ?? await readLanguages(root);
  const translations = await Promise.all(foreign.map((language) => readTranslations(root, language, originals, faults)));
  return [...originals, ...translations.flat()];
}
