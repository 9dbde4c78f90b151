// SPDX-License-Identifier: MIT
// A page under test in WebKit, used like the pages of the other browsers.
import { PageDriver } from './page_driver.mjs';
import { WebDriver } from './web_driver.mjs';

/** Its complaints stay empty: WebDriver tells of no console. */
export class WebKitPage extends PageDriver {
  /** The driver has one browser at a time. @type {WebKitPage | null} */
  static #last = null;

  /** @param {WebDriver} browser */
  constructor(browser) {
    super(/** @type {any} */ (browser));
    this.browser = browser;
  }

  /**
   * Opens an address in a new profile, and closes the last page if it still is open.
   * @param {string} driver  its address @param {string} address @param {{newcomer?: boolean}} [options]  newcomer: comes as a stranger would, with Live and what plays
   */
  static async enter(driver, address, { newcomer = false } = {}) {
    await this.leave();
    const page = this.#last = new WebKitPage(await WebDriver.open(driver));
    [page.plays, page.live] = [newcomer, newcomer];
    await page.arrive(() => page.browser.go(address));
    return page;
  }

  /** Closes the last page if it still is open. */
  static async leave() { await this.#last?.close(); }

  async close() {
    WebKitPage.#last = null;
    await this.browser.close();
  }
}
