// SPDX-License-Identifier: MIT
// Blocks of a translated page have only words. What is not words comes from the English block: a goal's conditions, which
// answer is right, what a button calls, what a stage opens.
import { WORDS } from '../../languages/prepared.mjs';
import { numbersIn } from './numbers.mjs';

/** @typedef {import('../faults.mjs').Faults} Faults */
/** @typedef {import('../pages.mjs').Page} Page */
/** @typedef {(english: string, translated: string, say: (sentence: string) => void, pages: {original: Page, page: Page}) => string} Overlay */

/** @type {Overlay} */
function goal(english, translated, say) {
  const [conditions] = english.split('\n');
  if (/^[a-z_]+\s*(>=|<=|!=|>|<|=)/.test(translated)) say('the conditions of a goal stand only in the English file');
  return `${conditions}\n${translated}`;
}

/** @type {Overlay} */
function choices(english, translated, say, { original, page }) {
  const [lines, others] = [english, translated].map((text) => text.trim().split('\n'));
  if (lines.length !== others.length) {
    say(`this block has ${others.length} lines, the English one has ${lines.length}`);
    return english;
  }
  return others.map((line, i) => {
    const [numbers, wanted] = [numbersIn(line, page), numbersIn(lines[i], original)];
    if (numbers !== wanted) say(`line ${i + 1} has the numbers ${numbers || '(none)'}, the English one ${wanted || '(none)'}`);
    if (/^\(x\)/.test(line)) say('which answer is right stands only in the English file: write ( )');
    return /^\(x\)/.test(lines[i]) ? line.replace(/^\( \)/, '(x)') : line;
  }).join('\n');
}

/** @type {Overlay} */
function words(english, translated, say) {
  try {
    const [all, given] = [JSON.parse(english), JSON.parse(translated)];
    for (const key of WORDS.filter((each) => Object.hasOwn(all, each) && !Object.hasOwn(given, each))) say(`"${key}" is missing`);
    const strange = Object.keys(given).filter((key) => !WORDS.includes(key) || !Object.hasOwn(all, key));
    if (strange.length > 0) say(`"${strange.join('", "')}" stands only in the English file`);
    if (Array.isArray(all.names) && all.names.length !== given.names?.length) say(`"names" has ${all.names.length} entries in the English file`);
    return JSON.stringify({ ...all, ...given });
  } catch {
    say('the words of this block are written as JSON');
    return english;
  }
}

/** By the word after the fence. @type {Record<string, Overlay>} */
const OVERLAYS = { goal, quiz: choices, predict: choices, do: words, stage: words };

/** Whether translations must have the same structure. @param {Page} page */
export const isStrict = ({ lesson, body }) => lesson !== undefined || new RegExp(`^\`\`\`(${Object.keys(OVERLAYS).join('|')})$`, 'm').test(body);

/** The whole block of a translated page. @param {string} kind @param {string} english @param {Page} page @param {number} line  of its fence @param {string} translated @param {Faults} faults */
export function laidOver(kind, english, page, line, translated, faults) {
  const { original } = page;
  if (!original || !Object.hasOwn(OVERLAYS, kind)) return translated;
  return OVERLAYS[kind](english, translated, (sentence) => faults.add(page.source, line, sentence), { original, page });
}
