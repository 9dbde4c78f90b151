// SPDX-License-Identifier: MIT
// Makes a SCORM package in the page, from the files of this site. Loaded on first use.
import { tr } from '../languages/language.js';
import { scormFiles } from './scorm_package.js';

/** @typedef {import('./scorm_package.js').Version} Version */
/**
 * name: letters, digits and hyphens; launch: address in the site, with ?scorm; site: its address;
 * onProgress: receives the finished part, from 0 to 1; fetchFile: for tests
 * @typedef {{name: string, title: string, launch: string, version: Version, signal: AbortSignal, onProgress: (share: number) => void, site?: string, fetchFile?: typeof fetch}} Order
 */

const AT_ONCE = 4; // requests
const TIME = new Date(1980, 0, 1); // the earliest of a ZIP: the same files give the same bytes
const LEVEL = 6;

/** @param {Order} order @returns {Promise<Blob>} rejected with a sentence, or with the signal's reason */
export async function makeScormPackage({ name, title, launch, version, signal, onProgress, site = new URL('../', import.meta.url).href, fetchFile = fetch }) {
  const hashes = await listed(site, signal, fetchFile);
  const names = Object.keys(hashes).sort();
  const { Zip, ZipDeflate } = await import('./fflate.js');
  /** @type {BlobPart[]} */
  const parts = [];
  const zip = new Zip((error, bytes) => {
    if (error) throw error;
    parts.push(/** @type {Uint8Array<ArrayBuffer>} */ (bytes));
  });
  const add = (/** @type {string} */ file, /** @type {Uint8Array} */ bytes) => {
    const entry = new ZipDeflate(file, { level: LEVEL });
    entry.mtime = TIME;
    zip.add(entry);
    entry.push(bytes, true);
  };
  for (const [file, text] of Object.entries(scormFiles({ name, title, launch, version, files: names }))) add(file, new TextEncoder().encode(text));
  // A few requests at a time, and one order of files.
  for (let i = 0; i < names.length; i += AT_ONCE) {
    const some = names.slice(i, i + AT_ONCE);
    const contents = await Promise.all(some.map((file) => fetched(site, file, hashes[file], signal, fetchFile)));
    signal.throwIfAborted();
    some.forEach((file, k) => add(file, contents[k]));
    onProgress(Math.min(1, (i + AT_ONCE) / names.length));
  }
  zip.end();
  return new Blob(parts, { type: 'application/zip' });
}

/** The site's files and their hashes (web/build/seal.mjs). @param {string} site @param {AbortSignal} signal @param {typeof fetch} fetchFile @returns {Promise<Record<string, string>>} */
async function listed(site, signal, fetchFile) {
  const response = await fetchFile(new URL('files.json', site), { signal, cache: 'no-cache' }).catch(() => null);
  signal.throwIfAborted();
  const files = response?.ok ? await response.json().catch(() => null) : null;
  if (files === null) throw new Error(tr('This copy of the site has no list of its files, or it could not be loaded'));
  return files;
}

/** @param {string} site @param {string} file @param {string} hash @param {AbortSignal} signal @param {typeof fetch} fetchFile */
async function fetched(site, file, hash, signal, fetchFile) {
  try {
    // A file with another hash belongs to another version of the site: the browser refuses it.
    const response = await fetchFile(new URL(file, site), { signal, integrity: hash });
    if (response.ok) return new Uint8Array(await response.arrayBuffer());
  } catch {
    signal.throwIfAborted();
  }
  throw new Error(tr('{1} could not be loaded. Reload the page, and try again', file));
}
