// SPDX-License-Identifier: MIT
// A page under test: opens it, records its errors, and uses it like a person.
import assert from 'node:assert/strict';

/** @typedef {import('./browsers.mjs').Browser} Browser */
/** @typedef {import('./browsers.mjs').Page} Page */
/** @typedef {import('../../web/app/app.js').Widget} Widget */

/** No wait is a claim about speed: a busy machine may be many times slower. */
export const PATIENCE_MS = 60000;
/** Runs the scenarios of what the canvas alone decides, by the same module in every browser. */
export const ONE_BROWSER = 'Chromium';
/** Where a scenario runs that one browser of a whole run is enough for. */
export const ONCE = 'once';
/** How often a scenario runs that is rare and long, and tested in parts elsewhere: with ./dev browsers only (85). */
export const RARELY = 'rarely';
/** @param {number} ms */
export const sleep = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

export class PageDriver {
  /** Console errors, failed requests, requests to other hosts. @type {string[]} */
  complaints = [];
  /** Rises with each page that is left. */
  visit = 0;
  /** Whether the motion plays after the page has loaded. */
  plays = false;
  /** Whether Live is as for everybody. */
  live = false;

  /** @param {Page} page */
  constructor(page) {
    this.page = page;
  }

  /**
   * Opens an address in a new profile (an isolated context with empty cookies, storage and cache), or in another tab of
   * an open page's profile.
   * @param {Browser} browser @param {string} address
   * @param {{beside?: PageDriver, before?: () => void, newcomer?: boolean, plays?: boolean, live?: boolean}} [options]  before: runs in
   * the page before its scripts; newcomer: comes to the address
   * as a stranger would; others begin with an example or open a link in the workbench, because most scenarios need a motion and panels; live: Live is as for everybody, else it is off, because most scenarios
   * are about something else; plays: the motion plays, else it is paused at once, because
   * drawing it with software graphics needs most of a processor
   */
  static async open(browser, address, { beside, before, newcomer = false, plays = false, live = newcomer } = {}) {
    const context = beside ? beside.page.browserContext() : await browser.createBrowserContext();
    const page = await context.newPage();
    const driver = new PageDriver(page);
    driver.plays = plays;
    driver.live = live;
    const { complaints } = driver;
    page.on('console', (message) => {
      if (['error', 'warn', 'assert'].includes(message.type()) && !/WebGL|GPU|GL Driver|software/i.test(message.text())) {
        complaints.push(`console: ${message.text()}`);
      }
    });
    page.on('pageerror', (error) => complaints.push(`uncaught: ${/** @type {Error} */ (error).stack ?? error}`));
    // Leaving a page, or ending a worker while its module comes, cancels requests. Firefox does not always name that as the reason.
    const visits = new WeakMap();
    page.on('request', (request) => visits.set(request, driver.visit));
    page.on('requestfailed', (request) => {
      const why = request.failure()?.errorText ?? '';
      if (!/ABORTED|NS_BASE_STREAM_CLOSED/i.test(why) && visits.get(request) === driver.visit) complaints.push(`request failed: ${request.url()} ${why}`);
    });
    page.on('response', (response) => {
      if (response.status() >= 400) complaints.push(`${response.status()}: ${response.url()}`);
    });
    const host = new URL(address).host;
    page.on('request', (request) => {
      const url = new URL(request.url());
      if (/^(https?|wss?):$/.test(url.protocol) && url.host !== host) complaints.push(`request to another host: ${url}`);
    });
    await page.evaluateOnNewDocument(recordWorkers);
    if (before) await page.evaluateOnNewDocument(before);
    const bare = !beside && !newcomer && !/[?#]/.test(address);
    // A link opens the viewer for a stranger, and the workbench with ?edit.
    const there = newcomer ? address : address.replace(/^([^?#]*)#/, '$1?edit#');
    await driver.arrive(() => page.goto(bare ? `${address}?open=star-man-shuffle` : there));
    return driver;
  }

  async reload() { await this.arrive(() => this.page.reload()); }

  /** Makes the page a phone's, which loads it again: a browser learns of touch only at a load. */
  async becomePhone() {
    const size = { width: 390, height: 844 };
    await this.arrive(() => this.page.setViewport({ ...size, deviceScaleFactor: 2, hasTouch: true, isMobile: true })
      .catch(async () => { // A browser without touch emulation gets a narrow window.
        await this.page.setViewport(size);
        await this.page.reload();
      }));
  }

  /**
   * Goes to a page of the playground and waits until it is ready. After navigation, a browser may still evaluate
   * scripts in the old page, or in none. So the old page is marked, and failed evaluations are repeated.
   * @param {() => Promise<unknown>} leave
   */
  async arrive(leave) {
    await this.page.evaluate(() => { document.documentElement.dataset.left = 'true'; });
    this.visit++;
    await leave();
    for (const start = Date.now(); ; await sleep(50)) {
      const there = await this.page.evaluate(() => !document.documentElement.dataset.left && 'gaitsmith' in window)
        .catch(() => false);
      if (there) break;
      assert.ok(Date.now() - start < PATIENCE_MS, 'the page has not come');
    }
    await this.call('ready', () => window.gaitsmith.ready.then(() => true));
    // A person is slower than the mirror.
    await this.until('the mirror', () => document.querySelector('#mirror [id^=on-canvas]') !== null);
    if (!this.live) await this.page.evaluate(() => window.gaitsmith.arrange({ live: 'off' }));
    if (!this.plays) await this.play(false);
  }

  /** Plays or pauses the motion, if the canvas shows the button. @param {boolean} playing */
  async play(playing) {
    // A search that just ended starts what it found: the label is the frame's that follows.
    await this.frames();
    const label = (await this.widgets()).find(({ id }) => id === 'transport/play')?.label;
    if (label && (label === 'Play') === playing) await this.page.evaluate(() => window.gaitsmith.run('motion/play'));
  }

  /** Steps through the motion. @param {number} frames */
  forward(frames) {
    return this.page.evaluate((steps) => { for (let step = 0; step < steps; step++) window.gaitsmith.run('motion/forward'); }, frames);
  }

  async close() { await this.page.browserContext().close(); }

  /**
   * Evaluates in the page, with a time limit.
   * @template T
   * @param {string} what @param {(() => T | Promise<T>) | string} body
   */
  async call(what, body) {
    let timer;
    const late = new Promise((_, reject) => {
      timer = setTimeout(() => reject(new Error(`${what}: no answer in ${PATIENCE_MS / 1000} s`)), PATIENCE_MS);
    });
    try {
      return /** @type {T} */ (await Promise.race([this.page.evaluate(body), late]));
    } finally {
      clearTimeout(timer);
    }
  }

  /** Waits until a condition in the page holds. @param {string} what @param {(() => boolean) | string} condition @param {number} [limit] */
  async until(what, condition, limit = PATIENCE_MS) {
    for (const start = Date.now(); Date.now() - start < limit; await sleep(50)) {
      if (await this.page.evaluate(condition)) return;
    }
    assert.fail(`waited in vain for: ${what}`);
  }

  hash() { return this.page.evaluate(() => window.gaitsmith.hash()); }
  link() { return this.page.evaluate(() => window.gaitsmith.link()); }
  status() { return this.page.evaluate(() => document.querySelector('#status')?.textContent ?? ''); }

  /** @returns {Promise<Widget[]>} */
  widgets() { return this.page.evaluate(() => window.gaitsmith.widgets()); }

  /**
   * Waits for some frames of the page. A fixed pause would be too short on a slow machine.
   */
  frames(count = 3) {
    return this.call('frames', `new Promise((resolve) => {
      let left = ${count};
      const step = () => (left-- > 0 ? requestAnimationFrame(step) : resolve(true));
      step();
    })`);
  }

  /** Where a widget of the canvas is, when it no longer moves. @param {string} id */
  async placeOf(id) {
    let last = '';
    for (const start = Date.now(); ; await this.frames()) {
      const widget = (await this.widgets()).find((candidate) => candidate.id === id);
      const place = widget ? JSON.stringify(widget.rect) : '';
      if (widget && place === last) return widget.rect;
      last = place;
      assert.ok(Date.now() - start < PATIENCE_MS, `no widget ${id} at rest on the canvas`);
    }
  }

  /** Clicks a widget of the canvas with the mouse, when it no longer moves. @param {string} id */
  async click(id) {
    const { x, y, width, height } = await this.placeOf(id);
    return this.clickAt(x + width / 2, y + height / 2);
  }

  /** Clicks slowly: the canvas hovers in one frame, presses in the next and releases in a third. @param {number} x @param {number} y */
  async clickAt(x, y) {
    await this.page.mouse.move(x, y);
    await this.frames();
    await this.page.mouse.down();
    await this.frames();
    await this.page.mouse.up();
    await this.frames();
    await sleep(50);
  }

  /** Presses keys together, the last one `times` times. @param {string} keys  such as Control+Shift+z */
  async press(keys, times = 1) {
    const all = /** @type {import('../../web/node_modules/puppeteer-core/lib/types.d.ts').KeyInput[]} */ (keys.split('+'));
    const last = all.pop();
    for (const key of all) await this.page.keyboard.down(key);
    for (let i = 0; last && i < times; i++) {
      await this.page.keyboard.press(last, { delay: 30 });
      await this.frames();
    }
    for (const key of all.reverse()) await this.page.keyboard.up(key);
  }

  /** Text of an element of the page. @param {string} selector @returns {Promise<string>} */
  text(selector) {
    return this.page.evaluate((where) => document.querySelector(where)?.textContent ?? '', selector);
  }

  /** Clicks an element of the page, when it is there. @param {string} selector */
  async clickElement(selector) {
    await this.until(`a visible ${selector}`, `document.querySelector(${JSON.stringify(selector)})?.checkVisibility() ?? false`);
    const box = await (await this.page.$(selector))?.boundingBox();
    assert.ok(box, `no visible ${selector}`);
    await this.clickAt(box.x + box.width / 2, box.y + box.height / 2);
  }

  /** Opens the list of commands, whose parts are loaded the first time. */
  async openPalette() {
    await this.press('Control+k');
    await this.until('the palette', () => document.querySelector('#palette')?.hasAttribute('open') ?? false);
  }

  /**
   * Measures the picture of the stage: the spread of its pixels' brightness, and a checksum.
   * @returns {Promise<{spread: number, sum: number}>}
   */
  async stage() {
    const stage = (await this.widgets()).find(({ id }) => id === 'stage');
    assert.ok(stage, 'no stage on the canvas');
    const png = await this.page.screenshot({ encoding: 'base64', clip: stage.rect });
    return this.page.evaluate(brightness, png);
  }

  /** Terminates one of the page's workers. @param {number} which  in order of creation, coordinator first */
  terminateWorker(which) {
    return this.page.evaluate((index) => /** @type {any} */ (window).testWorkers.at(index).terminate(), which);
  }
}

/**
 * Runs in a page: the spread of a picture's brightness, and a checksum of it.
 * @param {string} base64  PNG @param {{x: number, y: number, width: number, height: number}} [part]  else all of it
 */
export async function brightness(base64, part) {
  const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  const image = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
  const { x, y, width, height } = part ?? { x: 0, y: 0, width: image.width, height: image.height };
  const context = new OffscreenCanvas(image.width, image.height).getContext('2d');
  context?.drawImage(image, 0, 0);
  const { data = [] } = context?.getImageData(x, y, width, height) ?? {};
  let sum = 0, squares = 0, weighted = 0;
  const count = data.length / 4;
  for (let i = 0; i < count; i++) {
    const v = data[4 * i] + data[4 * i + 1] + data[4 * i + 2];
    sum += v;
    squares += v * v;
    weighted = (weighted * 31 + v) % 1000000007;
  }
  return { spread: Math.sqrt(squares / count - (sum / count) ** 2), sum: weighted };
}

/** Runs in the page before its scripts: records every Worker, to terminate one later. */
function recordWorkers() {
  const workers = /** @type {Worker[]} */ ([]);
  Object.assign(window, {
    testWorkers: workers,
    Worker: class extends Worker {
      /** @param {string | URL} url @param {WorkerOptions} [options] */
      constructor(url, options) {
        super(url, options);
        workers.push(this);
      }
    },
  });
}
