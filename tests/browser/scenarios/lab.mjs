// SPDX-License-Identifier: MIT
// The lab, used by a person and by a script. Each scenario opens its own pages.
import assert from 'node:assert/strict';
import { ONE_BROWSER, PageDriver } from '../page_driver.mjs';
import { settle } from '../assistive.mjs';
import { nativeCurves } from '../native.mjs';

/** @typedef {import('./all.mjs').Visit} Visit */
/** @typedef {import('../../../web/page/lab.js').LabRow} LabRow */

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

/** The names on the page, in the order in which the trials take turns. @type {Record<string, string>} */
const NAMES = { rgt: 'RG&T', sphc: 'SPHC', 'pose-cycle': 'Pose cycle' };
const NO_MOTION = -1e8;
/** @param {number} evaluations */
const grouped = (evaluations) => Math.round(evaluations).toLocaleString('en-US');
/** @param {number[]} values */
const median = (values) => {
  const sorted = [...values].sort((a, b) => a - b);
  const middle = (sorted.length - 1) / 2;
  return (sorted[Math.floor(middle)] + sorted[Math.ceil(middle)]) / 2;
};

/** As a table prints it, but not above it. @param {number} value */
const inSixDigits = (value) => {
  const near = Number(value.toPrecision(6));
  return near > value ? Number((near - 10 ** (Math.floor(Math.log10(Math.abs(value))) - 5)).toPrecision(6)) : near;
};

/**
 * What the fold "How soon" must say of the first trials of a run, from nothing but their rows.
 * @param {LabRow[]} rows @param {{algorithms: string[], evaluations: number}} options @param {number} finished  trials
 */
function soonFrom(rows, { algorithms, evaluations }, finished) {
  const count = Math.min(100, evaluations); // points of a curve
  const seeds = [...new Set(rows.map(({ seed }) => seed))].sort((a, b) => a - b);
  const turns = seeds.flatMap((seed) => algorithms.map((search) => ({ search, seed }))).slice(0, finished);
  const trials = turns.map(({ search, seed }) => {
    const best = new Map(rows.filter((row) => row.search === search && row.seed === seed).map((row) => [row.evaluation, Math.fround(row.best)]));
    const points = Array.from({ length: count }, (_, point) => Math.floor((evaluations * (point + 1)) / count));
    return { search, points: points.map((at) => ({ at, best: best.get(at) ?? -Infinity })) };
  });
  const least = median(trials.flatMap(({ points }) => points.find(({ best }) => best > NO_MOTION)?.best ?? []));
  const most = Math.max(...trials.map(({ points }) => points[count - 1].best));
  const targets = Array.from({ length: 20 }, (_, i) => inSixDigits(i < 19 ? least + ((most - least) * (i + 1)) / 20 : most));
  const halfway = targets[9];
  const said = algorithms.map((search) => {
    const own = trials.filter((trial) => trial.search === search);
    if (own.length === 0) return { name: NAMES[search], share: NaN, trials: 0, halfway: '' };
    const hits = own.flatMap(({ points }) => targets.filter((target) => points[count - 1].best >= target)).length;
    // A trial that did not get there counts with all its evaluations.
    const there = own.flatMap(({ points }) => points.find(({ best }) => best >= halfway)?.at ?? []);
    const expected = (there.reduce((sum, at) => sum + at, 0) + evaluations * (own.length - there.length)) / there.length;
    // Of two trials, a quarter of all samples has only the first, and a quarter only the second.
    const spread = there.length === own.length ? `${grouped(Math.min(...there))} to ${grouped(Math.max(...there))}` : `${grouped(there[0])} or more`;
    return { name: NAMES[search], share: hits / own.length / targets.length, trials: own.length,
      halfway: there.length === 0 ? 'not halfway' : `halfway after ${grouped(expected)} (${spread})` };
  });
  return { halfway, said };
}

