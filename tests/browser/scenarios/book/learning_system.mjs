// SPDX-License-Identifier: MIT
// The learning system that scorm-again stands for: a course's page around an unpacked SCORM package.
import assert from 'node:assert/strict';
import { copyFile, mkdir, mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { createRequire } from 'node:module';
import { ROOT } from '../../browsers.mjs';
import { PATIENCE_MS, sleep } from '../../page_driver.mjs';
import { PlainServer } from '../../plain_server.mjs';

/** @typedef {import('../../browsers.mjs').Page} Page */
/** @typedef {import('../../../../web/share/scorm_package.js').Version} Version */
/** @typedef {Page | import('../../../../web/node_modules/puppeteer-core/lib/types.d.ts').Frame} Place */

const { unzipSync } = createRequire(join(ROOT, 'web/package.json'))('fflate');
const SYSTEMS = { 1.2: { api: 'API', made: 'Scorm12API', script: 'scorm12.min.js' }, 2004: { api: 'API_1484_11', made: 'Scorm2004API', script: 'scorm2004.min.js' } };
const NAMES = { 1.2: { status: 'cmi.core.lesson_status', score: 'cmi.core.score.raw', passed: 'passed' }, 2004: { status: 'cmi.completion_status', score: 'cmi.score.raw', passed: 'completed' } };
export const VERSIONS = /** @type {const} */ (['1.2', '2004']);

/**
 * Waits in a page or a frame. Puppeteer's own waiting may be lost for ever in a frame that is navigated just then.
 * @param {string} what  is waited for @param {Place} where @param {(value: any) => boolean} condition @param {unknown} [value]
 */
export async function until(what, where, condition, value) {
  for (const start = Date.now(); !await where.evaluate(condition, value).catch(() => false); await sleep(50)) {
    assert.ok(Date.now() - start < PATIENCE_MS, `waited in vain for: ${what}`);
  }
}

/** @param {string} words @param {Place} where */
export const untilSaid = (words, where) => until(words, where, (text) => document.body.textContent?.includes(text) ?? false, words);

/** @param {Version} version */
const courseOf = (version) => `<!doctype html><meta charset="utf-8"><title>Course</title><script src="${SYSTEMS[version].script}"></script>
<script>window.${SYSTEMS[version].api} = new ${SYSTEMS[version].made}({ autocommit: false, logLevel: 5 });</script>`;

/** Unpacks a package into a course, and serves it. @param {Uint8Array} zip @param {Version} version @param {(address: string) => Promise<void>} visit */
export async function inCourse(zip, version, visit) {
  const course = await mkdtemp(join(tmpdir(), 'gaitsmith-course-'));
  const server = new PlainServer(course, '/course/');
  try {
    const files = unzipSync(zip);
    assert.ok(files['imsmanifest.xml'] && files['launch.html'] && !files['service_worker.js']);
    const named = [...new TextDecoder().decode(files['imsmanifest.xml']).matchAll(/<file href="([^"]+)"/g)].map(([, name]) => name.replaceAll('&amp;', '&'));
    assert.deepEqual([...named, 'imsmanifest.xml'].sort(), Object.keys(files).sort(), 'the manifest lists every file');
    for (const [name, bytes] of Object.entries(files)) {
      await mkdir(dirname(join(course, 'content', name)), { recursive: true });
      await writeFile(join(course, 'content', name), /** @type {Uint8Array} */ (bytes));
    }
    await copyFile(join(ROOT, 'web/node_modules/scorm-again/dist', SYSTEMS[version].script), join(course, SYSTEMS[version].script));
    await writeFile(join(course, 'index.html'), courseOf(version));
    await server.start();
    await visit(server.address());
  } finally {
    server.close();
    await rm(course, { recursive: true });
  }
}

/** A learner's visit to a course, in a browser of its own. */
export class Course {
  /** @param {Page} page @param {Version} version @param {string} address */
  constructor(page, version, address) {
    this.page = page;
    this.version = version;
    this.address = address;
  }

  /** @param {import('../../browsers.mjs').Browser} browser @param {Version} version @param {string} address */
  static async open(browser, version, address) {
    const page = await (await browser.createBrowserContext()).newPage();
    await page.goto(`${address}index.html`);
    return new Course(page, version, address);
  }

  /** What the system holds. @param {string} element @returns {Promise<string>} */
  value(element) {
    return this.page.evaluate((name) => {
      const { API: old, API_1484_11: newer } = /** @type {any} */ (window);
      return String(old ? old.LMSGetValue(name) : newer.GetValue(name));
    }, element);
  }

  status() { return this.value(NAMES[this.version].status); }
  score() { return this.value(NAMES[this.version].score); }
  state() { return this.value('cmi.suspend_data'); }
  passed() { return NAMES[this.version].passed; }

  /** Gives the system what it kept of an earlier visit. @param {string} kept @param {boolean} passed */
  async restore(kept, passed) {
    await this.page.evaluate((data, old, done) => {
      const { API, API_1484_11: newer } = /** @type {any} */ (window);
      (old ? API : newer).loadFromJSON(old ? { suspend_data: data, core: { lesson_status: done ? 'passed' : 'incomplete' } } : { suspend_data: data, completion_status: done ? 'completed' : 'incomplete' }, 'cmi');
    }, kept, this.version === '1.2', passed);
  }

  /** Shows the package in a frame. @param {string} part  of the address that it leads to */
  async frame(part) {
    await this.page.evaluate(() => { document.body.append(Object.assign(document.createElement('iframe'), { src: 'content/launch.html', width: 900, height: 600 })); });
    return this.page.waitForFrame((frame) => frame.url().includes(part), { timeout: PATIENCE_MS });
  }

  /** @returns {Promise<Page>} */
  async popup() {
    const opened = new Promise((resolve) => { this.page.once('popup', resolve); });
    await this.page.evaluate(() => { window.open('content/launch.html'); });
    return /** @type {Page} */ (await opened);
  }

  untilEnded() {
    return until('the end of the visit', this.page, (old) => {
      const { API, API_1484_11: newer } = /** @type {any} */ (window);
      return old ? API.isTerminated() : newer.isTerminated();
    }, this.version === '1.2');
  }

  close() { return this.page.browserContext().close(); }
}
