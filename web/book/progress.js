// SPDX-License-Identifier: MIT
// The finished lessons and reached goals, in the browser's storage.

const KEY = 'gaitsmith-lessons';

/** Progress in a lesson. @typedef {{done: boolean, goals: string[]}} Done */

/** @returns {Record<string, Done>} by the lessons' names */
function stored() {
  try {
    const value = JSON.parse(localStorage.getItem(KEY) ?? '{}');
    return value && typeof value === 'object' ? value : {};
  } catch {
    return {};
  }
}

/** @param {string} lesson @returns {Done} */
export function progressOf(lesson) {
  const { done, goals } = stored()[lesson] ?? {};
  return { done: done === true, goals: Array.isArray(goals) ? goals : [] };
}

/** @param {string} lesson @param {Partial<Done>} change */
export function storeProgress(lesson, change) {
  try {
    localStorage.setItem(KEY, JSON.stringify({ ...stored(), [lesson]: { ...progressOf(lesson), ...change } }));
  } catch {
    // Without storage the progress lasts until the page is closed.
  }
}

export function hasProgress() { return Object.keys(stored()).length > 0; }

export function clearProgress() {
  try {
    localStorage.removeItem(KEY);
  } catch {
    // Without storage there is nothing to clear.
  }
}
