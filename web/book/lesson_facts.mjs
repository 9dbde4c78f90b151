// SPDX-License-Identifier: MIT
// What the wall must know of the lessons: goals, questions, and the worlds and figures that they open.
import { figureOf, worldOf } from '../classroom/judge.js';

/** @typedef {import('./lesson_page.mjs').LessonPage} LessonPage */

/** @param {LessonPage[]} lessons  rendered @param {import('./playground.mjs').Playground} playground @returns {import('../classroom/judge.js').LessonFacts[]} */
export function lessonFacts(lessons, { engine }) {
  return lessons.map(({ name, lesson }) => {
    const documents = [...lesson.opens].map((payload) => /** @type {any} */ (engine.json(engine.documentFromText(payload))));
    const distinct = (/** @type {any[]} */ values) => [...new Set(values.map((value) => JSON.stringify(value)))].map((text) => JSON.parse(text));
    return {
      name, title: `${lesson.number}. ${lesson.title}`, goals: lesson.goals, predictions: lesson.predictions, quizzes: lesson.quizzes,
      worlds: distinct(documents.map(worldOf)), figures: distinct(documents.map(figureOf)),
    };
  });
}
