// SPDX-License-Identifier: MIT
// Searches where the page has no workers: all roles in one thread, in which what a port was sent before it was closed may
// still come, as in Firefox.
import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { assertSame, fromWeb, newClient, problem, run } from './search_run.mjs';

/** @typedef {import('../../web/page_worker.js').PageWorker} PageWorker */
/** @typedef {import('../../web/messages.js').SearchReport} SearchReport */

/** @type {() => PageWorker} */
let createWorker;
/** What the roles run on; spoilt in tests. @type {typeof import('../../web/engine.js')} */
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
  const { PageWorker } = await fromWeb('page_worker.js');
  createWorker = () => new PageWorker();
  engineScript = await fromWeb('engine.js');
});

class LateChannel {
  port1 = new LatePort();
  port2 = new LatePort();
  constructor() {
    this.port1.other = this.port2;
    this.port2.other = this.port1;
  }
}

/** What is searched in it, is searched in the page. @template T @param {() => Promise<T>} body @returns {Promise<T>} */
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

test('a search that takes the place of another hears nothing of its work', async () => {
  const [long, short] = [problem({ evaluations: 1e6, seed: 4 }), problem({ evaluations: 400 })];
  /** @type {(report: SearchReport) => void} */
  let hear = () => {};
  const client = newClient({ progress: (report) => hear(report), incident: assert.fail, failed: assert.fail }, createWorker);
  /** Resolved with the first report that is meant. @param {Uint8Array} document @param {(report: SearchReport) => boolean} meant @returns {Promise<SearchReport>} */
  const search = (document, meant) => new Promise((resolve) => {
    hear = (report) => { if (meant(report)) resolve(report); };
    client.start(document, 2);
  });
  const usual = await run(short, 1);
  await inPage(async () => {
    for (let round = 0; round < 5; round++) {
      await search(long, ({ evaluations }) => evaluations > 0);
      const last = await search(short, ({ state }) => state === 'done');
      assertSame({ last, genome: last.bestGenome ?? new Uint16Array(), reports: [], incidents: [] }, usual);
    }
  });
});

/** What traps, once, and what is said of it. @type {[string, 'Evaluator' | 'Search', string, RegExp][]} */
const TRAPS = [
  ['an evaluator', 'Evaluator', 'score', /another one took over/],
  ['the coordinator', 'Search', 'tell', /continues from evaluation/],
];
for (const [who, role, call, said] of TRAPS) {
  test(`${who} that traps is replaced, and the page does not take itself for the one that trapped`, async (t) => {
    const document = problem({ evaluations: 1000 });
    const usual = await run(document, 1);
    const prototype = /** @type {any} */ (engineScript[role].prototype);
    const whole = prototype[call];
    let calls = 0;
    t.after(() => { prototype[call] = whole; });
    prototype[call] = function trapping(/** @type {any[]} */ ...args) {
      if (++calls === 20) throw new WebAssembly.RuntimeError('unreachable');
      return whole.apply(this, args);
    };
    const dying = await inPage(() => run(document, 2, undefined, { createWorker }));
    assert.match(dying.incidents.join(), said);
    assert.equal(dying.incidents.length, 1);
    assertSame(dying, usual);
  });
}
