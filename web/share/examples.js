// SPDX-License-Identifier: MIT
// Shipped documents that are downloaded when a person opens one. The page loads this file after its first frame, or at once if
// its address names an example. tests/web/examples.test.mjs compares the list with the
// folder examples.
import { tr, trLater, trSentence } from '../languages/language.js';

/** Titles by the names of their files. @type {Readonly<Record<string, string>>} */
export const EXAMPLES = Object.freeze({
  'beryl-wind-up': trLater('Beryl Biped, wound up'),
  'figure-12': trLater('Figure 12: shuffle, cartwheel, jump, shuffle'),
  'star-man-network': trLater('Mr. Star-Man, with a network'),
  'there-and-back': trLater('There and back'),
});

/** @param {string} name  of EXAMPLES @returns {Promise<string>} its text, or empty: it could not be loaded */
async function textOf(name) {
  const answer = await fetch(new URL(`../examples/${name}.json`, import.meta.url)).catch(() => null);
  return answer?.ok ? answer.text().catch(() => '') : '';
}

/**
 * The text of an example that a visit begins with; empty if there is none, or it comes with the application.
 * @param {string} name @param {import('../access/status_line.js').StatusLine} statusLine
 */
export async function firstText(name, statusLine) {
  if (!Object.hasOwn(EXAMPLES, name)) return '';
  const text = await textOf(name);
  if (!text) statusLine.say(tr('The example could not be loaded.'));
  return text;
}

/**
 * @param {import('../app/app.js').App} app @param {import('../access/status_line.js').StatusLine} statusLine
 * @param {string} name  of EXAMPLES
 */
export async function openExample(app, statusLine, name) {
  const text = await textOf(name);
  const fault = text ? app.open(text) : tr('The example could not be loaded.');
  if (fault) statusLine.say(trSentence(fault));
}
