// SPDX-License-Identifier: MIT
// A browser that speaks W3C WebDriver: the few commands that the tests of WebKit need. What Puppeteer's pages have, too,
// has the same name here, so that a PageDriver can drive either.
import assert from 'node:assert/strict';
import { request } from 'node:http';
import { sleep } from './page_driver.mjs';

const PATIENCE_MS = 60000;
/** The driver itself gives up after PATIENCE_MS, if it is alive. */
const ANSWER_MS = 2 * PATIENCE_MS;

/** Keys that W3C WebDriver knows by characters of their own. @type {Record<string, string>} */
const KEYS = { Tab: '\ue004', Enter: '\ue007', Shift: '\ue008', Control: '\ue009', Escape: '\ue00c', ArrowLeft: '\ue012', ArrowUp: '\ue013', ArrowRight: '\ue014', ArrowDown: '\ue015' };

export class WebDriver {
  /** What a mouse does, one step at a time. */
  mouse = {
    move: (/** @type {number} */ x, /** @type {number} */ y) => this.#point({ type: 'pointerMove', duration: 0, x: Math.round(x), y: Math.round(y) }),
    down: () => this.#point({ type: 'pointerDown', button: 0 }),
    up: () => this.#point({ type: 'pointerUp', button: 0 }),
  };

  keyboard = {
    down: (/** @type {string} */ key) => this.#type([{ type: 'keyDown', value: KEYS[key] ?? key }]),
    up: (/** @type {string} */ key) => this.#type([{ type: 'keyUp', value: KEYS[key] ?? key }]),
    press: (/** @type {string} */ key) => this.#type([{ type: 'keyDown', value: KEYS[key] ?? key }, { type: 'pause', duration: 30 }, { type: 'keyUp', value: KEYS[key] ?? key }]),
  };

  /** @param {string} session  its address @param {string} version  of the browser */
  constructor(session, version) {
    this.session = session;
    this.version = version;
  }

  /** Starts a browser with a new profile. @param {string} driver  its address */
  static async open(driver) {
    // The driver needs a moment to start.
    for (const start = Date.now(); ; await sleep(50)) {
      if ((await fetch(`${driver}/status`).catch(() => null))?.ok) break;
      assert.ok(Date.now() - start < PATIENCE_MS, `no driver at ${driver}`);
    }
    const { sessionId, capabilities } = await command('POST', `${driver}/session`, { capabilities: {} });
    const browser = new WebDriver(`${driver}/session/${sessionId}`, `${capabilities.browserName} ${capabilities.browserVersion}`);
    await browser.#post('timeouts', { script: PATIENCE_MS, pageLoad: PATIENCE_MS });
    await browser.#post('window/rect', { width: 1280, height: 800 });
    return browser;
  }

  /** @param {string} address */
  go(address) { return this.#post('url', { url: address }); }

  close() { return command('DELETE', this.session); }

  /**
   * Evaluates a function, or an expression, in the page. @template {unknown[]} A, R
   * @param {((...values: A) => R | Promise<R>) | string} body  uses only its arguments and the page @param {A} values
   * @returns {Promise<R>}
   */
  async evaluate(body, ...values) {
    const call = typeof body === 'string' ? `() => (${body})` : body;
    const { value, fault } = await this.#post('execute/async', { args: values, script: `
      const values = [...arguments], finish = values.pop();
      Promise.resolve().then(() => (${call})(...values)).then((value) => finish({ value }), (error) => finish({ fault: String(error) }));` });
    assert.equal(fault, undefined);
    return value;
  }

  /** An element's place. @param {string} selector */
  async $(selector) {
    const box = await this.evaluate((where) => {
      const { x, y, width, height } = document.querySelector(where)?.getBoundingClientRect() ?? {};
      return x === undefined ? null : { x, y, width, height };
    }, selector);
    return box && { boundingBox: async () => box };
  }

  /** The window's picture, PNG as base64. @returns {Promise<string>} */
  screenshot() { return command('GET', `${this.session}/screenshot`); }

  /** @param {object} step */
  #point(step) { return this.#post('actions', { actions: [{ type: 'pointer', id: 'mouse', parameters: { pointerType: 'mouse' }, actions: [step] }] }); }

  /** @param {object[]} steps */
  #type(steps) { return this.#post('actions', { actions: [{ type: 'key', id: 'keyboard', actions: steps }] }); }

  /** @param {string} name @param {object} body */
  #post(name, body) { return command('POST', `${this.session}/${name}`, body); }
}

/**
 * Each command has a connection of its own: the driver may close one that is kept while the next command is being sent.
 * @param {string} method @param {string} address @param {object} [body]
 */
async function command(method, address, body) {
  const { status, text } = await new Promise((resolve, reject) => {
    const bytes = Buffer.from(body ? JSON.stringify(body) : '');
    const signal = AbortSignal.timeout(ANSWER_MS);
    request(address, { method, agent: false, signal, headers: { 'content-type': 'application/json', 'content-length': bytes.length } }, async (answer) => {
      answer.setEncoding('utf8');
      let text = '';
      answer.on('error', reject);
      for await (const part of answer) text += part;
      resolve({ status: answer.statusCode, text });
    }).on('error', reject).end(bytes);
  });
  const { value } = JSON.parse(text);
  assert.equal(status, 200, `${method} ${address}: ${value?.error}: ${value?.message}`);
  return value;
}
