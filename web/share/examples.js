// SPDX-License-Identifier: MIT
// Shipped documents that are downloaded when a person opens one. tests/web/examples.test.mjs compares the list with the
// folder examples.
import { tr, trLater, trSentence } from '../languages/language.js';

/** Titles by the names of their files. @type {Readonly<Record<string, string>>} */
export const EXAMPLES = Object.freeze({
  'beryl-wind-up': trLater('Beryl Biped, wound up'),
  'figure-12': trLater('Figure 12: shuffle, cartwheel, jump, shuffle'),
  'star-man-network': trLater('Mr. Star-Man, with a network'),
  'there-and-back': trLater('There and back'),
});

/**
 * @param {import('../app/app.js').App} app @param {import('../access/status_line.js').StatusLine} statusLine
 * @param {string} name  of EXAMPLES
 */
export async function openExample(app, statusLine, name) {
  const answer = await fetch(new URL(`../examples/${name}.json`, import.meta.url)).catch(() => null);
  if (!answer?.ok) return statusLine.say(tr('The example could not be loaded.'));
  const fault = app.open(await answer.text());
  if (fault) statusLine.say(trSentence(fault));
}
