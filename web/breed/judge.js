// SPDX-License-Identifier: MIT
// "More like this" and "Less like this" on a result's card. Loaded on first use.
import { Engine } from '../search/engine.js';
import { Likes } from './likes.js';
import { compiledEngine } from '../search/compiled_engine.js';
import { openBreed } from './breed.js';
import { toast } from '../browser/dom.js';
import { tr } from '../languages/language.js';

const COMPARED = 8; // the newest other results

/** Compares a result with the others of its figure. More: breeds from it, too. @param {import('./breed.js').Parts} parts @param {string} id @param {boolean} more */
export async function learnFrom(parts, id, more) {
  const { app } = parts;
  const results = app.found().filter(({ score }) => score !== null);
  const engine = await Engine.load(await compiledEngine());
  const documents = results.map((result) => ({ result, document: engine.documentFromText(result.link) }));
  const figureOf = (/** @type {Uint8Array} */ document) => JSON.stringify(/** @type {import('../app/app.js').DocumentJson} */ (engine.json(document)).figure);
  const chosen = documents.find(({ result }) => result.id === id);
  if (!chosen) return;
  const figure = figureOf(chosen.document);
  const others = documents.filter((one) => one !== chosen && figureOf(one.document) === figure).slice(0, COMPARED);
  const shown = (/** @type {Uint8Array} */ document) => ({ traits: engine.traitsOf(document) });
  const likes = new Likes(engine);
  const [one, rest] = [[shown(chosen.document)], others.map(({ document }) => shown(document))];
  likes.learn(more ? one : rest, more ? rest : one);
  likes.close();
  if (!more) return toast(others.length > 0 ? tr('Noted: you prefer the other results to this one.') : tr('There is no other result of this figure to prefer yet.'));
  app.showFound(id);
  await openBreed(parts);
}
