// SPDX-License-Identifier: MIT
// The index for the book's search (find.js): every section of every page.
import MiniSearch from 'minisearch';

/** @typedef {import('./markdown.mjs').Section} Section */
/** A possible result. @typedef {{id: number, href: string, title: string, heading: string, text: string}} Place */

/** @param {{address: string, title: string, sections: Section[]}[]} pages @returns {string} JSON */
export function searchIndex(pages) {
  const search = new MiniSearch({ fields: ['title', 'heading', 'text'], storeFields: ['href', 'title', 'heading', 'text'] });
  const places = pages.flatMap(({ address, title, sections }) => sections.map(({ heading, id, text }) => ({
    href: id ? `${address}#${id}` : address, title, heading: id ? heading : '', text: text.replace(/\s+/g, ' ').trim(),
  })));
  search.addAll(places.filter(({ heading, text }) => heading || text).map((place, id) => ({ id, ...place })));
  return JSON.stringify(search);
}
