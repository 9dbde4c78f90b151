// SPDX-License-Identifier: MIT
// Works that this browser keeps: the document of each visit in which something was done, as a link. One entry for each
// visit, so that two tabs never write over each other's; the oldest go.
import { remember, remembered, rememberedKeys } from '../browser/storage.js';

/** @typedef {{id: string, title: string, link: string, when: number}} Work  link: a payload; when: ms since 1970 */

const PREFIX = 'gaitsmith-work/';
const MOST = 8;

/** The newest first. @returns {Work[]} */
export function keptWorks() {
  return rememberedKeys(PREFIX).map(read).filter((work) => work !== null).sort((a, b) => b.when - a.when);
}

/** @param {Work} work @returns {boolean} whether it is kept */
export function keepWork(work) {
  const text = JSON.stringify(work);
  const old = keptWorks().filter(({ id }) => id !== work.id);
  for (const { id } of old.splice(MOST - 1)) forgetWork(id);
  // Where the room is short, older ones make way, the oldest first.
  for (;;) {
    if (remember(PREFIX + work.id, text)) return true;
    const oldest = old.pop();
    if (!oldest) return false;
    forgetWork(oldest.id);
  }
}

/** @param {string} id */
export function forgetWork(id) { remember(PREFIX + id, null); }

/** @param {string} key @returns {Work | null} */
function read(key) {
  try {
    const { title, link, when } = JSON.parse(remembered(key) ?? '');
    if (typeof title !== 'string' || typeof link !== 'string' || typeof when !== 'number') return null;
    return { id: key.slice(PREFIX.length), title, link, when };
  } catch {
    return null; // not ours
  }
}
