// SPDX-License-Identifier: MIT
// Tests the built page in WebKit, the engine of Safari, against Chromium and the pinned hashes:
//   node tests/browser/webkit.mjs [folder, default build/site]
// Puppeteer does not drive WebKit, so this is a short visit with a newcomer's stories by mouse and by keys, not all
// scenarios of run.mjs. Prints each result. The exit status is 1 if one fails, 77 without WebKit's driver.
import assert from 'node:assert/strict';
import { mkdir, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { hasWebKit, ROOT, serve, startChromium, stopAll } from './browsers.mjs';
import { documentsIn, goldenLinks, goldenMotions } from './goldens.mjs';
import { brightness, PageDriver } from './page_driver.mjs';
import { NEWCOMER_STORIES } from './scenarios/newcomer.mjs';
import { WebKitPage } from './webkit_page.mjs';

const LEFT_OUT = 77;

/** Short searches of different kinds: every kind of senses, and rules and networks. */
const SEARCHES = [
  { algorithm: 'sphc', sense: 'physical', seed: 9, evaluations: 4000, workers: 2 },
  { algorithm: 'pose-cycle', sense: 'physical', seed: 3, evaluations: 2000, workers: 2 },
  { algorithm: 'cma-es', sense: 'timer', seed: 5, evaluations: 2000, workers: 1 },
  { algorithm: 'two-stage', sense: 'network', seed: 2, evaluations: 2000, workers: 2 },
];

if (!hasWebKit()) {
  console.log('WebKit is left out: there is no WebKitWebDriver here (package webkit2gtk-driver)');
  process.exit(LEFT_OUT);
}
const address = await serve(process.argv[2] ?? join(ROOT, 'build/site'));
const chromium = await startChromium();
assert.ok(chromium, 'Chromium is installed (./dev setup browsers)');
const there = await PageDriver.open(chromium, address);
let webkit = await WebKitPage.enter(`${address}?open=star-man-shuffle`);
console.log(`WebKit: ${webkit.browser.version}`);

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
  const stage = (await webkit.widgets()).find(({ id }) => id === 'stage')?.rect;
  const png = await webkit.browser.screenshot();
  await mkdir(join(ROOT, 'build/screenshots'), { recursive: true });
  await writeFile(join(ROOT, 'build/screenshots/webkit.png'), png, 'base64');
  const { spread } = await webkit.browser.evaluate(brightness, png, stage);
  assert.ok(spread > 10, `the stage is blank: spread ${spread}`);
  assert.equal(await webkit.browser.evaluate(() => document.querySelector('#banner')?.hasAttribute('hidden')), true);
});
await check('golden motions and links, examples, gallery and lessons have their pinned hashes', async () => {
  const goldens = (await Promise.all([goldenMotions(), goldenLinks(), ...['examples', 'examples/gallery', 'examples/lessons'].map(documentsIn)])).flat();
  const pinned = goldens.filter(({ hash }) => hash);
  assert.ok(pinned.length > 60, `only ${pinned.length} pinned hashes`);
  const hashes = await webkit.browser.evaluate((texts) => texts.map((text) => {
    window.gaitsmith.open(text);
    return window.gaitsmith.hash();
  }), pinned.map(({ text }) => text));
  assert.deepEqual(Object.fromEntries(pinned.map(({ name }, i) => [name, hashes[i]])), Object.fromEntries(pinned.map(({ name, hash }) => [name, hash])));
  console.log(`        ${pinned.length} motions`);
});
for (const options of SEARCHES) {
  await check(`${options.algorithm} with ${options.sense} ends with the link of Chromium`, async () => {
    const here = await webkit.browser.evaluate(search, start.text, options);
    const chromiums = await there.page.evaluate(search, start.text, options);
    assert.equal(here.found.state, 'done');
    assert.deepEqual(here.found, chromiums.found);
    console.log(`        ${here.ms} ms, Chromium ${chromiums.ms} ms`);
  });
}
await check('a click on Synthesize starts a search in workers, which finds a motion', async () => {
  const before = await webkit.browser.evaluate((text) => {
    window.gaitsmith.open(text);
    window.gaitsmith.open({ ...window.gaitsmith.document(), hash: undefined, search: { seed: 5, evaluations: 8000 } });
    Object.assign(window, { testRates: [] });
    window.gaitsmith.on('progress', () => /** @type {any} */ (window).testRates.push(document.querySelector('#rate')?.textContent));
    return window.gaitsmith.hash();
  }, start.text);
  await webkit.click('panels/3');
  await webkit.click('search/start');
  await webkit.until('the end', () => document.querySelector('#status')?.textContent?.startsWith('Search done') ?? false);
  const { rates, hash } = await webkit.browser.evaluate(() => ({ rates: /** @type {any} */ (window).testRates, hash: window.gaitsmith.hash() }));
  assert.match(rates.join(), /on \d+ worker/);
  assert.notEqual(hash, before);
});
await check('a link of Chromium shows the same motion, bit for bit, in a fresh profile', async () => {
  const [link, hash] = [await there.link(), await there.hash()];
  webkit = await WebKitPage.enter(link);
  assert.equal(await webkit.hash(), hash);
});
await chromium.close(); // its page plays, and takes a processor
for (const [claim, story] of NEWCOMER_STORIES) {
  await check(`a newcomer ${claim}`, async () => {
    for (const means of /** @type {const} */ (['mouse', 'keys'])) {
      await story((link = address) => WebKitPage.enter(link, { newcomer: true }), means);
    }
  });
}
await WebKitPage.leave();
stopAll();
console.log(`\n${passed} passed, ${failed} failed`);
process.exitCode = failed ? 1 : 0;
