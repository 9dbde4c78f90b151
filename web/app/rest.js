// SPDX-License-Identifier: MIT
// The part of the application that the first screen does without (web/build/split.mjs).
import { compiledModule } from '../browser/compiled_module.js';
import { trLater } from '../languages/language.js';

const ADDRESS = new URL('../app/app_rest.wasm', import.meta.url);
const AGAIN_MS = [0, 1000, 5000, 20000];

/** Loaded after the first frame, or at once where one of its functions is called before. */
export class Rest {
  /** Imports of the first part: functions that are not there yet, by their place in the table. @type {WebAssembly.ModuleImports} */
  placeholder = new Proxy({}, {
    get: (_, place) => (/** @type {unknown[]} */ ...values) => {
      this.#loadNow();
      return this.#table?.get(Number(place))(...values);
    },
  });

  /** @type {WebAssembly.Exports} */
  #first = {};
  /** @type {WebAssembly.Table | undefined} */
  #table;
  #pair = '';
  #here = false;
  /** @type {Promise<WebAssembly.Module | null> | null} */
  #asked = null;
  #failed;

  /** @param {(error: Error) => void} failed  called where a function cannot be had: the application cannot go on */
  constructor(failed) {
    this.#failed = failed;
  }

  /** @param {WebAssembly.Instance} instance @param {WebAssembly.Module} code  of the first part */
  begin(instance, code) {
    this.#first = instance.exports;
    this.#table = Object.values(instance.exports).find((value) => value instanceof WebAssembly.Table);
    this.#pair = pairOf(code);
  }

  /** Begins to load it, beside the first part. */
  ask() { this.#asked = compiledModule(ADDRESS).catch(() => null); }

  /** Loads it by and by. Without a network it tries again later. @returns {Promise<void>} rejected: it is of another version */
  async load() {
    for (const ms of AGAIN_MS) {
      await new Promise((resolve) => { setTimeout(resolve, ms); });
      if (!this.#asked) this.ask();
      const code = await this.#asked;
      this.#asked = null;
      if (this.#here) return;
      if (!code) continue;
      this.#check(code);
      return this.#keep(await WebAssembly.instantiate(code, { primary: this.#first }));
    }
  }

  #loadNow() {
    if (this.#here) return;
    try {
      const request = new XMLHttpRequest();
      request.open('GET', ADDRESS, false); // a call from WebAssembly cannot wait otherwise
      request.overrideMimeType('text/plain; charset=x-user-defined'); // the only way to get bytes at once
      request.send();
      if (request.status !== 200) throw new Error(`${request.status}`);
      const code = new WebAssembly.Module(Uint8Array.from(request.responseText, (letter) => letter.charCodeAt(0)));
      this.#check(code);
      this.#keep(new WebAssembly.Instance(code, { primary: this.#first }));
    } catch (error) {
      this.#failed(error instanceof Error ? error : new Error(String(error)));
      throw error;
    }
  }

  /** The table holds its functions. @param {WebAssembly.Instance} _ */
  #keep(_) { this.#here = true; }

  /** @param {WebAssembly.Module} code */
  #check(code) {
    if (pairOf(code) !== this.#pair) throw new Error(trLater('this page has another version by now'));
  }
}

/** What only two parts of one build have in common. @param {WebAssembly.Module} code */
const pairOf = (code) => String(WebAssembly.Module.customSections(code, 'pair').map((bytes) => new Uint8Array(bytes)));
