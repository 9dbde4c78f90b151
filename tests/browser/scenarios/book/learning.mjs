// SPDX-License-Identifier: MIT
// Lessons and assignments as SCORM packages, made by the build and in the page, in frames and in pop-ups of a learning
// system.
import assert from 'node:assert/strict';
import { mkdtemp, readFile, rm } from 'node:fs/promises';
import { execFile } from 'node:child_process';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { promisify } from 'node:util';
import { ROOT } from '../../browsers.mjs';
import { ONE_BROWSER, PATIENCE_MS, PageDriver } from '../../page_driver.mjs';
import { Course, inCourse, until, untilSaid, VERSIONS } from './learning_system.mjs';
import { recordFiles, saved } from './saved_files.mjs';

/** @typedef {import('../all.mjs').Visit} Visit */
/** @typedef {import('../../browsers.mjs').Browser} Browser */
/** @typedef {import('./learning_system.mjs').Version} Version */
/** @typedef {import('./learning_system.mjs').Place} Place */

const LESSON = '1-a-rule';
const HOP = 'examples/gallery/kangaroo-hop.json';

/** The package that the build makes. @param {Visit} visit */
async function packages({ site, browser }) {
  const folder = await mkdtemp(join(tmpdir(), 'gaitsmith-scorm-'));
  try {
    await promisify(execFile)(process.execPath, [join(ROOT, 'web/package/scorm.mjs'), site, folder]);
    for (const version of VERSIONS) {
      await inCourse(await readFile(join(folder, `${LESSON}-scorm-${version}.zip`)), version, (address) => doLesson(browser, address, version));
    }
  } finally {
    await rm(folder, { recursive: true });
  }
}

/** @param {Place} played */
async function playgroundIn(played) {
  await until('the playground', played, () => window.gaitsmith?.ready !== undefined);
  await played.evaluate(() => window.gaitsmith.ready.then(() => true));
}

/** @param {Browser} browser @param {string} address @param {Version} version */
async function doLesson(browser, address, version) {
  const course = await Course.open(browser, version, address);

  // In a frame: answers and sentences are reported as they are given.
  const lesson = await course.frame(`${LESSON}.html?scorm`);
  await untilSaid('Reported to the learning system: 0 of 100', lesson);
  assert.equal(await course.status(), 'incomplete');
  await lesson.evaluate(() => {
    /** @type {HTMLElement} */ (document.querySelector('.quiz input[data-right]')).click();
    const field = /** @type {HTMLTextAreaElement} */ (document.querySelector('#sentences'));
    field.value = 'Because it lands.';
    field.dispatchEvent(new Event('input'));
  });
  await untilSaid('Reported to the learning system: 33 of 100', lesson);
  assert.equal(await course.score(), '33');
  assert.match(await course.state(), /^H1\./);
  // The goal, by the events of the playground
  const played = await course.page.waitForFrame((frame) => frame.url().includes('panels=controller'), { timeout: PATIENCE_MS });
  await playgroundIn(played);
  const json = JSON.parse(await readFile(join(ROOT, HOP), 'utf8'));
  const { rules } = json.controllers[0];
  await played.evaluate((text) => window.gaitsmith.open(text), JSON.stringify({ ...json, hash: undefined, controllers: [{ ...json.controllers[0], rules: [rules[0], rules[2]] }] }));
  await untilSaid('67 of 100, passed', lesson);
  assert.equal(await course.status(), course.passed());
  if (version === '2004') assert.equal(await course.value('cmi.success_status'), 'passed');
  const kept = await course.state();
  assert.ok(kept.length <= 4096 && kept.endsWith('.reached'), `${kept.length} characters`);
  await course.close();

  // In a pop-up on another computer: the system gives back what it has kept.
  const again = await Course.open(browser, version, address);
  await again.restore(kept, true);
  const popup = await again.popup();
  await untilSaid('67 of 100, passed', popup);
  assert.equal(await popup.evaluate(() => /** @type {HTMLTextAreaElement} */ (document.querySelector('#sentences')).value), 'Because it lands.');
  assert.ok(await popup.evaluate(() => document.querySelector('.goal.met') !== null && document.querySelector('.quiz input:checked') !== null));
  await popup.close();
  await again.untilEnded();

  // Alone: it works, and says so.
  await again.page.goto(`${address}content/launch.html`);
  await untilSaid('No learning system was found', again.page);
  await again.close();
}

/** The button is below the fold of the dialog. @param {PageDriver} page */
async function pressSave(page) {
  await page.page.evaluate(() => document.getElementById('share-scorm')?.scrollIntoView());
  await page.clickElement('#share-scorm');
}