/** Compares the value of the fold's plot. @param {string} text @param {ReturnType<typeof soonFrom>} wanted */
function assertReached(text, { said }) {
  const parts = text.split('; ');
  assert.equal(parts.length, said.length, text);
  said.forEach(({ name, share, trials, halfway }, i) => {
    if (trials === 0) return assert.equal(parts[i], `${name}: none yet`);
    const [, who, percent, when] = /^(.+): (\d+) % of the targets, (.+)$/.exec(parts[i]) ?? assert.fail(parts[i]);
    assert.equal(who, name);
    assert.ok(Math.abs(Number(percent) - 100 * share) <= 0.5 + 1e-9, `${parts[i]} is not ${100 * share} %`);
    // Of three trials or more, only the page knows the samples.
    const shown = trials <= 2 ? when : when.replace(/ \(.*/, '');
    assert.equal(shown, trials <= 2 ? halfway : halfway.replace(/ \(.*/, ''), `of ${name}, ${trials} trials`);
  });
}

/** @param {Visit} visit */
async function howSoon({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  await page.page.setViewport({ width: 1280, height: 1300 }); // the fold fits
  await page.call('a problem', () => {
    window.gaitsmith.open({ ...window.gaitsmith.document(), hash: undefined, task: { kind: 'travel-right', duration_steps: 200 }, view: { panel: 4 } });
  });
  const valueOf = async (/** @type {string} */ id) => (await page.widgets()).find((widget) => widget.id === id)?.value;
  const words = () => page.page.evaluate(() => [...document.querySelectorAll('#mirror p')].map(({ textContent }) => textContent ?? ''));
  /** @param {import('../../../web/app/app.js').LabOptions} options */
  const run = (options) => page.page.evaluate((wanted) => window.gaitsmith.lab(wanted), options);
  /** @param {LabRow[]} rows @param {{algorithms: string[], evaluations: number, trials: number}} options */
  const judge = async (rows, options) => {
    await settle(page);
    const wanted = soonFrom(rows, options, options.trials * options.algorithms.length);
    assertReached(await valueOf('lab/reached') ?? '', wanted);
    const texts = await words();
    assert.ok(texts.some((text) => text.startsWith('Twenty targets') && text.endsWith(`Halfway is a score of ${wanted.halfway.toFixed(2)}.`)), texts.join('\n'));
    for (const { name, halfway } of wanted.said) assert.ok(texts.includes(`${name}: ${halfway}`), `${name}: ${halfway}\n\n${texts.join('\n')}`);
    return wanted;
  };

  const two = { algorithms: ['rgt', 'sphc'], trials: 2, evaluations: 500, firstSeed: 1 };
  const first = await run(two);
  await page.frames(6);
  assert.equal(await valueOf('lab/reached'), undefined, 'folded at first');
  await page.click('lab/targets');
  assert.equal((await page.widgets()).find(({ id }) => id === 'lab/targets')?.state.expanded, true);
  const before = await judge(first.rows, two);

  // A better search raises the targets, and with them what is said of the same trials.
  const three = { ...two, algorithms: [...two.algorithms, 'pose-cycle'] };
  const second = await run(three);
  const after = await judge(second.rows, three);
  assert.deepEqual(second.rows.filter(({ search }) => search !== 'pose-cycle'), first.rows, 'the same trials');
  assert.ok(after.halfway > before.halfway, `${after.halfway} after ${before.halfway}`);
  for (const i of [0, 1]) {
    assert.ok(after.said[i].share < before.said[i].share, `${after.said[i].share} of the targets after ${before.said[i].share}`);
  }
  assert.notDeepEqual(after.said.slice(0, 2).map(({ halfway }) => halfway), before.said.map(({ halfway }) => halfway));
  assert.ok([before, after].some(({ said }) => said.some(({ halfway }) => halfway.endsWith('or more)'))), 'a trial that did not get there');

  // Live: each frame of a run says what the trials so far give. The run is far longer than the frames that are seen of it.
  const seen = await page.call('a run', () => new Promise((resolve, reject) => {
    const frames = /** @type {{table: string, reached: string}[]} */ ([]);
    const long = window.gaitsmith.lab({ trials: 50 });
    let ended = false;
    const look = () => {
      const widgets = window.gaitsmith.widgets();
      const valueOf = (/** @type {string} */ id) => widgets.find((widget) => widget.id === id)?.value ?? '';
      const runs = widgets.some(({ id }) => id === 'lab/stop');
      if (runs && !ended) frames.push({ table: valueOf('lab/table'), reached: valueOf('lab/reached') });
      if (/(^|; )Pose cycle, [1-9]/.test(frames.at(-1)?.table ?? '') && !ended) {
        ended = true;
        window.gaitsmith.stop();
        long.then(({ state, rows }) => resolve({ state, rows, frames }), reject);
      } else if (!ended) {
        requestAnimationFrame(look);
      }
    };
    requestAnimationFrame(look);
  }));
  const { state, rows, frames } = /** @type {{state: string, rows: LabRow[], frames: {table: string, reached: string}[]}} */ (seen);
  assert.equal(state, 'stopped');
  const live = frames.map(({ table, reached }) => ({ reached, finished: [...table.matchAll(/, (\d+) trials?/g)].reduce((sum, [, n]) => sum + Number(n), 0) }))
    .filter(({ finished }) => finished > 0);
  assert.ok(live.length > 0);
  for (const { reached, finished } of live) assertReached(reached, soonFrom(rows, three, finished));
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @type {import('./all.mjs').Scenario[]} */
export const LAB_SCENARIOS = [
  ['the lab, by clicks from a link, draws curves and saves what the command line finds; the motion stays', byClicks],
  ['the lab says when its trials include a push', namesPushes, ONE_BROWSER],
  ['the lab says how soon trials reach targets, from what they found, while it runs, too', howSoon],
  ['the lab by script gives rows, can be stopped, and excludes a search', byScript, ONE_BROWSER],
];
