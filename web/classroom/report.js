// SPDX-License-Identifier: MIT
// Reports a lesson to a learning system, if the lesson comes in a SCORM package (?scorm).
import { tr } from '../languages/language.js';
import { decodeWork, emptyWork, encodeWork } from '../share/work.js';
import { findApi } from '../share/scorm.js';
import { followProgress, progressOf, storeProgress } from './progress.js';

/**
 * Call before the lesson reads its progress: it brings back what the learning system has kept.
 * @param {string} lesson
 */
export function startReport(lesson) {
  if (!new URLSearchParams(location.search).has('scorm')) return;
  const line = document.createElement('p');
  line.className = 'state';
  line.setAttribute('role', 'status');
  document.querySelector('p.done')?.before(line);
  const say = (/** @type {string} */ sentence) => { line.textContent = sentence; };
  const system = findApi();
  if (!system) return say(tr('No learning system was found around this page. The lesson works, and nothing will be reported.'));
  try {
    const kept = system.begin();
    if (kept) restore(lesson, kept);
    const report = () => {
      const done = progressOf(lesson);
      const parts = scoreOf(done);
      // A motion that is too long to be kept is left out: answers and goals count more.
      const whole = encodeWork({ ...emptyWork(), lesson, predictions: done.predictions, answers: done.answers, text: done.text, motion: done.motion });
      const state = system.holds(whole) ? whole : encodeWork({ ...emptyWork(), lesson, predictions: done.predictions, answers: done.answers, text: done.text.slice(0, 1000) });
      try {
        system.report({ ...parts, state: parts.reached ? `${state}.reached` : state });
        const score = Math.round(parts.score);
        say(parts.reached ? tr('Reported to the learning system: {1} of 100, passed.', score) : tr('Reported to the learning system: {1} of 100.', score));
      } catch (error) {
        say(tr('The learning system refuses the report: {1}', /** @type {Error} */ (error).message));
      }
    };
    report();
    followProgress(report);
  } catch (error) {
    say(tr('The learning system refuses this lesson: {1}', /** @type {Error} */ (error).message));
  }
}

/** Goals and questions count alike. @param {import('./progress.js').Done} done */
function scoreOf({ goals, answers }) {
  const all = [...document.querySelectorAll('.goal')].map((box) => /** @type {HTMLElement} */ (box).dataset.goal ?? '');
  const quizzes = [...document.querySelectorAll('.quiz')];
  const met = all.filter((goal) => goals.includes(goal)).length;
  const right = quizzes.filter((quiz, i) => quiz.querySelector(`input[value="${Number(answers[i] ?? -1)}"][data-right]`)).length;
  return { reached: met === all.length, score: (100 * (met + right)) / Math.max(1, all.length + quizzes.length) };
}

/** @param {string} lesson @param {string} state */
function restore(lesson, state) {
  try {
    const reached = state.endsWith('.reached');
    const work = decodeWork(reached ? state.slice(0, -'.reached'.length) : state);
    if (work.lesson !== lesson) return;
    const goals = reached ? [...document.querySelectorAll('.goal')].map((box) => /** @type {HTMLElement} */ (box).dataset.goal ?? '') : progressOf(lesson).goals;
    storeProgress(lesson, { predictions: work.predictions, answers: work.answers, text: work.text, motion: work.motion, goals });
  } catch {
    // A state of another version is no reason not to learn.
  }
}
