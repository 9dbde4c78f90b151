// SPDX-License-Identifier: MIT
// The browser's storage. It may be forbidden (by an embedding page or a private window) or full. Then reading finds
// nothing and writing returns false.

/** @param {string} key @returns {string | null} */
export function remembered(key, which = /** @type {'localStorage' | 'sessionStorage'} */ ('localStorage')) {
  try {
    return window[which].getItem(key);
  } catch {
    return null;
  }
}

/**
 * @param {string} key @param {string | null} value  null: removes the entry
 * @returns {boolean} false: the storage is forbidden or full
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

/** The keys with this prefix. @param {string} prefix @returns {string[]} */
export function rememberedKeys(prefix) {
  try {
    return Object.keys(localStorage).filter((key) => key.startsWith(prefix));
  } catch {
    return [];
  }
}
