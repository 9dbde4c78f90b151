// SPDX-License-Identifier: MIT
// What a new lesson may link to: the English pages of the book with their headings, its pictures, and the documents of examples/.
import { readdir, readFile } from 'node:fs/promises';
import { join } from 'node:path';

/** documents: payloads by file @typedef {{pages: {source: string, address: string, ids: string[]}[], images: string[], documents: Record<string, string>}} Sources */

/** @param {string} root @param {Map<import('../pages.mjs').Page, import('../markdown.mjs').Rendered>} rendered @param {import('../links.mjs').Links} links @returns {Promise<Sources>} */
export async function sources(root, rendered, { images, playground }) {
  /** @type {Record<string, string>} */
  const documents = {};
  const files = (await readdir(join(root, 'examples'), { recursive: true })).map((file) => `examples/${file.replaceAll('\\', '/')}`);
  for (const file of files.filter((name) => name.endsWith('.json')).sort()) {
    const { controllers } = JSON.parse(await readFile(join(root, file), 'utf8'));
    if (controllers) documents[file] = await playground.payload(file); // a figure or a problem has none
  }
  return { pages: [...rendered].filter(([{ original }]) => !original).map(([{ source, address }, { headings }]) => ({ source, address, ids: headings.map(({ id }) => id) })), images: [...images.keys()], documents };
}
