// SPDX-License-Identifier: MIT
// Tests the built page in WebKit, the engine of Safari, against Chromium and the pinned hashes:
//   node tests/browser/webkit.mjs [folder, default build/site]
// Puppeteer does not drive WebKit, so this is a short visit, not the scenarios of run.mjs. Prints each result. The exit
// status is 1 if one fails, 77 without WebKit's driver.
import assert from 'node:assert/strict';
import { mkdir, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { ROOT, serve, startChromium, startWebKit, stopAll } from './browsers.mjs';
import { documentsIn, goldenLinks, goldenMotions } from './goldens.mjs';
import { brightness, PageDriver, sleep } from './page_driver.mjs';
import { WebDriver } from './web_driver.mjs';

const LEFT_OUT = 77;

/** Short searches of different kinds: every kind of senses, and rules and networks. */
const SEARCHES = [
  { algorithm: 'sphc', sense: 'physical', seed: 9, evaluations: 4000, workers: 2 },
  { algorithm: 'pose-cycle', sense: 'physical', seed: 3, evaluations: 2000, workers: 2 },
  { algorithm: 'cma-es', sense: 'timer', seed: 5, evaluations: 2000, workers: 1 },
  { algorithm: 'two-stage', sense: 'network', seed: 2, evaluations: 2000, workers: 2 },
];

const driver = await startWebKit();
if (!driver) {
  console.log('WebKit is left out: there is no WebKitWebDriver here (package webkit2gtk-driver)');
  process.exit(LEFT_OUT);
}
const address = await serve(process.argv[2] ?? join(ROOT, 'build/site'));
const chromium = await startChromium();
assert.ok(chromium, 'Chromium is installed (./dev setup browsers)');
const there = await PageDriver.open(chromium, address);
let webkit = await WebDriver.open(driver);
console.log(`WebKit: ${webkit.version}`);

let passed = 0;
let failed = 0;
/** @param {string} claim @param {() => Promise<void>} body */
async function check(claim, body) {
  const start = performance.now();
  try {
    await body();
    passed++;
    console.log(`ok      WebKit: ${claim} (${((performance.now() - start) / 1000).toFixed(1)} s)`);
  } catch (error) {
    failed++;
    console.log(`FAILED  WebKit: ${claim}\n        ${error instanceof Error ? error.message.replaceAll('\n', '\n        ') : error}`);
  }
}

/** Opens an address, waits for the first frame, leaves the tour and pauses. @param {WebDriver} browser @param {string} where */
async function visit(browser, where) {
  await browser.go(where);
  await browser.until('the page', () => 'gaitsmith' in window);
  await browser.evaluate(() => window.gaitsmith.ready.then(() => true));
  await browser.until('the mirror', () => document.querySelector('#mirror [id^=on-canvas]') !== null);
  await browser.evaluate(() => {
    const skip = document.querySelector('#tour:not([hidden]) #tour-skip');
    if (skip instanceof HTMLElement) skip.click();
    if (window.gaitsmith.widgets().some(({ id, label }) => id === 'transport/play' && label === 'Pause')) window.gaitsmith.run('motion/play');
  });
}

/** Clicks a widget of the canvas with the mouse, when it no longer moves. @param {string} id */
async function click(id) {
  const rectOf = () => webkit.evaluate((wanted) => window.gaitsmith.widgets().find((widget) => widget.id === wanted)?.rect, id);
  let rect, last;
  for (const since = Date.now(); !rect || JSON.stringify(rect) !== JSON.stringify(last); await sleep(100)) {
    assert.ok(Date.now() - since < 10000, `no widget ${id} at rest on the canvas`);
    [last, rect] = [rect, await rectOf()];
  }
  await webkit.clickAt(rect.x + rect.width / 2, rect.y + rect.height / 2);
}

/** The document from which all searches start. */
const [start] = await documentsIn('examples');

/** What a search finds. @param {string} text  a document @param {import('../../web/app/app.js').SynthesizeOptions} options */
async function search(text, options) {
  window.gaitsmith.open(text);
  const began = performance.now();
  const { report, hash, link } = await window.gaitsmith.synthesize(options);
  return { found: { state: report.state, best: report.bestFitness, hash, link }, ms: Math.round(performance.now() - began) };
}

await check('opens and draws', async () => {
  await visit(webkit, address);
  const stage = await webkit.evaluate(() => window.gaitsmith.widgets().find(({ id }) => id === 'stage')?.rect);
  const png = await webkit.screenshot();
  await mkdir(join(ROOT, 'build/screenshots'), { recursive: true });
  await writeFile(join(ROOT, 'build/screenshots/webkit.png'), png, 'base64');
  const { spread } = await webkit.evaluate(brightness, png, stage);
  assert.ok(spread > 10, `the stage is blank: spread ${spread}`);
  assert.equal(await webkit.evaluate(() => document.querySelector('#banner')?.hasAttribute('hidden')), true);
});
await check('golden motions and links, examples, gallery and lessons have their pinned hashes', async () => {
  const goldens = (await Promise.all([goldenMotions(), goldenLinks(), ...['examples', 'examples/gallery', 'examples/lessons'].map(documentsIn)])).flat();
  const pinned = goldens.filter(({ hash }) => hash);
  assert.ok(pinned.length > 60, `only ${pinned.length} pinned hashes`);
  const hashes = await webkit.evaluate((texts) => texts.map((text) => {
    window.gaitsmith.open(text);
    return window.gaitsmith.hash();
  }), pinned.map(({ text }) => text));
  assert.deepEqual(Object.fromEntries(pinned.map(({ name }, i) => [name, hashes[i]])), Object.fromEntries(pinned.map(({ name, hash }) => [name, hash])));
  console.log(`        ${pinned.length} motions`);
});
for (const options of SEARCHES) {
  await check(`${options.algorithm} with ${options.sense} ends with the link of Chromium`, async () => {
    const here = await webkit.evaluate(search, start.text, options);
    const chromiums = await there.page.evaluate(search, start.text, options);
    assert.equal(here.found.state, 'done');
    assert.deepEqual(here.found, chromiums.found);
    console.log(`        ${here.ms} ms, Chromium ${chromiums.ms} ms`);
  });
}
await check('a click on Synthesize starts a search in workers, which finds a motion', async () => {
  const before = await webkit.evaluate((text) => {
    window.gaitsmith.open(text);
    window.gaitsmith.open({ ...window.gaitsmith.document(), hash: undefined, search: { seed: 5, evaluations: 8000 } });
    Object.assign(window, { testRates: [] });
    window.gaitsmith.on('progress', () => /** @type {any} */ (window).testRates.push(document.querySelector('#rate')?.textContent));
    return window.gaitsmith.hash();
  }, start.text);
  await click('panels/3');
  await click('search/start');
  await webkit.until('the end', () => document.querySelector('#status')?.textContent?.startsWith('Search done') ?? false);
  const { rates, hash } = await webkit.evaluate(() => ({ rates: /** @type {any} */ (window).testRates, hash: window.gaitsmith.hash() }));
  assert.match(rates.join(), /on \d+ worker/);
  assert.notEqual(hash, before);
});
await check('a link of Chromium shows the same motion, bit for bit, in a fresh profile', async () => {
  const [link, hash] = [await there.link(), await there.hash()];
  await webkit.close(); // the driver has one browser at a time
  webkit = await WebDriver.open(driver);
  await visit(webkit, link);
  assert.equal(await webkit.evaluate(() => window.gaitsmith.hash()), hash);
});
await webkit.close();
await chromium.close();
stopAll();
console.log(`\n${passed} passed, ${failed} failed`);
process.exitCode = failed ? 1 : 0;
