// SPDX-License-Identifier: MIT
// What a reader has done: lessons, and goals in them. Kept in this browser where that is allowed, and nowhere else.

const KEY = 'gaitsmith-lessons';

/** Of one lesson. @typedef {{done: boolean, goals: string[]}} Done */

/** @returns {Record<string, Done>} by the lessons' names */
function kept() {
  try {
    const value = JSON.parse(localStorage.getItem(KEY) ?? '{}');
    return value && typeof value === 'object' ? value : {};
  } catch {
    return {};
  }
}

/** @param {string} lesson @returns {Done} */
export function progressOf(lesson) {
  const { done, goals } = kept()[lesson] ?? {};
  return { done: done === true, goals: Array.isArray(goals) ? goals : [] };
}

/** @param {string} lesson @param {Partial<Done>} change */
export function keepProgress(lesson, change) {
  try {
    localStorage.setItem(KEY, JSON.stringify({ ...kept(), [lesson]: { ...progressOf(lesson), ...change } }));
  } catch {
    // Then it holds until the page is left.
  }
}

export function hasProgress() { return Object.keys(kept()).length > 0; }

export function forgetProgress() {
  try {
    localStorage.removeItem(KEY);
  } catch {
    // Nothing was kept.
  }
}
