// SPDX-License-Identifier: MIT
// The browser's storage, which may be forbidden (by an embedding page, a private window) or full: reading then finds
// nothing and writing says that it failed.

/** @param {string} key @returns {string | null} */
export function remembered(key, which = /** @type {'localStorage' | 'sessionStorage'} */ ('localStorage')) {
  try {
    return window[which].getItem(key);
  } catch {
    return null;
  }
}

/**
 * @param {string} key @param {string | null} value  null: forget it
 * @returns {boolean} whether it is kept
 */
export function remember(key, value, which = /** @type {'localStorage' | 'sessionStorage'} */ ('localStorage')) {
  try {
    if (value === null) window[which].removeItem(key);
    else window[which].setItem(key, value);
    return true;
  } catch {
    return false;
  }
}

/** Keys that begin so. @param {string} prefix @returns {string[]} */
export function rememberedKeys(prefix) {
  try {
    return Object.keys(localStorage).filter((key) => key.startsWith(prefix));
  } catch {
    return [];
  }
}
