// SPDX-License-Identifier: MIT
// Works in the browser's storage: for each visit with changes its document, as a link. Each visit has its own entry, so
// that tabs do not overwrite each other's. The oldest are removed first.
import { remember, remembered, rememberedKeys } from '../browser/storage.js';

/** @typedef {{id: string, title: string, link: string, when: number}} Work  link: a payload; when: ms since 1970 */

const PREFIX = 'gaitsmith-work/';
const MAX_WORKS = 8;

/** Newest first. @returns {Work[]} */
export function keptWorks() {
  return rememberedKeys(PREFIX).map(read).filter((work) => work !== null).sort((a, b) => b.when - a.when);
}

/** @param {Work} work @returns {boolean} false: the storage is full or forbidden */
export function storeWork(work) {
  const text = JSON.stringify(work);
  const old = keptWorks().filter(({ id }) => id !== work.id);
  for (const { id } of old.splice(MAX_WORKS - 1)) removeWork(id);
  // If the storage is full, remove the oldest ones.
  for (;;) {
    if (remember(PREFIX + work.id, text)) return true;
    const oldest = old.pop();
    if (!oldest) return false;
    removeWork(oldest.id);
  }
}

/** @param {string} id */
export function removeWork(id) { remember(PREFIX + id, null); }

/** @param {string} key @returns {Work | null} */
function read(key) {
  try {
    const { title, link, when } = JSON.parse(remembered(key) ?? '');
    if (typeof title !== 'string' || typeof link !== 'string' || typeof when !== 'number') return null;
    return { id: key.slice(PREFIX.length), title, link, when };
  } catch {
    return null; // the entry is damaged
  }
}
