// SPDX-License-Identifier: MIT
// Controls a playground inside another page with messages, from the same origin or another one.
//
//   import { Player } from './player.js';
//   const player = new Player(document.querySelector('iframe'));
//   player.addEventListener('goal', ({ detail }) => console.log(detail.met));
//   await player.call('open', 'https://example.org/gaitsmith/#AZ4…');
//
// Copy this file: it has no dependencies. Gaitsmith's docs/embedding.md describes the calls and events.

const VERSION = 1;
const TIMEOUT_MS = 20000; // enough for the start on a slow machine

/** An event of the playground: 'progress', 'done', 'error', 'changed', 'goal', or 'ready' after it has answered. */
export class PlayerEvent extends Event {
  /** @param {string} type @param {any} detail */
  constructor(type, detail) {
    super(type);
    this.detail = detail;
  }
}

export class Player extends EventTarget {
  #number = 0;
  /** Calls without an answer yet. @type {Map<number, {resolve: (result: any) => void, reject: (error: Error) => void}>} */
  #waiting = new Map();
  /** @type {(hello: any) => void} */
  #greeted = () => {};
  #known = false;

  /** @param {HTMLIFrameElement} frame  whose src is the playground's address */
  constructor(frame) {
    super();
    this.frame = frame;
    /** Resolved when the playground has started, with its data: {version, hash, …}. @type {Promise<any>} */
    this.ready = new Promise((resolve) => { this.#greeted = resolve; });
    this.listener = (/** @type {MessageEvent} */ event) => this.#receive(event);
    this.greeting = () => { this.#greet(); };
    addEventListener('message', this.listener);
    frame.addEventListener('load', this.greeting);
    this.#greet(); // the playground may have started already
  }

  /** @param {string} name @param {...any} args @returns {Promise<any>} rejected with the playground's sentence */
  async call(name, ...args) {
    /** @type {ReturnType<typeof setTimeout> | undefined} */
    let timer;
    const silence = new Promise((_, reject) => { timer = setTimeout(() => reject(new Error('the playground does not answer')), TIMEOUT_MS); });
    await Promise.race([this.ready, silence]).finally(() => clearTimeout(timer));
    return this.#ask(name, args, this.#origin);
  }

  /** Stops listening. */
  close() {
    removeEventListener('message', this.listener);
    this.frame.removeEventListener('load', this.greeting);
    this.#abandon('the player is closed');
  }

  /** The playground's origin. '*' for a page that was opened from a file, which has none. */
  get #origin() {
    const { origin } = new URL(this.frame.src, location.href);
    return origin === 'null' ? '*' : origin;
  }

  /** Sends 'hello' to any page in the frame. The message contains no secret. */
  #greet() {
    this.#ask('hello', [], '*').then((hello) => {
      this.#known = true;
      this.#greeted(hello);
      this.dispatchEvent(new PlayerEvent('ready', hello));
    }, () => {});
  }

  /** @param {string} call @param {any[]} args @param {string} origin @returns {Promise<any>} */
  #ask(call, args, origin) {
    return new Promise((resolve, reject) => {
      const id = ++this.#number;
      this.#waiting.set(id, { resolve, reject });
      this.frame.contentWindow?.postMessage({ gaitsmith: VERSION, id, call, args }, origin);
    });
  }

  /** @param {string} sentence */
  #abandon(sentence) {
    for (const { reject } of this.#waiting.values()) reject(new Error(sentence));
    this.#waiting.clear();
  }

  /** @param {MessageEvent} message */
  #receive({ source, origin, data }) {
    if (source !== this.frame.contentWindow || data?.gaitsmith !== VERSION) return;
    if (this.#origin !== '*' && origin !== this.#origin) return;
    if (data.event === 'ready') {
      if (this.#known) this.#abandon('the playground was loaded anew'); // so open calls will get no answer
      this.#known = false;
      this.#greet();
    } else if (typeof data.event === 'string') {
      this.dispatchEvent(new PlayerEvent(data.event, data.detail));
    } else {
      const pending = this.#waiting.get(data.id);
      this.#waiting.delete(data.id);
      if (data.error === undefined) pending?.resolve(data.result);
      else pending?.reject(new Error(data.error));
    }
  }
}
