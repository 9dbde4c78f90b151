// SPDX-License-Identifier: MIT
// A page under test in WebKit, used like the pages of the other browsers.
import { startWebKit } from './browsers.mjs';
import { PageDriver } from './page_driver.mjs';
import { WebDriver } from './web_driver.mjs';

/** Its complaints stay empty: WebDriver tells of no console. */
export class WebKitPage extends PageDriver {
  /** One browser at a time. @type {WebKitPage | null} */
  static #last = null;

  /** @param {WebDriver} browser @param {() => void} stop  of its driver */
  constructor(browser, stop) {
    super(/** @type {any} */ (browser));
    this.browser = browser;
    this.stop = stop;
  }

  /**
   * Opens an address in a new profile, and closes the last page if it still is open.
   * @param {string} address @param {{newcomer?: boolean}} [options]  newcomer: comes as a stranger would, with Live and what plays
   */
  static async enter(address, { newcomer = false } = {}) {
    await this.leave();
    const page = this.#last = await this.#start();
    [page.plays, page.live] = [newcomer, newcomer];
    await page.arrive(() => page.browser.go(address));
    return page;
  }

  /** Now and then a browser does not come up, and its driver never says so: then it is started again. @param {number} [tries] @returns {Promise<WebKitPage>} */
  static async #start(tries = 3) {
    const driver = await startWebKit();
    if (!driver) throw new Error('there is no WebKitWebDriver here');
    try {
      return new WebKitPage(await WebDriver.open(driver.address), driver.stop);
    } catch (error) {
      driver.stop();
      if (tries === 1) throw error;
      console.log(`        started again: ${error instanceof Error ? error.message : error}`);
      return this.#start(tries - 1);
    }
  }

  /** Closes the last page if it still is open. */
  static async leave() { await this.#last?.close(); }

  async close() {
    WebKitPage.#last = null;
    await this.browser.close().catch(() => {});
    this.stop();
  }
}
