// SPDX-License-Identifier: MIT
// Transition maps with the page's client and worker, under Node.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { before, test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { NodeWorker } from './web_worker.mjs';

const HERE = fileURLToPath(new URL('.', import.meta.url));
const WEB = process.env.GAITSMITH_WEB ?? join(HERE, '../../build/wasm/web');

/** @typedef {import('../../web/search/messages.js').Mapped} Mapped */

/** @type {typeof import('../../web/search/transition_maps.js').TransitionMaps} */
let TransitionMaps;
/** @type {import('../../web/search/engine.js').Engine} */
let engine;
/** @type {WebAssembly.Module} */
let compiled;
/** @type {any} */
let composite;

before(async () => {
  ({ TransitionMaps } = await import(pathToFileURL(join(WEB, 'search/transition_maps.js')).href));
  const { Engine } = await import(pathToFileURL(join(WEB, 'search/engine.js')).href);
  compiled = await WebAssembly.compile(await readFile(join(WEB, 'search/engine_module.wasm')));
  engine = await Engine.load(compiled);
  composite = JSON.parse(await readFile(join(HERE, '../../examples/there-and-back.json'), 'utf8'));
});

/** @param {number} clip */
const request = (clip) => {
  const { controllers, timeline } = composite;
  const { senses, rules } = controllers[timeline[Math.max(0, clip)].controller ?? 0];
  return engine.documentFromText(JSON.stringify({ ...composite, hash: undefined, senses, rules: rules.length, search: { in_place_of: clip } }));
};

/** A client that records its events. @param {() => any} [createWorker] */
function client(createWorker = () => new NodeWorker(join(WEB, 'search/worker.js'))) {
  /** @type {Mapped[]} */
  const parts = [];
  /** @type {number[]} */
  const failures = [];
  /** @type {NodeWorker[]} */
  const workers = [];
  /** @type {() => void} */
  let onUpdate = () => {};
  const maps = new TransitionMaps({
    engine: () => Promise.resolve(compiled),
    createWorker: () => {
      workers.push(createWorker());
      return /** @type {any} */ (workers[workers.length - 1]);
    },
    listener: {
      mapped: (part) => { parts.push(part); onUpdate(); },
      failed: (generation) => { failures.push(generation); onUpdate(); },
    },
  });
  /** @param {() => boolean} condition */
  const until = (condition) => new Promise((resolve) => {
    onUpdate = () => { if (condition()) resolve(true); };
    onUpdate();
  });
  const complete = () => parts.some(({ first, scores, count }) => first + scores.length === count);
  return { maps, parts, failures, workers, until, complete };
}

test('transition maps: parts make the whole map, in order', async () => {
  const { maps, parts, failures, until, complete } = client();
  await maps.start(request(1), 7);
  await until(complete);
  const map = engine.transitionMap(request(1));
  const joined = parts.flatMap(({ scores }) => [...scores]);
  assert.deepEqual(joined, [...map.scores(0, map.count)]);
  assert.ok(parts.every(({ generation, usual, count }) => generation === 7 && usual === map.usual && count === map.count));
  assert.throws(() => map.scores(map.count, 1), /not in the map/);
  map.close();
  assert.deepEqual(failures, []);
  maps.close(); // otherwise the idle worker keeps the test running
});

test('transition maps: a replaced or stopped map reports nothing more', async () => {
  const { maps, parts, workers, until, complete } = client();
  void maps.start(request(1), 1);
  await maps.start(request(1), 2);
  await until(complete);
  assert.ok(parts.every(({ generation }) => generation === 2));
  assert.equal(workers.length, 1);
  const before = parts.length;
  await maps.start(request(1), 3);
  maps.stop();
  await maps.start(request(1), 4);
  await until(() => parts.slice(before).some(({ first, scores, count }) => first + scores.length === count));
  assert.ok(parts.slice(before).every(({ generation }) => generation === 4));
  maps.close(); // otherwise the idle worker keeps the test running
});

test('transition maps: a worker that dies, or refuses, is told of once; the next map gets another one', async () => {
  const { maps, parts, failures, workers, until, complete } = client();
  await maps.start(request(-1), 1);
  await until(() => failures.length > 0);
  void maps.start(request(1), 2);
  await until(() => workers.length === 2);
  workers[1].onerror?.({ message: 'it died' });
  await until(() => failures.length > 1);
  assert.deepEqual(failures, [1, 2]);
  await maps.start(request(1), 3);
  await until(complete);
  assert.ok(parts.every(({ generation }) => generation === 3));
  maps.close(); // otherwise the idle worker keeps the test running
});

test('transition maps: in the page, where it has no workers, a trap between two messages is one failure; the next map is whole', async (t) => {
  const { PageWorker } = await import(pathToFileURL(join(WEB, 'search/page_worker.js')).href);
  const { TransitionMap } = await import(pathToFileURL(join(WEB, 'search/engine.js')).href);
  const whole = TransitionMap.prototype.scores;
  let calls = 0;
  t.after(() => { TransitionMap.prototype.scores = whole; });
  TransitionMap.prototype.scores = function trapping(/** @type {any[]} */ ...args) {
    if (++calls === 3) throw new WebAssembly.RuntimeError('unreachable');
    return whole.apply(this, args);
  };
  const { maps, parts, failures, workers, until, complete } = client(() => new PageWorker());
  await maps.start(request(1), 1);
  await until(() => failures.length > 0);
  assert.equal(calls, 3);
  await maps.start(request(1), 2);
  await until(complete);
  assert.deepEqual(failures, [1]);
  assert.equal(workers.length, 2);
  const map = engine.transitionMap(request(1));
  assert.deepEqual(parts.filter(({ generation }) => generation === 2).flatMap(({ scores }) => [...scores]), [...map.scores(0, map.count)]);
  map.close();
  maps.close();
});

test('transition maps: where a part is lost all are told again; where one is lost again, that is a failure', async () => {
  for (const losses of [1, 2]) {
    const asked = /** @type {any[]} */ ([]);
    const failures = /** @type {number[]} */ ([]);
    const firsts = /** @type {number[]} */ ([]);
    /** @type {any} */
    const worker = { postMessage: (/** @type {any} */ message) => asked.push(message), terminate: () => {} };
    const maps = new TransitionMaps({
      engine: () => Promise.resolve(compiled),
      createWorker: () => worker,
      listener: { mapped: ({ first }) => firsts.push(first), failed: (generation) => failures.push(generation) },
    });
    await maps.start(new Uint8Array(), 5);
    for (let answered = 0; answered < asked.length; answered++) {
      const parts = answered < losses ? [0, 8] : [0, 4, 8]; // of twelve moments
      for (const first of parts) worker.onmessage({ data: { type: 'mapped', generation: 5, count: 12, first, scores: new Float32Array(4), usual: 1 } });
      await new Promise((resolve) => setTimeout(resolve));
    }
    assert.equal(asked.length, 2);
    assert.deepEqual(failures, losses === 1 ? [] : [5]);
    assert.deepEqual(firsts, losses === 1 ? [0, 8, 0, 4, 8] : [0, 8, 0, 8]);
    maps.close();
  }
});
