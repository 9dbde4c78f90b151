// SPDX-License-Identifier: MIT
// Tests the built page in Chromium and Firefox:
//   node tests/browser/run.mjs [folder, default build/site] [words of the scenarios to run, default all; --main: MAIN_SCENARIOS]
// BROWSER=chromium or BROWSER=firefox selects one browser, which then runs every scenario that it can run. Without it, what is
// said to run RARELY is left out.
// Writes pictures to build/screenshots. Prints each result and fails if a scenario fails.
import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { goldenLinks, goldenMotions } from './goldens.mjs';
import { ONCE, PageDriver, RARELY } from './page_driver.mjs';
import { ROOT, serve, startChromium, startFirefox, stopAll } from './browsers.mjs';
import { MAIN_SCENARIOS, SCENARIOS } from './scenarios/all.mjs';
import { takePictures } from './pictures.mjs';
import { nativeHash } from './native.mjs';

// Six times what the longest needs. A browser that no longer answers would otherwise hold up all that follow.
const LIMIT_S = 300;

let passed = 0;
let failed = 0;

/** @param {string} name @param {() => Promise<void>} body */
async function check(name, body) {
  const start = performance.now();
  let timer;
  try {
    await Promise.race([body(), new Promise((_, reject) => {
      timer = setTimeout(() => reject(new Error(`not done after ${LIMIT_S} s`)), LIMIT_S * 1000);
    })]);
    passed++;
    console.log(`ok      ${name} (${((performance.now() - start) / 1000).toFixed(1)} s)`);
  } catch (error) {
    failed++;
    console.log(`FAILED  ${name}\n        ${error instanceof Error ? error.message.replaceAll('\n', '\n        ') : error}`);
  } finally {
    clearTimeout(timer);
  }
}

/**
 * Every golden document and link has its pinned hash in the browser, and documents the native one.
 * @param {PageDriver} page @param {import('./goldens.mjs').Golden[]} goldens @param {boolean} natively
 * @returns {Promise<number>} their number
 */
async function checkGoldens(page, goldens, natively) {
  for (const { name, text, hash } of goldens) {
    const here = await page.page.evaluate((golden) => {
      window.gaitsmith.open(golden);
      return window.gaitsmith.hash();
    }, text);
    if (natively) assert.equal(here, await nativeHash(text) ?? here, name);
    if (hash) assert.equal(here, hash, name);
  }
  return goldens.length;
}

mkdirSync(join(ROOT, 'build/screenshots'), { recursive: true });
const main = process.argv[3] === '--main';
const wanted = main ? '' : process.argv[3] ?? '';
const whole = !main && wanted === '';
const scenarios = main ? MAIN_SCENARIOS : SCENARIOS;
const site = process.argv[2] ?? join(ROOT, 'build/site');
const address = await serve(site);
/**
 * Closes what a failed scenario has left open: a page that plays takes the processor from all that follow.
 * @param {import('./browsers.mjs').Browser} browser @param {unknown[]} kept
 */
async function closeOthers(browser, kept) {
  for (const context of browser.browserContexts()) {
    if (!kept.includes(context)) await context.close().catch(() => {});
  }
}

/** Runs all scenarios in one browser. @param {string} name @param {() => Promise<import('./browsers.mjs').Browser | null>} start */
async function drive(name, start) {
  const browser = await start();
  if (!browser) {
    await check(`${name} is installed (./dev setup browsers)`, async () => assert.fail('not found'));
    return null;
  }
  console.log(`${name}: ${await browser.version()}`);
  const visit = /** @type {import('./scenarios/all.mjs').Visit} */ ({ name, browser, site, address, found: {}, link: '', figures: {} });
  const here = [name, name === chosen[0]?.[0] ? ONCE : name];
  for (const [claim, body] of scenarios.filter(([text, , where = name, how]) => text.includes(wanted) && here.includes(where) && (asked || how !== RARELY))) {
    const before = failed;
    const contexts = browser.browserContexts();
    await check(`${name}: ${claim}`, () => body(visit));
    if (failed > before) await closeOthers(browser, [...contexts, visit.page?.page.browserContext()]);
    // The visit's own page stays open. Left playing, it takes half a processor from everybody.
    await visit.page?.play(false).catch(() => {});
  }
  await check(`${name}: golden motions and links have their pinned hashes`, async () => {
    const page = await PageDriver.open(browser, address);
    visit.figures['golden motions'] = await checkGoldens(page, await goldenMotions(), true);
    visit.figures['golden links'] = await checkGoldens(page, await goldenLinks(), false);
    await page.close();
  });
  if (name === 'Chromium' && whole && asked) await check(`${name}: pictures of every panel in every theme`, async () => {
    visit.figures.pictures = await takePictures(browser, address);
  });
  return visit;
}

// Half of the pixels a side, as in Firefox. The pictures have all of them.
const BROWSERS = /** @type {const} */ ({ Chromium: () => startChromium({ width: 1280, height: 720, deviceScaleFactor: 0.5 }), Firefox: startFirefox });
// One browser, or the words of a scenario, are asked for.
const asked = Boolean(process.env.BROWSER) || wanted !== '';
const chosen = Object.entries(BROWSERS).filter(([name]) => [name.toLowerCase(), ''].includes(process.env.BROWSER ?? ''));
assert.ok(chosen.length > 0, `BROWSER is chromium or firefox, not ${process.env.BROWSER}`);
// In parallel, because browsers wait more than they compute.
const [first, ...others] = (await Promise.all(chosen.map(([name, start]) => drive(name, start)))).filter((visit) => visit !== null);
for (const visit of whole && first ? others : []) { // needs the results of all scenarios
  await check(`${visit.name} and ${first.name} find the same motions and open each other's links`, async () => {
    assert.deepEqual(visit.found, first.found);
    const page = await PageDriver.open(visit.browser, first.link);
    assert.equal(await page.hash(), first.found.timer);
    await page.close();
  });
}
for (const { name, browser, figures } of [first, ...others]) {
  await browser.close();
  for (const [what, value] of Object.entries(figures)) console.log(`${name}: ${what}: ${value}`);
}
stopAll();
console.log(`\n${passed} passed, ${failed} failed`);
process.exitCode = failed ? 1 : 0;
