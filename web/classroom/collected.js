// SPDX-License-Identifier: MIT
// Finds what students sent in pasted text and in files: links to works and motions, one or several a line.
import { tr } from '../languages/language.js';
import { decodeWork, emptyWork, isWorkFile, readWorkFile } from '../share/work.js';

/** @typedef {import('../share/work.js').Work} Work */
/**
 * document: text of a saved motion's file.
 * @typedef {{work: Work, document?: string, source: string, fault?: undefined} | {fault: string, source: string}} Entry
 */

const MOST_ENTRIES = 500;
const MOST_CHARACTERS = 5_000_000;
const SHOWN = 60; // characters of a source

/** @param {string} text @returns {{entries: Entry[], idle: number}} idle: lines without a link */
export function collect(text) {
  if (text.length > MOST_CHARACTERS) return { entries: [{ fault: tr('This text is too long for a class’s links.'), source: tr('pasted text') }], idle: 0 };
  /** @type {Entry[]} */
  const entries = [];
  let idle = 0;
  for (const line of text.split(/\r?\n/)) {
    if (line.trim() === '') continue;
    const links = line.split(/[\s<>"']+/).filter((part) => part.includes('#') || part.includes('://'));
    if (links.length === 0) idle++;
    const label = line.split(/[\s<>"']+/).filter((part) => part !== '' && !links.includes(part)).join(' ').replace(/^[\s,;:–-]+|[\s,;:–-]+$/g, '').slice(0, 80);
    for (const link of links) {
      if (entries.length === MOST_ENTRIES) return { entries: [...entries, { fault: tr('More than {1} links: the others are left out.', MOST_ENTRIES), source: '' }], idle };
      entries.push(fromLink(link, links.length === 1 ? label : ''));
    }
  }
  return { entries, idle };
}

/** @param {string} name  of the file @param {string} text @returns {Entry[]} */
export function fromFile(name, text) {
  const source = name.slice(0, SHOWN);
  if (isWorkFile(text)) return [attempt(source, () => ({ work: readWorkFile(text), source }))];
  if (/^\s*\{/.test(text)) return [{ work: { ...emptyWork(), name: name.replace(/\.\w+$/, '').slice(0, 80) }, document: text, source }];
  const { entries } = collect(text);
  return entries.length > 0 ? entries : [{ fault: tr('This file has no link and no motion.'), source }];
}

/** @param {string} link @param {string} label @returns {Entry} */
function fromLink(link, label) {
  const at = link.indexOf('#');
  const payload = at < 0 ? '' : link.slice(at + 1).replace(/[).,;]+$/, '');
  const source = link.length > SHOWN ? `${link.slice(0, SHOWN)}…` : link;
  if (payload === '') return { fault: tr('This address has nothing after a “#”, so it holds no motion.'), source };
  return attempt(source, () => {
    const work = /^H\d+\./.test(payload) ? decodeWork(payload) : { ...emptyWork(), motion: plain(payload) };
    return { work: { ...work, name: work.name || label }, source };
  });
}

/** @param {string} payload */
function plain(payload) {
  if (!/^[\w-]+$/.test(payload)) throw new Error(tr('The part after “#” has characters that no link has.'));
  return payload;
}

/** @param {string} source @param {() => Entry} read @returns {Entry} */
function attempt(source, read) {
  try {
    return read();
  } catch (error) {
    return { fault: error instanceof Error ? error.message : String(error), source };
  }
}
