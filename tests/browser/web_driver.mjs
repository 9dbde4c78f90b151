// SPDX-License-Identifier: MIT
// A browser that speaks W3C WebDriver: the few commands that the tests of WebKit need.
import assert from 'node:assert/strict';
import { sleep } from './page_driver.mjs';

const PATIENCE_MS = 60000;

export class WebDriver {
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
   * Evaluates a function in the page. @template {unknown[]} A, R
   * @param {(...values: A) => R | Promise<R>} body  uses only its arguments and the page @param {A} values
   * @returns {Promise<R>}
   */
  async evaluate(body, ...values) {
    const { value, fault } = await this.#post('execute/async', { args: values, script: `
      const values = [...arguments], finish = values.pop();
      Promise.resolve().then(() => (${body})(...values)).then((value) => finish({ value }), (error) => finish({ fault: String(error) }));` });
    assert.equal(fault, undefined);
    return value;
  }

  /** Waits until a condition in the page holds. @param {string} what @param {() => boolean} condition */
  async until(what, condition) {
    for (const start = Date.now(); !await this.evaluate(condition); await sleep(50))
      assert.ok(Date.now() - start < PATIENCE_MS, `waited in vain for: ${what}`);
  }

  /** Clicks with the mouse, slowly as PageDriver does. @param {number} x @param {number} y */
  clickAt(x, y) {
    const pause = { type: 'pause', duration: 100 };
    return this.#post('actions', { actions: [{ type: 'pointer', id: 'mouse', parameters: { pointerType: 'mouse' },
      actions: [{ type: 'pointerMove', duration: 0, x: Math.round(x), y: Math.round(y) }, pause, { type: 'pointerDown', button: 0 }, pause, { type: 'pointerUp', button: 0 }, pause] }] });
  }

  /** The window's picture, PNG as base64. @returns {Promise<string>} */
  screenshot() { return command('GET', `${this.session}/screenshot`); }

  /** @param {string} name @param {object} body */
  #post(name, body) { return command('POST', `${this.session}/${name}`, body); }
}

/** @param {string} method @param {string} address @param {object} [body] */
async function command(method, address, body) {
  const answer = await fetch(address, { method, body: body && JSON.stringify(body) });
  const { value } = await answer.json();
  assert.ok(answer.ok, `${method} ${address}: ${value?.error}: ${value?.message}`);
  return value;
}
