// SPDX-License-Identifier: MIT
// Finished lessons, reached goals, predictions and answers, in the browser's storage.

const KEY = 'gaitsmith-lessons';
/** Called after each change. @type {Set<() => void>} */
const followers = new Set();
/** Where the browser forbids storage: lasts until the page is closed. @type {Record<string, Done>} */
let unstored = {};

/**
 * Progress in a lesson. goals: reached, by their conditions; predictions and answers: in the order of the text, null: none; motion: the last
 * one that reached a goal, as a link's payload; seen: whether Notice was opened.
 * @typedef {{done: boolean, goals: string[], predictions: (number | null)[], answers: (number | null)[], text: string, motion: string, seen: boolean}} Done
 */

/** @returns {Record<string, Done>} by the lessons' names */
function stored() {
  try {
    const value = JSON.parse(localStorage.getItem(KEY) ?? '{}');
    return { ...value && typeof value === 'object' ? value : {}, ...unstored };
  } catch {
    return unstored;
  }
}

/** @param {string} lesson @returns {Done} */
export function progressOf(lesson) {
  const { done, goals, predictions, answers, text, motion, seen } = stored()[lesson] ?? {};
  const list = (/** @type {any} */ value) => (Array.isArray(value) ? value : []);
  const words = (/** @type {any} */ value) => (typeof value === 'string' ? value : '');
  return { done: done === true, goals: list(goals), predictions: list(predictions), answers: list(answers), text: words(text), motion: words(motion), seen: seen === true };
}

/** @param {string} lesson @param {Partial<Done>} change */
export function storeProgress(lesson, change) {
  const all = { ...stored(), [lesson]: { ...progressOf(lesson), ...change } };
  try {
    localStorage.setItem(KEY, JSON.stringify(all));
  } catch {
    unstored = all;
  }
  for (const follower of followers) follower();
}

/** @param {() => void} changed  called after each change that this page makes */
export function followProgress(changed) { followers.add(changed); }

export function hasProgress() { return Object.keys(stored()).length > 0; }

export function clearProgress() {
  unstored = {};
  try {
    localStorage.removeItem(KEY);
  } catch {
    // Without storage there is nothing to clear.
  }
}
