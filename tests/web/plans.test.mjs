// SPDX-License-Identifier: MIT
// Plans with the page's side, the worker and the planner, under Node.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFile, readdir, stat } from 'node:fs/promises';
import { join } from 'node:path';
import { before, test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { NodeWorker } from './web_worker.mjs';

const ROOT = fileURLToPath(new URL('../../', import.meta.url));
const WEB = process.env.GAITSMITH_WEB ?? join(ROOT, 'build/wasm/web');
const NATIVE = join(ROOT, 'build/tests/shell/gaitsmith');
const LAMP = join(ROOT, 'examples/plans/lamp-jump.json');

/** @typedef {import('../../web/plan/worker.js').PlanReport} PlanReport */

/** @type {typeof import('../../web/plan/plans.js').Plans} */
let Plans;
/** @type {import('../../web/search/engine.js').Engine} */
let engine;
/** @type {WebAssembly.Module} */
let compiled;
/** @type {any} */
let lamp;

before(async () => {
  ({ Plans } = await import(pathToFileURL(join(WEB, 'plan/plans.js')).href));
  const { Engine } = await import(pathToFileURL(join(WEB, 'search/engine.js')).href);
  engine = await Engine.load(await WebAssembly.compile(await readFile(join(WEB, 'search/engine_module.wasm'))));
  compiled = await WebAssembly.compile(await readFile(join(WEB, 'plan/planner_module.wasm')));
  lamp = JSON.parse(await readFile(LAMP, 'utf8'));
});

/** Whether there is a native program, built after the last change of core. */
async function isNativeNew() {
  const built = (await stat(NATIVE).catch(() => null))?.mtimeMs ?? 0;
  const files = (await readdir(join(ROOT, 'core'), { recursive: true })).map((name) => join(ROOT, 'core', name));
  const changes = await Promise.all(files.map((file) => stat(file)));
  return changes.every(({ mtimeMs }) => mtimeMs < built);
}

/** The lamp's document in binary form. @param {any} [changes]  of its plan */
const lampWith = (changes = {}) => engine.documentFromText(JSON.stringify({ ...lamp, plan: { ...lamp.plan, ...changes } }));

/**
 * Plans that record what happens.
 * @param {() => any} createWorker @param {{startMs?: number, silenceMs?: number, planner?: () => Promise<WebAssembly.Module>}} [options]
 */
function recorded(createWorker, options = {}) {
  const happened = { reports: /** @type {PlanReport[]} */ ([]), failures: /** @type {number[]} */ ([]), workers: /** @type {any[]} */ ([]), compilations: 0 };
  let onUpdate = () => {};
  const plans = new Plans({
    reported: (report) => { happened.reports.push(report); onUpdate(); },
    failed: (generation) => { happened.failures.push(generation); onUpdate(); },
  }, {
    planner: async () => { happened.compilations++; return compiled; },
    createWorker: () => {
      happened.workers.push(createWorker());
      return happened.workers.at(-1);
    },
    ...options,
  });
  /** @param {() => boolean} condition */
  const until = (condition) => new Promise((resolve) => {
    onUpdate = () => { if (condition()) resolve(true); };
    onUpdate();
  });
  return { plans, ...happened, happened, until };
}

const realWorker = () => new NodeWorker(join(WEB, 'plan/worker.js'));

/** A worker that does nothing but remember. */
function fakeWorker() {
  return {
    asked: /** @type {any[]} */ ([]), ended: false,
    onmessage: /** @type {(event: {data: any}) => void} */ (() => {}), onerror: /** @type {(event: any) => void} */ (() => {}),
    postMessage(/** @type {any} */ message) { this.asked.push(message); },
    terminate() { this.ended = true; },
    tell(/** @type {number} */ generation, /** @type {string} */ stage) { this.onmessage({ data: { type: 'report', generation, stage } }); },
  };
}

test('plans: a plan is found, refined and played, with the bits of the native program', async (context) => {
  const { plans, reports, failures, workers, until } = recorded(realWorker);
  await plans.start(lampWith(), 7);
  await until(() => reports.at(-1)?.stage === 'played');
  const stages = reports.map(({ stage }) => stage);
  assert.deepEqual(stages.filter((stage) => stage !== 'relaxing'), ['coarse', 'fine', 'played']);
  assert.ok(stages.includes('relaxing'));
  assert.ok(reports.every(({ generation, misses }) => generation === 7 && misses.length === 0));
  const [coarse, fine, played] = reports.filter(({ stage }) => stage !== 'relaxing');
  for (const { document } of [coarse, fine]) assert.ok(/** @type {any} */ (engine.json(document)).plan.solved.unknowns.length > 0);
  assert.equal(/** @type {any} */ (engine.json(played.document)).controllers.length, 1);
  assert.ok(played.playedMiss < 0.01 && played.playedMiss < played.firstMiss, `missed by ${played.playedMiss} m`);

  // The worker is used again.
  const before = reports.length;
  await plans.start(lampWith(), 8);
  await until(() => reports.length > before && reports.at(-1)?.stage === 'played');
  const again = /** @type {PlanReport} */ (reports.at(-1));
  assert.deepEqual({ ...again, generation: 7 }, played);
  assert.deepEqual([workers.length, failures], [1, []]);
  plans.close();

  if (!(await isNativeNew())) return context.diagnostic('not compared: there is no native program of this version');
  const [, numbers] = execFileSync(NATIVE, ['plan', LAMP], { encoding: 'utf8' }).trim().split('\n');
  const [iterations, cost, , playedMiss, firstMiss, corrections] = numbers.split(',').map(Number);
  const rounded = (/** @type {number} */ number) => Number(number.toPrecision(9));
  assert.deepEqual([played.iterations, rounded(played.cost), rounded(played.playedMiss), rounded(played.firstMiss), played.corrections],
    [iterations, cost, playedMiss, firstMiss, corrections]);
});

test('plans: what cannot be met is named, and what is no plan fails', async () => {
  const { plans, reports, failures, until } = recorded(realWorker);
  const [keyframe] = lamp.plan.keyframes;
  // Neither foot leaves the ground, so that the figure's middle cannot get three metres away.
  const far = { ...keyframe, marks: [{ endpoint: -1, axes: 'along', x_m: 3 }] };
  const stances = [0, 1].map((endpoint) => ({ endpoint, first_step: 0, last_step: 200 }));
  await plans.start(lampWith({ keyframes: [far], stances }), 1);
  await until(() => reports.at(-1)?.stage === 'refused');
  const { document, misses } = /** @type {PlanReport} */ (reports.at(-1));
  assert.equal(document.length, 0);
  assert.ok(misses.length >= 4 && misses.length % 4 === 0, `${misses.length} numbers`);
  assert.ok(misses[3] > 0.1, `by ${misses[3]}`);
  const before = reports.length;
  await plans.start(lampWith({ keyframes: [], stances: [] }), 2); // asks for nothing
  await until(() => failures.length === 1);
  await plans.start(new Uint8Array(9), 3);
  await until(() => failures.length === 2);
  assert.deepEqual([failures, reports.length], [[2, 3], before]);
  plans.close();
});

test('plans: a plan that is replaced or stopped is ended with its worker, and nothing is compiled again', async () => {
  const { plans, reports, failures, workers, happened } = recorded(fakeWorker);
  const document = new Uint8Array(3);
  await plans.start(document, 1);
  assert.deepEqual(workers[0].asked, [{ type: 'plan', code: compiled, document, generation: 1 }]);
  workers[0].tell(1, 'relaxing');
  await plans.start(document, 2);
  workers[0].tell(1, 'coarse'); // was on its way
  workers[1].tell(1, 'coarse');
  workers[1].tell(2, 'coarse');
  plans.stop();
  workers[1].tell(2, 'fine');
  await plans.start(document, 3);
  workers[2].tell(3, 'played');
  await plans.start(document, 4);
  assert.deepEqual(reports.map(({ generation, stage }) => [generation, stage]), [[1, 'relaxing'], [2, 'coarse'], [3, 'played']]);
  assert.deepEqual(workers.map(({ ended }) => ended), [true, true, false]);
  assert.equal(workers[2].asked.length, 2); // the last plan had ended
  plans.close();
  assert.ok(workers[2].ended);
  assert.deepEqual([failures, happened.compilations], [[], 1]);
});

test('plans: a plan that is stopped while the planner loads never starts', async () => {
  const { plans, workers, failures } = recorded(fakeWorker);
  const started = plans.start(new Uint8Array(), 1);
  plans.stop();
  await started;
  assert.deepEqual([workers, failures], [[], []]);
});

test('plans: a worker that dies or goes silent fails its plan once, and the next plan gets another worker', async () => {
  const { plans, reports, failures, workers, until } = recorded(fakeWorker, { startMs: 60, silenceMs: 30 });
  await plans.start(new Uint8Array(), 1);
  await until(() => failures.length === 1); // it never begins
  await plans.start(new Uint8Array(), 2);
  workers[1].tell(2, 'relaxing');
  await until(() => failures.length === 2);
  await plans.start(new Uint8Array(), 3);
  workers[2].onerror({});
  workers[2].onerror({});
  assert.deepEqual(failures, [1, 2, 3]);
  await plans.start(new Uint8Array(), 4);
  workers[3].tell(4, 'played');
  await new Promise((resolve) => { setTimeout(resolve, 100); });
  assert.deepEqual([failures, reports.length], [[1, 2, 3], 2]);
  assert.deepEqual(workers.map(({ ended }) => ended), [true, true, true, false]);
  plans.close();
});

test('plans: where the planner or a worker cannot be had the plan fails, and the next one tries again', async () => {
  let tries = 0;
  const { plans, failures, workers } = recorded(fakeWorker, {
    planner: async () => { if (++tries === 1) throw new Error('no network'); return compiled; },
  });
  await plans.start(new Uint8Array(), 1);
  await plans.start(new Uint8Array(), 2);
  assert.deepEqual([failures, workers.length, tries], [[1], 1, 2]);
  plans.close();
  const none = recorded(() => { throw new Error('this frame may have no workers'); });
  await none.plans.start(new Uint8Array(), 1);
  assert.deepEqual(none.failures, [1]);
});
