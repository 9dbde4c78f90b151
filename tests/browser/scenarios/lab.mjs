// SPDX-License-Identifier: MIT
// The lab, used by a person and by a script. Each scenario opens its own pages.
import assert from 'node:assert/strict';
import { ONE_BROWSER, PageDriver } from '../page_driver.mjs';
import { settle } from '../assistive.mjs';
import { nativeCurves } from '../native.mjs';

/** @typedef {import('./all.mjs').Visit} Visit */

/** @param {Visit} visit */
async function byClicks({ browser, address, figures }) {
  const options = { algorithms: ['sphc', 'ssga'], trials: 2, evaluations: 400, firstSeed: 5 };
  const first = await PageDriver.open(browser, address);
  const link = await first.call('link', () => {
    const document = window.gaitsmith.document();
    window.gaitsmith.open({ ...document, title: 'Lab Test', view: { panel: 4 } });
    return window.gaitsmith.link();
  });
  await first.close();

  const page = await PageDriver.open(browser, link); // opens with the panel
  const before = await page.hash();
  const text = await page.call('document', () => JSON.stringify(window.gaitsmith.document()));
  await page.call('keep files', () => {
    Object.assign(window, { testFiles: [] });
    const make = URL.createObjectURL.bind(URL);
    URL.createObjectURL = (blob) => {
      if (blob instanceof Blob && blob.type === 'text/csv') /** @type {any} */ (window).testFiles.push(blob);
      return make(blob);
    };
  });
  // The panel allows no fewer than 500 evaluations, so a script starts the lab. The panel keeps the script's options.
  await page.page.evaluate((request) => window.gaitsmith.lab(request), options);
  assert.match(await page.status(), /^Lab done: 4 of 4 trials/);
  assert.equal((await page.widgets()).find(({ id }) => id === 'panels/4')?.state.selected, true);
  await page.frames(6);
  for (const id of ['lab/curves', 'lab/table']) {
    assert.match((await page.widgets()).find((widget) => widget.id === id)?.value ?? '',
      /^SPHC, 2 trials: median \d+\.\d\d, quartiles .*; SSGA, 2 trials: median .*400 evaluations$/, id);
  }

  // A second run by a click, after changing the first seed up and down again.
  const stage = (await page.widgets()).find(({ id }) => id === 'stage')?.rect ?? { x: 0, y: 0, width: 0, height: 0 };
  await page.page.mouse.move(stage.x + stage.width + 100, stage.y + 200);
  await page.page.mouse.wheel({ deltaY: 2000 });
  await page.frames();
  await page.click('lab/first-seed/more');
  await page.click('lab/first-seed/less');
  await page.page.mouse.wheel({ deltaY: -3000 });
  await page.frames();
  await page.click('lab/start');
  await page.until('the end', () => window.gaitsmith.widgets().some(({ id }) => id === 'lab/start')
    && (document.querySelector('#status')?.textContent ?? '').startsWith('Lab done: 4 of 4'));
  await page.click('lab/save');
  await page.until('a file', () => /** @type {any} */ (window).testFiles.length === 1);
  const csv = await page.call('file', () => /** @type {Promise<string>} */ (/** @type {any} */ (window).testFiles[0].text()));
  const [, columns, ...rows] = csv.trimEnd().split('\n');
  assert.equal(columns, 'problem,search,seed,evaluation,best');
  assert.match(rows[0], /^lab-test,sphc,5,\d+,[\d.]+$/);
  assert.match(rows[rows.length - 1], /^lab-test,ssga,6,400,[\d.]+$/);
  const native = await nativeCurves(text, 'lab-test', options);
  figures['lab against the command line'] = native === null ? 'not compared: the command line is not built' : 'the same file';
  if (native !== null) assert.equal(csv, native);
  assert.equal(await page.hash(), before);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function byScript({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  const told = await page.call('lab', async () => {
    const { gaitsmith } = window;
    const fault = (/** @type {Promise<unknown>} */ request) => request.then(() => 'nothing', (error) => String(error.message));
    const events = /** @type {string[]} */ ([]);
    for (const type of /** @type {const} */ (['progress', 'done', 'error'])) gaitsmith.on(type, () => events.push(type));
    const unknown = await fault(gaitsmith.lab({ algorithms: ['anneal'] }));
    const crowded = await fault(gaitsmith.lab({ algorithms: ['mpga'], evaluations: 400 }));
    const long = gaitsmith.lab({ algorithms: ['rgt'], trials: 3, evaluations: 1000000 });
    const busy = await fault(gaitsmith.synthesize({ evaluations: 500 }));
    const short = gaitsmith.lab({ algorithms: ['rgt', 'shc'], trials: 3, evaluations: 20 });
    const results = [await long, await short].map(({ state, rows }) => ({ state, rows: rows.length }));
    const stopped = gaitsmith.lab({ evaluations: 1000000 });
    gaitsmith.stop();
    results.push({ state: (await stopped).state, rows: 0 });
    const quiet = events.length;
    const search = gaitsmith.synthesize({ evaluations: 1000000, seed: 2 });
    const searching = await fault(gaitsmith.lab());
    gaitsmith.stop();
    const { report } = await search;
    return { unknown, crowded, busy, searching, results, quiet, end: report.state };
  });
  assert.match(told.unknown, /anneal/);
  assert.match(told.crowded, /mpga/);
  assert.match(told.busy, /lab is running/);
  assert.match(told.searching, /search is running/);
  assert.deepEqual(told.results, [{ state: 'stopped', rows: 0 }, { state: 'done', rows: 120 }, { state: 'stopped', rows: 0 }]);
  assert.equal(told.quiet, 0, 'trials of the lab were told as searches');
  assert.equal(told.end, 'stopped');
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function namesPushes({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  await page.click('panels/4');
  // Texts of the canvas are in its mirror.
  const words = () => page.page.evaluate(() => [...document.querySelectorAll('#mirror p')].map(({ textContent }) => textContent)
    .find((text) => text?.startsWith('In every trial the figure gets')) ?? '');
  const push = (/** @type {number} */ count) => page.page.evaluate((pushes) => {
    window.gaitsmith.open({ ...window.gaitsmith.document(), hash: undefined, view: { panel: 4 },
      pushes: Array.from({ length: pushes }, (_, i) => ({ step: 120 + i, endpoint: -1, impulse_x_ns: 5, impulse_y_ns: 0 })) });
  }, count);
  await page.frames(6);
  assert.equal(await words(), '');
  for (const [count, sentence] of /** @type {[number, RegExp][]} */ ([[1, /gets the push at 1\.20 s\./], [2, /gets the 2 pushes of this document\./]])) {
    await push(count);
    await settle(page);
    assert.match(await words(), sentence);
  }
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @type {import('./all.mjs').Scenario[]} */
export const LAB_SCENARIOS = [
  ['the lab, by clicks from a link, draws curves and saves what the command line finds; the motion stays', byClicks],
  ['the lab says when its trials include a push', namesPushes, ONE_BROWSER],
  ['the lab by script gives rows, can be stopped, and excludes a search', byScript, ONE_BROWSER],
];
