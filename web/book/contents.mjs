// SPDX-License-Identifier: MIT
// The groups of the book's pages. Lessons come first.
import { trLater } from '../languages/language.js';

/** Names of files in docs/. Files without a group are in the last one. @type {{title: string, id: string, names: string[]}[]} */
const GROUPS = [
  { title: trLater('Begin here'), id: 'begin-here', names: ['how-things-learn-to-move'] },
  { title: trLater('Gallery'), id: 'gallery', names: ['gallery', 'pictures'] },
  { title: trLater('For teachers'), id: 'for-teachers', names: ['teachers', 'writing-lessons', 'does-it-teach', 'languages', 'lesson-answers'] },
  { title: trLater('The playground'), id: 'the-playground', names: ['animation', 'exporting', 'style', 'accessibility'] },
  { title: trLater('The engine'), id: 'the-engine', names: ['physics', 'search', 'landscapes', 'spacetime', 'controllers-and-trajectories', 'stricter', 'determinism', 'reliability', 'performance', 'related-work'] },
  { title: trLater('For engineers'), id: 'for-engineers', names: ['engineers', 'embedding', 'runtime', 'published-packages', 'command-line', 'clusters', 'python', 'formats', 'architecture', 'design'] },
];

/** Pages that only other pages lead to: not in the list of pages, nor in the search. @type {ReadonlySet<string>} */
export const UNLISTED = new Set(['lesson-answers']);

export const LESSONS = { title: trLater('Lessons'), id: 'lessons' };

/**
 * The groups that have pages, in order.
 * @template {{name: string, lesson?: object}} P
 * @param {P[]} pages
 * @returns {{title: string, id: string, pages: P[]}[]}
 */
export function grouped(pages) {
  const named = new Set(GROUPS.flatMap(({ names }) => names));
  const groups = GROUPS.map(({ title, id, names }, i) => ({
    title, id,
    pages: [
      ...names.flatMap((name) => pages.filter((page) => !page.lesson && page.name === name)),
      ...(i === GROUPS.length - 1 ? pages.filter((page) => !page.lesson && !named.has(page.name)) : []),
    ],
  }));
  return [{ ...LESSONS, pages: pages.filter((page) => page.lesson) }, ...groups].filter(({ pages: some }) => some.length > 0);
}
