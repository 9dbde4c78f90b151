// SPDX-License-Identifier: MIT
// Uses the site's engine to make addresses and film strips from documents. Also runs in the page that previews a lesson.
import { dayStrip, nightStrip } from './strip_colours.mjs';

/** @typedef {import('../search/engine.js').Engine} Engine */
/** @typedef {{payload: string, document: Uint8Array}} Opened */
/** @typedef {{svg: string, width: number, height: number}} Strip */
/** Strips with many and few poses, for light and dark themes. @typedef {{many: Strip, few: Strip, manyByNight: Strip, fewByNight: Strip}} Strips */

const POSES = { many: 8, few: 4 };
const WORDS = ['{1} poses of {2} from {3} s to {4} s, lettered {5} to {6}.', 'ground tilted by {1}°, drawn level', '.'];

export class Playground {
  /** By file, or by payload. @type {Map<string, Opened>} */
  #opened = new Map();

  /** @param {Engine} engine @param {import('../page/goal_conditions.js').Tables} tables @param {(file: string) => Promise<string>} read  the text of a file of the repository, or its link */
  constructor(engine, tables, read) {
    this.engine = engine;
    this.tables = tables;
    this.read = read;
  }

  /** The part of a document's link after '#'. Throws core's sentence. @param {string} file */
  async payload(file) { return (await this.#open(file)).payload; }

  /** The same of a link's payload, in its present form. Throws core's sentence. @param {string} payload */
  async payloadOf(payload) { return (await this.#open(payload, payload)).payload; }

  /** @param {string} file */
  async strips(file) { return this.#strips(await this.#open(file)); }

  /** @param {string} payload  of a link */
  async stripsOf(payload) { return this.#strips(await this.#open(payload, payload)); }

  /** @param {Opened} opened @returns {Strips} */
  #strips({ document }) {
    const motion = this.engine.motion(document);
    try {
      const many = dayStrip(motion.filmStrip(POSES.many, WORDS), 'many');
      const few = dayStrip(motion.filmStrip(POSES.few, WORDS), 'few');
      return { many, few, manyByNight: nightStrip(many), fewByNight: nightStrip(few) };
    } finally {
      motion.close();
    }
  }

  /** @param {string} name @param {string} [text]  JSON, or a link's payload; else that of the file */
  async #open(name, text) {
    let opened = this.#opened.get(name);
    if (!opened) {
      const document = this.engine.documentFromText(text ?? await this.read(name));
      opened = { document, payload: this.engine.link(document) };
      this.#opened.set(name, opened);
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
