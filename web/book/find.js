// SPDX-License-Identifier: MIT
// The search of the book. Its indexes are fetched on first use.
import { tr } from '../languages/language.js';
import MiniSearch from './minisearch.js';

/** @typedef {{href: string, title: string, heading: string, text: string, terms: string[], score: number}} Found */

const MAX_RESULTS = 20;
const REST_MS = 120;
const TEXT_BEFORE = 70; // characters before the first found word
const SNIPPET = 180;
const REFERENCE_WEIGHT = 0.3; // the reference has an entry for every function, but pages that explain should come first

const form = /** @type {HTMLFormElement} */ (document.getElementById('find'));
const input = /** @type {HTMLInputElement} */ (document.getElementById('find-words'));
const count = /** @type {HTMLElement} */ (document.getElementById('find-count'));
const list = /** @type {HTMLElement} */ (document.getElementById('found'));
const groups = /** @type {HTMLElement} */ (document.getElementById('groups'));

/** @type {Promise<any[]> | undefined} */
let indexes;
/** @type {ReturnType<typeof setTimeout> | undefined} */
let timer;

/** @param {string} address */
async function fetchIndex(address) {
  const answer = await fetch(address);
  if (!answer.ok) throw new Error(answer.statusText);
  return MiniSearch.loadJSON(await answer.text(), { fields: ['title', 'heading', 'text'], storeFields: ['href', 'title', 'heading', 'text'] });
}

/** The index of the pages, and those of the design decisions and of the reference, which are English and not there without a network, or without Doxygen. */
function load() {
  const apart = document.documentElement.lang === 'en' ? ['design_search.json', 'reference/search.json'] : [];
  indexes ??= Promise.all([fetchIndex('search.json'), ...apart.map((address) => fetchIndex(address).catch(() => null))])
    .then((both) => both.filter((index) => index !== null));
  indexes.catch(() => { indexes = undefined; }); // try again next time
  return indexes;
}

/** The best of all indexes first. @param {string} words @returns {Promise<Found[]>} */
async function placesOf(words) {
  const how = { prefix: true, fuzzy: (/** @type {string} */ term) => (term.length > 5 ? 0.2 : false), combineWith: 'AND', boost: { title: 4, heading: 3 }, boostDocument };
  return (await load()).flatMap((index) => index.search(words, how)).sort((a, b) => b.score - a.score);
}

/** The text around the first found word, with all found words marked. @param {Found} found */
function snippet({ text, terms }) {
  const words = new RegExp(`(${terms.map((term) => term.replace(/[\\^$.*+?()[\]{}|/]/g, '\\$&')).join('|')})`, 'giu');
  const at = Math.max(0, text.search(words) - TEXT_BEFORE);
  const from = at === 0 ? 0 : text.indexOf(' ', at) + 1;
  const part = `${from > 0 ? '… ' : ''}${text.slice(from, from + SNIPPET)}${from + SNIPPET < text.length ? ' …' : ''}`;
  const line = document.createElement('p');
  for (const [i, piece] of part.split(words).entries()) {
    if (i % 2 === 0) line.append(piece);
    else line.append(Object.assign(document.createElement('mark'), { textContent: piece }));
  }
  return line;
}

/** Full weight for the reference if the term is a name in it, such as MakeSearch. @param {number} _ @param {string} term @param {any} found */
const boostDocument = (_, term, { href, heading }) => (!href.startsWith('reference/') || (/[a-z][A-Z]/.test(heading) && heading.toLowerCase() === term) ? 1 : REFERENCE_WEIGHT);

/** @param {Found} found */
function item(found) {
  const row = document.createElement('li');
  const link = document.createElement('a');
  link.href = found.href;
  link.textContent = found.heading || found.title;
  row.append(link);
  if (found.heading) row.append(' ', Object.assign(document.createElement('small'), { textContent: found.title }));
  row.append(snippet(found));
  return row;
}

async function find() {
  const words = input.value.trim();
  try {
    const found = words === '' ? [] : await placesOf(words);
    if (words !== input.value.trim()) return; // the input has changed meanwhile
    list.replaceChildren(...found.slice(0, MAX_RESULTS).map(item));
    list.hidden = found.length === 0;
    groups.hidden = words !== '';
    count.textContent = words === '' ? '' : found.length === 0 ? tr('Nothing has these words.')
      : found.length > MAX_RESULTS ? tr('The best {1} of {2} places', MAX_RESULTS, found.length) : found.length === 1 ? tr('One place') : tr('{1} places', found.length);
    history.replaceState(null, '', words === '' ? location.pathname + location.hash : `?q=${encodeURIComponent(words)}`);
  } catch {
    count.textContent = tr('The search could not be loaded.');
  }
}

const links = () => [...list.querySelectorAll('a')];

input.addEventListener('focus', () => { void load().catch(() => {}); }, { once: true });
input.addEventListener('input', () => {
  clearTimeout(timer);
  timer = setTimeout(find, REST_MS);
});
form.addEventListener('submit', async (event) => {
  event.preventDefault();
  clearTimeout(timer);
  await find();
  links()[0]?.focus();
});
addEventListener('keydown', (event) => {
  const at = links().indexOf(/** @type {HTMLAnchorElement} */ (document.activeElement));
  if (document.activeElement !== input && at < 0) return;
  if (event.key === 'Escape' && at >= 0) input.focus();
  else if (event.key === 'ArrowDown') links()[at + 1]?.focus();
  else if (event.key === 'ArrowUp' && at >= 0) (links()[at - 1] ?? input).focus();
  else return;
  event.preventDefault();
});

const initialQuery = new URLSearchParams(location.search).get('q');
if (initialQuery) {
  input.value = initialQuery;
  void find();
}
