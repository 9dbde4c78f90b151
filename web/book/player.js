// SPDX-License-Identifier: MIT
// The playground inside another page, as an object: it asks and is told by messages, of the same origin or another.
//
//   import { Player } from './player.js';
//   const player = new Player(document.querySelector('iframe'));
//   player.addEventListener('goal', ({ detail }) => console.log(detail.met));
//   await player.call('open', 'https://example.org/gaitsmith/#AZ4…');
//
// It needs nothing else: copy it. Calls and events stand in Gaitsmith's docs/embedding.md.

const VERSION = 1;
const PATIENCE_MS = 20000; // a slow machine takes its time to start

/** An event of the playground: 'progress', 'done', 'error', 'changed' or 'goal'; and 'ready', when it has answered. */
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
    /** What the playground says of itself when it has started: {version, hash, …}. @type {Promise<any>} */
    this.ready = new Promise((resolve) => { this.#greeted = resolve; });
    this.listener = (/** @type {MessageEvent} */ event) => this.#receive(event);
    this.greeting = () => { this.#greet(); };
    addEventListener('message', this.listener);
    frame.addEventListener('load', this.greeting);
    this.#greet(); // it may have started before us
  }

  /** @param {string} name @param {...any} args @returns {Promise<any>} rejected with the playground's sentence */
  async call(name, ...args) {
    /** @type {ReturnType<typeof setTimeout> | undefined} */
    let timer;
    const silence = new Promise((_, reject) => { timer = setTimeout(() => reject(new Error('the playground does not answer')), PATIENCE_MS); });
    await Promise.race([this.ready, silence]).finally(() => clearTimeout(timer));
    return this.#ask(name, args, this.#origin);
  }

  /** Listens no longer. */
  close() {
    removeEventListener('message', this.listener);
    this.frame.removeEventListener('load', this.greeting);
    this.#abandon('the player is closed');
  }

  /** Of the playground; a page that was opened from a file has none. */
  get #origin() {
    const { origin } = new URL(this.frame.src, location.href);
    return origin === 'null' ? '*' : origin;
  }

  /** Whoever stands in the frame is asked who it is; that is no secret, so anyone may hear it. */
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
      if (this.#known) this.#abandon('the playground was loaded anew'); // and has forgotten what it was asked
      this.#known = false;
      this.#greet();
    } else if (typeof data.event === 'string') {
      this.dispatchEvent(new PlayerEvent(data.event, data.detail));
    } else {
      const asked = this.#waiting.get(data.id);
      this.#waiting.delete(data.id);
      if (data.error === undefined) asked?.resolve(data.result);
      else asked?.reject(new Error(data.error));
    }
  }
}
