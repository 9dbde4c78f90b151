// SPDX-License-Identifier: MIT
// The motions whose exported files are tested: shipped ones whole, and two as loops; and of springs one of each.
import { readdir, readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

/** @typedef {import('../../web/search/recorded_motion.js').RecordedMotion} RecordedMotion */

export const ROOT = fileURLToPath(new URL('../../', import.meta.url));
const WEB = process.env.GAITSMITH_WEB ?? join(ROOT, 'build/wasm/web');

export class ExportedMotions {
  /** @param {import('../../web/search/engine.js').Engine} engine @param {Map<string, any>} documents  by file name @param {any} cartwheel @param {any} springs  of springs */
  constructor(engine, documents, cartwheel, springs) {
    this.engine = engine;
    this.documents = documents;
    this.cartwheel = cartwheel;
    this.springs = springs;
  }

  static async load() {
    const { Engine } = await import(pathToFileURL(join(WEB, 'search/engine.js')).href);
    const engine = await Engine.load(await WebAssembly.compile(await readFile(join(WEB, 'search/engine_module.wasm'))));
    const read = async (/** @type {string} */ path) => JSON.parse(await readFile(join(ROOT, path), 'utf8'));
    const documents = new Map();
    for (const folder of ['examples', 'tests/golden/limited']) {
      for (const file of (await readdir(join(ROOT, folder))).filter((name) => name.endsWith('.json'))) documents.set(file, await read(join(folder, file)));
    }
    return new ExportedMotions(engine, documents, await read('examples/gallery/star-man-cartwheel.json'), await read('examples/gallery/table-trip.json'));
  }

  /** @param {any} document */
  bytesOf(document) { return this.engine.documentFromText(JSON.stringify({ ...document, hash: undefined })); }

  /** Whole motions, and loops. @param {(motion: RecordedMotion, name: string) => void} check */
  each(check) {
    for (const [name, document] of this.documents) {
      const motion = this.engine.motion(this.bytesOf(document));
      check(motion, name);
      motion.close();
    }
    // A cartwheel's cycle is a whole turn.
    for (const text of [this.documents.get('star-man-shuffle.json'), this.cartwheel]) {
      const loop = this.engine.loop(this.bytesOf(text));
      check(loop, 'a loop');
      loop.close();
    }
  }

  /** A figure of springs, which formats with bones refuse. @param {(motion: RecordedMotion, name: string) => void} check */
  eachOfSprings(check) {
    const whole = this.engine.motion(this.bytesOf(this.springs)), loop = this.engine.loop(this.bytesOf(this.springs));
    check(whole, 'springs');
    check(loop, 'a loop');
    whole.close();
    loop.close();
  }
}
