// SPDX-License-Identifier: MIT
// The file of a lesson: its text, and what stands between its --- lines. Used by the build and by the page where lessons
// are written.
import { frontMatter } from '../front_matter.mjs';
import { ENGLISH } from '../languages/english.mjs';

/** @typedef {import('../faults.mjs').Faults} Faults */
/** @typedef {import('../lesson_page.mjs').LessonPage} LessonPage */

/** What stands between the --- lines, in the order in which it is written. */
export const KEYS = ['title', 'minutes', 'open', 'panels', 'lock', 'goal'];
const NEEDED = ['title', 'minutes', 'open'];

/** @param {string} text @param {string} file  its name in docs/lessons @param {Faults} faults @returns {LessonPage} its number is 0 if the file has none */
export function lessonOf(text, file, faults) {
  const source = `docs/lessons/${file}`;
  const name = file.replace(/\.md$/, '');
  const { fields, body, before } = frontMatter(text, source, KEYS, faults);
  for (const key of NEEDED) if (!fields.get(key)?.value) faults.add(source, fields.get(key)?.line ?? 1, `a lesson needs "${key}:" between its --- lines`);
  const minutes = Number(fields.get('minutes')?.value || 1);
  if (!(Number.isInteger(minutes) && minutes > 0)) faults.add(source, fields.get('minutes')?.line ?? 1, '"minutes" is a whole number');
  if (!/^(?!0)[a-z0-9-]{1,60}$/.test(name)) faults.add(source, 1, 'the name of a lesson\'s file has small letters, digits and hyphens, at most 60');
  const number = Number(/^(\d+)-/.exec(name)?.[1] ?? 0);
  const lesson = { number, title: fields.get('title')?.value ?? name, minutes, fields, goals: [], predictions: [], quizzes: [], opens: new Set() };
  return { source, address: `lessons/${name}.html`, name, body, before, lesson, language: ENGLISH };
}

/** The text of a file. @param {Record<string, string>} fields  by KEYS; empty ones are left out @param {string} body */
export function lessonText(fields, body) {
  const line = (/** @type {string} */ key) => {
    const value = (fields[key] ?? '').replace(/\s+/g, ' ').trim();
    return value === '' ? [] : [`${key}: ${/^".*"$/.test(value) ? `"${value}"` : value}`]; // the reader takes one pair of quotes away
  };
  return ['---', ...KEYS.flatMap(line), '---', body.replace(/\r\n?/g, '\n').trimEnd(), ''].join('\n');
}

/** A file's name for a title. @param {string} title */
export function fileOf(title) {
  const name = title.toLowerCase().replaceAll('ß', 'ss').normalize('NFD').replace(/\p{M}/gu, '').replace(/[^a-z0-9]+/g, '-').replace(/^[0-9-]+|-+$/g, '').slice(0, 60).replace(/-+$/, '');
  return `${name || 'lesson'}.md`;
}