/** A package of an assignment, made in Share. @param {Visit} visit */
async function assignmentPackage({ browser, address }) {
  const page = await PageDriver.open(browser, address, { before: recordFiles });
  await page.clickElement('#share');
  await page.until('the dialog', () => document.querySelector('#share-dialog[open]') !== null);
  await page.clickElement('#share-embed summary');
  await page.clickElement('#share-locks input[value=style]');
  await pressSave(page);
  await page.until('the reason', () => /needs a goal/.test(document.querySelector('#share-scorm-said')?.textContent ?? ''));
  await page.page.type('#share-goal', 'distance >= 4, rules <= 2');
  await page.page.type('#share-task', 'Go "4 metres" <with> 2 rules & no more.');
  // Cancelled with the first file, and with the dialog.
  await page.page.evaluate(() => {
    document.getElementById('share-scorm')?.click();
    const stop = new MutationObserver(() => {
      const cancel = document.getElementById('share-scorm-cancel');
      if (!cancel || cancel.hidden) return;
      stop.disconnect();
      cancel.click();
    });
    stop.observe(document.body, { subtree: true, attributes: true });
  });
  await page.until('the end', () => document.querySelector('#share-scorm-said')?.textContent === 'Cancelled');
  assert.deepEqual(await saved(page.page), []);
  for (const version of VERSIONS) {
    await page.page.select('#share-scorm-version', version);
    await pressSave(page);
    await page.until('the package', () => /^Saved as/.test(document.querySelector('#share-scorm-said')?.textContent ?? ''));
    const [{ name, bytes }] = await saved(page.page);
    assert.match(name, new RegExp(`^mr-star-man.*-scorm-${version}\\.zip$`));
    await inCourse(bytes, version, (course) => doAssignment(browser, course, version));
  }
  // On a phone nothing is cut off, also while a package is made.
  await page.page.setViewport({ width: 390, height: 844 });
  await page.page.evaluate(() => { for (const id of ['progress', 'cancel']) /** @type {HTMLElement} */ (document.getElementById(`share-scorm-${id}`)).hidden = false; });
  assert.equal(await page.page.$eval('#share-dialog', ({ scrollWidth, clientWidth }) => scrollWidth - clientWidth), 0, 'the dialog scrolls sideways');
  // A file that does not come.
  await page.page.setRequestInterception(true);
  page.page.on('request', (request) => void (/judge\.js/.test(request.url()) ? request.abort() : request.continue()));
  await pressSave(page);
  await page.until('the fault', () => /judge\.js could not be loaded/.test(document.querySelector('#share-scorm-said')?.textContent ?? ''));
  await page.close();
}

/** @param {Browser} browser @param {string} address @param {Version} version */
async function doAssignment(browser, address, version) {
  const course = await Course.open(browser, version, address);
  const played = await course.frame('&scorm#');
  await playgroundIn(played);
  await untilSaid('Go "4 metres" <with> 2 rules & no more.', played);
  await untilSaid('Reported to the learning system: 50 of 100.', played); // it is far enough, with ten rules
  assert.deepEqual([await course.status(), await course.score()], ['incomplete', '50']);
  // Sentences
  await played.evaluate(() => document.getElementById('task-hand-in')?.click());
  await until('the dialog', played, () => document.querySelector('#work-dialog[open]') !== null);
  await played.evaluate(() => {
    const field = /** @type {HTMLTextAreaElement} */ (document.getElementById('work-text'));
    field.value = 'Two are enough.';
    field.dispatchEvent(new Event('input'));
  });
  const hop = await readFile(join(ROOT, HOP), 'utf8'), json = JSON.parse(hop), { rules } = json.controllers[0];
  await played.evaluate((text) => window.gaitsmith.open(text), JSON.stringify({ ...json, hash: undefined, controllers: [{ ...json.controllers[0], rules: [rules[0], rules[2]] }] }));
  await untilSaid('Reported to the learning system: 100 of 100, passed.', played);
  assert.deepEqual([await course.status(), await course.score()], [course.passed(), '100']);
  if (version === '2004') assert.equal(await course.value('cmi.success_status'), 'passed');
  // What comes after does not take it away.
  await played.evaluate((text) => window.gaitsmith.open(text), hop);
  await new Promise((resolve) => { setTimeout(resolve, 1500); });
  assert.equal(await course.score(), '100');
  const kept = await course.state();
  assert.match(kept, /^H1\..*\.100$/);
  await course.close();

  // On another computer
  const again = await Course.open(browser, version, address);
  await again.restore(kept, true);
  const popup = await again.popup();
  await untilSaid('100 of 100, passed', popup);
  assert.equal(await popup.evaluate(() => /** @type {any} */ (window.gaitsmith.document()).controllers[0].rules.length), 2, 'the motion that reached the goal');
  await popup.evaluate(() => document.getElementById('task-hand-in')?.click());
  await until('the sentences', popup, () => /** @type {HTMLTextAreaElement} */ (document.getElementById('work-text'))?.value === 'Two are enough.');
  await popup.close();
  await again.untilEnded();

  // Alone, and without a goal
  await again.page.goto(`${address}content/launch.html`);
  await untilSaid('No learning system was found around this page. The assignment works, and nothing will be reported.', again.page);
  await again.page.goto(`${address}content/index.html?task=Go&scorm`);
  await untilSaid('“scorm” needs a goal', again.page);
  await again.close();
}

/** A package of a lesson, made in the book. @param {Visit} visit */
async function lessonPackage({ browser, address }) {
  const page = await (await browser.createBrowserContext()).newPage();
  await page.evaluateOnNewDocument(recordFiles);
  await page.goto(`${address}book/packages.html`);
  await page.select('#package-lesson', '4-style');
  await page.waitForSelector('#package button[type=submit]:not([disabled])');
  await page.focus('#package-version');
  await page.keyboard.press('Tab');
  await page.keyboard.press('Enter');
  await until('the package', page, () => /^Saved as 4-style-scorm-1\.2\.zip, \d\.\d MB\.$/.test(document.getElementById('package-state')?.textContent ?? ''));
  const [{ bytes }] = await saved(page);
  await inCourse(bytes, '1.2', async (course) => {
    const visit = await Course.open(browser, '1.2', course);
    await untilSaid('Reported to the learning system: 0 of 100', await visit.frame('4-style.html?scorm'));
    assert.equal(await visit.status(), 'incomplete');
    await visit.close();
  });
  await page.browserContext().close();
}

/** @type {import('../all.mjs').Scenario[]} */
export const LEARNING_SCENARIOS = [
  ['lessons report to a learning system, by SCORM 1.2 and 2004, in frames and pop-ups', packages, ONE_BROWSER],
  ['an assignment becomes a SCORM package in Share, and reports to a learning system', assignmentPackage, ONE_BROWSER],
  ['a lesson becomes a SCORM package in the book', lessonPackage, ONE_BROWSER],
];
