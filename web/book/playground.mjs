// SPDX-License-Identifier: MIT
// Uses the site's engine to make addresses and film strips from documents.
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { dayStrip, nightStrip } from './strip_colours.mjs';

/** @typedef {import('../search/engine.js').Engine} Engine */
/** @typedef {{payload: string, document: Uint8Array}} Opened */
/** @typedef {{svg: string, width: number, height: number}} Strip */
/** Strips with many and few poses, for light and dark themes. @typedef {{many: Strip, few: Strip, manyByNight: Strip, fewByNight: Strip}} Strips */

const POSES = { many: 8, few: 4 };
const WORDS = ['{1} poses of {2} from {3} s to {4} s, lettered {5} to {6}.', 'ground tilted by {1}°, drawn level', '.'];

export class Playground {
  /** By path. @type {Map<string, Opened>} */
  #opened = new Map();

  /** @param {Engine} engine @param {import('../page/goal_conditions.js').Tables} tables */
  constructor(engine, tables) {
    this.engine = engine;
    this.tables = tables;
  }

  /** @param {string} site  the built one */
  static async load(site) {
    const { Engine } = await import(pathToFileURL(join(site, 'search/engine.js')).href);
    const tables = await import(pathToFileURL(join(site, 'catalogue/catalogue.js')).href);
    return new Playground(await Engine.load(), tables);
  }

  /** The part of a document's link after '#'. Throws core's sentence. @param {string} path */
  async payload(path) {
    return (await this.#open(path)).payload;
  }

  /** @param {string} path @returns {Promise<Strips>} */
  async strips(path) {
    const motion = this.engine.motion((await this.#open(path)).document);
    try {
      const many = dayStrip(motion.filmStrip(POSES.many, WORDS), 'many');
      const few = dayStrip(motion.filmStrip(POSES.few, WORDS), 'few');
      return { many, few, manyByNight: nightStrip(many), fewByNight: nightStrip(few) };
    } finally {
      motion.close();
    }
  }

  /** @param {string} path */
  async #open(path) {
    let opened = this.#opened.get(path);
    if (!opened) {
      const document = this.engine.documentFromText(await readFile(path, 'utf8'));
      opened = { document, payload: Buffer.from(document).toString('base64url') };
      this.#opened.set(path, opened);
    }
    return opened;
  }
}

/**
 * The query and the fragment of an address that opens a document.
 * @param {string} payload @param {Iterable<[string, string]>} query
 */
export function playgroundAddress(payload, query) {
  const text = new URLSearchParams([...query]).toString().replaceAll('%2C', ',').replace('edit=', 'edit');
  return `index.html${text && `?${text}`}#${payload}`;
}
