// SPDX-License-Identifier: MIT
// Searches without workers: all roles in one thread. Messages may still arrive at a port that was closed after they
// were sent, as in Firefox.
import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { assertSame, engine, fromWeb, newClient, problem, run } from './search_run.mjs';

/** @typedef {import('../../web/search/page_worker.js').PageWorker} PageWorker */
/** @typedef {import('../../web/search/messages.js').SearchReport} SearchReport */

/** @type {() => PageWorker} */
let createWorker;
/** The engine's script. Tests make its methods fail. @type {typeof import('../../web/search/engine.js')} */
let engineScript;

class LatePort {
  /** @type {LatePort | null} */
  other = null;
  /** @type {((event: {data: any}) => void) | null} */
  onmessage = null;
  closed = false;

  /** @param {any} data */
  postMessage(data) {
    if (!this.closed) setTimeout(() => this.other?.onmessage?.({ data }), 1);
  }

  close() { this.closed = true; }
  addEventListener() {}
}

before(async () => {
  const { PageWorker } = await fromWeb('search/page_worker.js');
  createWorker = () => new PageWorker();
  engineScript = await fromWeb('search/engine.js');
});

class LateChannel {
  port1 = new LatePort();
  port2 = new LatePort();
  constructor() {
    this.port1.other = this.port2;
    this.port2.other = this.port1;
  }
}

/** Runs searches as in a page, with late messages. @template T @param {() => Promise<T>} body @returns {Promise<T>} */
async function inPage(body) {
  const Usual = globalThis.MessageChannel;
  /** @type {any} */ (globalThis).MessageChannel = LateChannel;
  try {
    return await body();
  } finally {
    globalThis.MessageChannel = Usual;
  }
}

test('it finds what workers find', async () => {
  for (const algorithm of ['sphc', 'gga']) {
    const document = problem({ algorithm, evaluations: 1000 });
    const workers = await run(document, 2);
    for (const count of [1, 2]) assertSame(await inPage(() => run(document, count, undefined, { createWorker })), workers);
  }
});

/**
 * Records calls to parts of the engine that were freed or have trapped, or were marked by doomSearches().
 * @param {import('node:test').TestContext} t
 * @param {(call: string, times: number) => boolean} [traps]  whether this call traps
 */
function watch(t, traps = () => false) {
  /** @type {string[]} */
  const late = [];
  const searches = new Set();
  const ended = new WeakSet();
  /** @type {Record<string, number>} */
  const times = {};
  for (const [role, calls] of /** @type {const} */ ([['Evaluator', ['score']], ['Search', ['ask', 'tell', 'save']], ['TransitionMap', ['scores']]])) {
    const prototype = /** @type {any} */ (engineScript[role].prototype);
    for (const call of [...calls, 'close']) {
      const whole = prototype[call];
      t.after(() => { prototype[call] = whole; });
      prototype[call] = function watched(/** @type {any[]} */ ...args) {
        const name = `${role}.${call}`;
        if (ended.has(this)) late.push(name);
        if (role === 'Search') searches.add(this);
        if (call === 'close') ended.add(this);
        times[name] = (times[name] ?? 0) + 1;
        if (traps(name, times[name])) {
          ended.add(this);
          throw new WebAssembly.RuntimeError('unreachable');
        }
        return whole.apply(this, args);
      };
    }
  }
  return { late, doomSearches: () => searches.forEach((search) => ended.add(search)) };
}

test('a search that takes the place of another hears nothing of its work', async (t) => {
  const [long, short] = [problem({ evaluations: 1e6, seed: 4 }), problem({ evaluations: 400 })];
  /** @type {(report: SearchReport) => void} */
  let onReport = () => {};
  const client = newClient({ progress: (report) => onReport(report), incident: assert.fail, failed: assert.fail }, createWorker);
  /** Resolved with the first matching report. @param {Uint8Array} document @param {(report: SearchReport) => boolean} matches @returns {Promise<SearchReport>} */
  const search = (document, matches) => new Promise((resolve) => {
    onReport = (report) => { if (matches(report)) resolve(report); };
    client.start(document, 2);
  });
  const usual = await run(short, 1);
  const { late } = watch(t);
  await inPage(async () => {
    for (let round = 0; round < 5; round++) {
      await search(long, ({ evaluations }) => evaluations > 0);
      const last = await search(short, ({ state }) => state === 'done');
      assertSame({ last, genome: last.bestGenome ?? new Uint16Array(), reports: [], incidents: [] }, usual);
    }
  });
  assert.deepEqual(late, []);
});

/** A role, its call that traps once, and the expected sentence. @type {[string, string, RegExp][]} */
const TRAPS = [
  ['an evaluator', 'Evaluator.score', /Another one took over/],
  ['the coordinator', 'Search.tell', /continues from evaluation/],
];
for (const [role, call, sentence] of TRAPS) {
  test(`${role} that traps is replaced, and the page does not take itself for the one that trapped`, async (t) => {
    const document = problem({ evaluations: 1000 });
    const usual = await run(document, 1);
    const { late } = watch(t, (name, times) => name === call && times === 20);
    const dying = await inPage(() => run(document, 2, undefined, { createWorker }));
    assert.match(dying.incidents.join(), sentence);
    assert.equal(dying.incidents.length, 1);
    assertSame(dying, usual);
    assert.deepEqual(late, []);
  });
}

test('a coordinator that traps at a message asks nothing more of the engine, whatever its evaluators say', async (t) => {
  const document = problem({ evaluations: 4000 });
  const usual = await run(document, 1);
  const { late, doomSearches } = watch(t);
  let [poisoned, next] = [0, 0]; // next: index of the next coordinator in the team
  const dying = await inPage(() => run(document, 2, (_, report, team) => {
    if (poisoned >= 3 || report.evaluations < 500 || next >= team.length) return;
    team[next].postMessage({ run: ++poisoned, get type() { doomSearches(); return 'poison'; } });
    next = team.length;
  }, { createWorker }));
  assert.equal(dying.incidents.length, 3);
  assertSame(dying, usual);
  assert.deepEqual(late, []);
});

test('a disconnected coordinator receives nothing from its ports, and one that traps in its timer reports the trap', async (t) => {
  const { Coordinator } = await fromWeb('search/worker_coordinator.js');
  const document = problem({ evaluations: 600 });
  const evaluator = engine.evaluator(document);
  const { late } = watch(t);
  /** @type {(error: unknown) => void} */
  let die = (error) => assert.fail(String(error));
  const begin = () => new Coordinator(engine, { document, state: null, workers: 1 }, () => {}, (/** @type {unknown} */ error) => die(error));
  const gone = begin();
  const port = new LatePort();
  const sent = /** @type {any[]} */ ([]);
  port.postMessage = (message) => sent.push(message);
  gone.receive({ type: 'add-evaluator', evaluator: 1, port });
  assert.ok(sent.length > 0);
  gone.disconnect();
  gone.free();
  for (const { slice, genomes } of sent) port.onmessage?.({ data: { slice, scores: evaluator.score(genomes) } });
  assert.deepEqual(late, []);
  evaluator.close();

  const trapped = begin();
  const trap = new WebAssembly.RuntimeError('unreachable');
  Object.defineProperty(trapped.search, 'evaluations', { get: () => { throw trap; } });
  assert.equal(await new Promise((resolve) => { die = resolve; }), trap);
  trapped.disconnect();
});
