// SPDX-License-Identifier: MIT
// Lessons as SCORM packages, in the learning system that scorm-again stands for: in a frame and in a pop-up.
import assert from 'node:assert/strict';
import { copyFile, mkdir, mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { execFile } from 'node:child_process';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { promisify } from 'node:util';
import { createRequire } from 'node:module';
import { ROOT } from '../../browsers.mjs';
import { ONE_BROWSER, PATIENCE_MS, sleep } from '../../page_driver.mjs';
import { PlainServer } from '../../plain_server.mjs';

/** @typedef {import('../all.mjs').Visit} Visit */
/** @typedef {import('../../browsers.mjs').Page} Page */

const { unzipSync } = createRequire(join(ROOT, 'web/package.json'))('fflate');
const LESSON = '1-a-rule';
const SYSTEMS = { 1.2: { api: 'API', made: 'Scorm12API', script: 'scorm12.min.js' }, 2004: { api: 'API_1484_11', made: 'Scorm2004API', script: 'scorm2004.min.js' } };

/**
 * Waits in a page or a frame. Puppeteer's own waiting may be lost for ever in a frame that is navigated just then.
 * @param {string} what  is waited for @param {Page | import('../../../../web/node_modules/puppeteer-core/lib/types.d.ts').Frame} where
 * @param {(value: any) => boolean} condition @param {unknown} [value]
 */
async function until(what, where, condition, value) {
  for (const start = Date.now(); !await where.evaluate(condition, value).catch(() => false); await sleep(50)) {
    assert.ok(Date.now() - start < PATIENCE_MS, `waited in vain for: ${what}`);
  }
}

/** @param {string} words @param {Parameters<typeof until>[1]} where */
const untilSaid = (words, where) => until(words, where, (text) => document.body.textContent?.includes(text) ?? false, words);

/** A learning system's page, which shows the package as it is asked to. @param {'1.2' | '2004'} version */
const courseOf = (version) => `<!doctype html><meta charset="utf-8"><title>Course</title><script src="${SYSTEMS[version].script}"></script>
<script>window.${SYSTEMS[version].api} = new ${SYSTEMS[version].made}({ autocommit: false, logLevel: 5 });</script>`;

/** @param {Visit} visit */
async function packages({ site, browser }) {
  const folder = await mkdtemp(join(tmpdir(), 'gaitsmith-scorm-'));
  try {
    await promisify(execFile)(process.execPath, [join(ROOT, 'web/package/scorm.mjs'), site, join(folder, 'zip')]);
    for (const version of /** @type {const} */ (['1.2', '2004'])) {
      const files = unzipSync(await readFile(join(folder, `zip/${LESSON}-scorm-${version}.zip`)));
      assert.ok(files['imsmanifest.xml'] && files['launch.html'] && !files['service_worker.js']);
      const manifest = new TextDecoder().decode(files['imsmanifest.xml']);
      const named = [...manifest.matchAll(/<file href="([^"]+)"/g)].map(([, name]) => name.replaceAll('&amp;', '&'));
      assert.deepEqual([...named, 'imsmanifest.xml'].sort(), Object.keys(files).sort(), 'the manifest lists every file');
      const course = join(folder, `course-${version}`);
      for (const [name, bytes] of Object.entries(files)) {
        await mkdir(dirname(join(course, 'content', name)), { recursive: true });
        await writeFile(join(course, 'content', name), /** @type {Uint8Array} */ (bytes));
      }
      await copyFile(join(ROOT, 'web/node_modules/scorm-again/dist', SYSTEMS[version].script), join(course, SYSTEMS[version].script));
      await writeFile(join(course, 'index.html'), courseOf(version));
      const server = new PlainServer(course, '/course/');
      await server.start();
      try {
        await visitCourse(browser, server.address(), version);
      } finally {
        server.close();
      }
    }
  } finally {
    await rm(folder, { recursive: true });
  }
}

/** @param {import('../../browsers.mjs').Browser} browser @param {string} address @param {'1.2' | '2004'} version */
async function visitCourse(browser, address, version) {
  const context = await browser.createBrowserContext();
  const course = await context.newPage();
  await course.goto(`${address}index.html`);
  const value = (/** @type {string} */ element) => course.evaluate((name) => {
    const { API: old, API_1484_11: newer } = /** @type {any} */ (window);
    return String(old ? old.LMSGetValue(name) : newer.GetValue(name));
  }, element);
  const status = version === '1.2' ? 'cmi.core.lesson_status' : 'cmi.completion_status';
  const raw = version === '1.2' ? 'cmi.core.score.raw' : 'cmi.score.raw';

  // In a frame: answers and sentences are reported as they are given.
  await course.evaluate(() => { document.body.append(Object.assign(document.createElement('iframe'), { src: 'content/launch.html', width: 900, height: 600 })); });
  const lesson = await course.waitForFrame((frame) => frame.url().includes(`${LESSON}.html?scorm`), { timeout: PATIENCE_MS });
  await untilSaid('Reported to the learning system: 0 of 100', lesson);
  assert.equal(await value(status), 'incomplete');
  await lesson.evaluate(() => {
    /** @type {HTMLElement} */ (document.querySelector('.quiz input[data-right]')).click();
    const field = /** @type {HTMLTextAreaElement} */ (document.querySelector('#sentences'));
    field.value = 'Because it lands.';
    field.dispatchEvent(new Event('input'));
  });
  await untilSaid('Reported to the learning system: 33 of 100', lesson);
  assert.equal(await value(raw), '33');
  const state = await value('cmi.suspend_data');
  assert.match(state, /^H1\./);
  // The goal, by the events of the playground
  const played = await course.waitForFrame((frame) => frame.url().includes('panels=controller'), { timeout: PATIENCE_MS });
  await until('the playground', played, () => window.gaitsmith?.ready !== undefined);
  await played.evaluate(() => window.gaitsmith.ready.then(() => true));
  const json = JSON.parse(await readFile(join(ROOT, 'examples/gallery/kangaroo-hop.json'), 'utf8'));
  const { rules } = json.controllers[0];
  await played.evaluate((text) => window.gaitsmith.open(text), JSON.stringify({ ...json, hash: undefined, controllers: [{ ...json.controllers[0], rules: [rules[0], rules[2]] }] }));
  await untilSaid('67 of 100, passed', lesson);
  assert.equal(await value(status), version === '1.2' ? 'passed' : 'completed');
  if (version === '2004') assert.equal(await value('cmi.success_status'), 'passed');
  const kept = await value('cmi.suspend_data');
  assert.ok(kept.length <= 4096 && kept.endsWith('.reached'), `${kept.length} characters`);
  await context.close();

  // In a pop-up on another computer: the system gives back what it has kept.
  const other = await browser.createBrowserContext();
  const again = await other.newPage();
  await again.goto(`${address}index.html`);
  await again.evaluate((data, old) => {
    const { API, API_1484_11: newer } = /** @type {any} */ (window);
    (old ? API : newer).loadFromJSON(old ? { suspend_data: data, core: { lesson_status: 'passed' } } : { suspend_data: data, completion_status: 'completed' }, 'cmi');
  }, kept, version === '1.2');
  const opened = new Promise((resolve) => { again.once('popup', resolve); });
  await again.evaluate(() => { window.open('content/launch.html'); });
  const popup = /** @type {Page} */ (await opened);
  await untilSaid('67 of 100, passed', popup);
  assert.equal(await popup.evaluate(() => /** @type {HTMLTextAreaElement} */ (document.querySelector('#sentences')).value), 'Because it lands.');
  assert.ok(await popup.evaluate(() => document.querySelector('.goal.met') !== null && document.querySelector('.quiz input:checked') !== null));
  await popup.close();
  await until('the end of the visit', again, (old) => {
    const { API, API_1484_11: newer } = /** @type {any} */ (window);
    return old ? API.isTerminated() : newer.isTerminated();
  }, version === '1.2');

  // Alone: it works, and says so.
  await again.goto(`${address}content/launch.html`);
  await untilSaid('No learning system was found', again);
  await other.close();
}

/** @type {import('../all.mjs').Scenario[]} */
export const LEARNING_SCENARIOS = [
  ['lessons report to a learning system, by SCORM 1.2 and 2004, in frames and pop-ups', packages, ONE_BROWSER],
];
