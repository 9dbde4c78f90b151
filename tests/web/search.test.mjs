// SPDX-License-Identifier: MIT
// Searches with the page's client and workers, under Node: the result has the same bits for any number of workers, and
// if workers die. There are no expected values, every claim compares two runs.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { test } from 'node:test';
import { assertSame, engine, fromWeb, newClient, newWorker, problem, run } from './search_run.mjs';

/** @typedef {import('./web_worker.mjs').NodeWorker} NodeWorker */
/** @typedef {import('../../web/search/messages.js').SearchReport} SearchReport */
/** @typedef {import('./search_run.mjs').Run} Run */

for (const settings of [{ algorithm: 'sphc' }, { algorithm: 'rgt' }, { algorithm: 'gga' }, { algorithm: 'shc' }, { algorithm: 'cma-es' },
  { algorithm: 'map-elites' }, { algorithm: 'de' }, { algorithm: 'cma-mae' }, { algorithm: 'pose-cycle' }, { algorithm: 'pose-cycle', body: 'lot' }, { algorithm: 'sphc', body: 'little' }]) {
  test(`${Object.values(settings).join(', body=')}: one, two and three workers find the same`, async () => {
    const document = problem(settings);
    const [one, two, three] = [await run(document, 1), await run(document, 2), await run(document, 3)];
    assert.equal(one.last.evaluations, 3000);
    assert.ok(one.last.bestFitness > 0.5);
    assertSame(one, two);
    assertSame(one, three);
  });
}

test('NSGA-II: workers measure the cost, and find what the search finds alone', async () => {
  const document = problem({ algorithm: 'nsga-ii', evaluations: 1200, genetic: { population: 60 } });
  const search = engine.search(document);
  while (!search.done) {
    search.ask(60);
    search.scoreHere();
  }
  const one = await run(document, 1), two = await run(document, 2);
  assertSame(one, two);
  assert.deepEqual(one.genome, search.bestGenome);
  assert.deepEqual(one.last.saved, search.save());
  search.close();
});

test('a network, by the two-stage search: one, two and three workers find the same', async () => {
  const document = problem({ algorithm: 'two-stage', evaluations: 1500 }, { kind: 'network' });
  const [one, two, three] = [await run(document, 1), await run(document, 2), await run(document, 3)];
  assert.ok(one.last.bestFitness > 0.5);
  assertSame(one, two);
  assertSame(one, three);
});

test('a figure of springs: one, two and three workers find the same', async () => {
  const figure = JSON.parse(await readFile(new URL('../../examples/figures/walking-table.json', import.meta.url), 'utf8'));
  const document = problem({ algorithm: 'pose-cycle', evaluations: 1500 }, { model: 3, figure });
  const [one, two, three] = [await run(document, 1), await run(document, 2), await run(document, 3)];
  assert.ok(one.last.bestFitness > 0.5);
  assertSame(one, two);
  assertSame(one, three);
});

test('five and eight workers find the same as one', async () => {
  const document = problem({ evaluations: 1000 });
  const one = await run(document, 1);
  for (const workers of [5, 8]) assertSame(one, await run(document, workers));
});

test('reports tell how the population scatters, and random search has none', async () => {
  const { reports, last } = await run(problem({ population: 12 }), 2);
  assert.equal(last.spread?.members, 12);
  assert.equal(last.spread?.best, last.bestFitness);
  for (const { spread } of reports) {
    if (!spread) continue; // fewer than two members are scored
    const { least, lowerQuartile, median, upperQuartile, best } = spread;
    assert.deepEqual([least, lowerQuartile, median, upperQuartile, best].sort((a, b) => a - b),
      [least, lowerQuartile, median, upperQuartile, best]);
  }
  assert.equal((await run(problem({ algorithm: 'rgt', evaluations: 400 }), 2)).last.spread, null);
});

test('the best genome scores what the search says', async () => {
  const document = problem({});
  const { genome, last } = await run(document, 2);
  assert.equal(engine.evaluator(document).evaluate(genome)[0], last.bestFitness);
});

test('workers that stood by, or whose search is done, run the next one, of another problem, as new ones would', async () => {
  const [first, second] = [problem({ evaluations: 500 }), problem({ evaluations: 1500, seed: 11, algorithm: 'rgt' })];
  /** @type {NodeWorker[]} */
  const team = [];
  /** @type {(report: SearchReport) => void} */
  let onReport = () => {};
  const client = newClient({ progress: (report) => onReport(report), incident: assert.fail, failed: assert.fail },
    () => team[team.push(newWorker()) - 1]);
  /** @param {Uint8Array} document @param {number} workers @returns {Promise<Run>} */
  const search = (document, workers) => new Promise((resolve) => {
    onReport = (last) => {
      if (last.state === 'done') resolve({ reports: [], incidents: [], last, genome: last.bestGenome ?? new Uint16Array() });
    };
    client.start(document, workers);
  });
  client.standBy(2);
  client.standBy(2); // a second time, which creates no workers
  assert.equal(team.length, 3);
  await search(first, 2); // at once, while they still load
  assertSame(await search(second, 2), await run(second, 1));
  assert.equal(team.length, 3);
  assertSame(await search(first, 1), await run(first, 1));
  assert.equal(team.length, 3);
  assertSame(await search(second, 3), await run(second, 1));
  assert.equal(team.length, 5);
});

/** Long enough that an accident comes before the end, although a busy machine hears late of both. */
const LONG = { evaluations: 12_000 };

/**
 * Runs with two evaluators and terminates a worker early on, without any event, like a browser that is short of memory.
 * @param {Uint8Array} document @param {number} victim  index; 0: the coordinator
 */
function runWithDeath(document, victim) {
  let killed = false;
  return run(document, 2, (_, report, team) => {
    if (killed || report.evaluations < 2000) return;
    killed = true;
    team[victim].terminate();
  });
}

test('an evaluator that dies is replaced, and nothing is lost', async () => {
  const document = problem(LONG);
  const dying = await runWithDeath(document, 1);
  assert.equal(dying.incidents.length, 1);
  assertSame(dying, await run(document, 1));
});

test('a coordinator that dies is replaced, and the search continues from its checkpoint', async () => {
  const document = problem(LONG);
  const dying = await runWithDeath(document, 0);
  assert.match(dying.incidents.join(), /continues from evaluation/);
  assertSame(dying, await run(document, 1));
});

test('an exception in the coordinator ends it, so that it is replaced', async () => {
  const document = problem(LONG);
  let poisoned = false;
  const dying = await run(document, 2, (_, report, team) => {
    if (poisoned || report.evaluations < 500) return;
    poisoned = true;
    team[0].postMessage({ type: 'poison', run: 1 });
  });
  assert.match(dying.incidents.join(), /continues from evaluation/);
  assertSame(dying, await run(document, 1));
});

test('an engine that cannot be instantiated is an error, not a silence', async () => {
  // Imports x.y, which does not exist.
  const wanting = new WebAssembly.Module(new Uint8Array([
    0, 0x61, 0x73, 0x6d, 1, 0, 0, 0, 1, 4, 1, 0x60, 0, 0, 2, 7, 1, 1, 0x78, 1, 0x79, 0, 0]));
  const { Engine } = await fromWeb('search/engine.js');
  await assert.rejects(Engine.load(wanting), /instantiate/);
  const start = performance.now();
  await assert.rejects(run(problem({}), 1, undefined, { module: wanting }), /stopped too often/);
  assert.ok(performance.now() - start < 20000);
});

test('what an evaluator sent before it was given up does not count beside what another one makes of it', async () => {
  const { Coordinator } = await fromWeb('search/worker_coordinator.js');
  const document = problem({ evaluations: 600 });
  const evaluator = engine.evaluator(document);
  /** @type {any} */
  let last = null;
  const coordinator = new Coordinator(engine, { document, state: null, workers: 8 },
    (/** @type {any} */ { type, report }) => { if (type === 'finished') last = report; }, assert.fail);
  const port = () => ({ sent: /** @type {any[]} */ ([]), onmessage: /** @type {any} */ (null), close: () => {}, addEventListener: () => {},
    postMessage(/** @type {any} */ message) { this.sent.push(message); } });
  const steady = port();
  coordinator.receive({ type: 'add-evaluator', evaluator: 0, port: steady });
  for (let lost = 1; steady.sent.length > 0; lost++) {
    const late = port();
    coordinator.receive({ type: 'add-evaluator', evaluator: lost, port: late });
    coordinator.receive({ type: 'remove-evaluator', evaluator: lost });
    for (const port of [late, steady]) {
      for (const { slice, genomes } of port.sent.splice(0)) port.onmessage?.({ data: { slice, scores: evaluator.score(genomes) } });
    }
  }
  coordinator.disconnect();
  coordinator.free();
  evaluator.close();
  assertSame({ last, genome: last.bestGenome, reports: [], incidents: [] }, await run(document, 1));
});

test('scores that were not asked for are refused', () => {
  const document = problem({});
  const search = engine.search(document);
  const evaluator = engine.evaluator(document);
  const refused = { name: 'EngineError', message: /not asked/ };
  assert.throws(() => search.tell(new Float32Array(0)), refused);
  const fitness = evaluator.evaluate(search.ask(16));
  search.tell(fitness);
  assert.throws(() => search.tell(fitness), refused);
  assert.throws(() => search.tell(new Float32Array(0)), refused);
  const state = search.save();
  const asked = search.ask(16);
  search.load(state);
  assert.throws(() => search.tell(evaluator.evaluate(asked)), refused);
  assert.deepEqual(search.ask(16), asked);
  search.close();
  evaluator.close();
});

test('pause holds the search, resume goes on to the same end', async () => {
  const document = problem({ evaluations: 4000 });
  let paused = 0;
  const held = await run(document, 2, (client, report) => {
    if (report.evaluations > 1000 && report.state === 'running' && paused === 0) {
      client.pause();
      paused = 1;
      setTimeout(() => client.resume(), 1200);
    }
  });
  const still = held.reports.filter((report) => report.state === 'paused');
  assert.ok(still.length >= 2);
  assert.ok(still[still.length - 1].evaluations - still[0].evaluations <= 2 * 160);
  assertSame(held, await run(document, 1));
});

test('stop ends the search early, with its best so far', async () => {
  const stopped = await run(problem({ evaluations: 1e6 }), 2, (client, report) => {
    if (report.evaluations > 500) client.stop();
  });
  assert.equal(stopped.last.state, 'stopped');
  assert.ok(stopped.genome.length > 0);
  assert.ok(stopped.last.evaluations < 1e6);
});

for (const [how, die] of /** @type {[string, (coordinator: NodeWorker) => void][]} */ ([
  ['hangs', () => {}],
  ['dies', (coordinator) => setTimeout(() => coordinator.onerror?.({ message: 'out of memory' }), 100)],
])) {
  test(`stop ends the search also when the coordinator ${how}`, async () => {
    let asked = false;
    let late = false;
    /** @type {ReturnType<typeof setTimeout> | undefined} */
    let deadline;
    /** @type {NodeWorker[]} */
    let workers = [];
    const stopped = await run(problem({ evaluations: 1e6 }), 2, (client, report, team) => {
      if (report.evaluations < 500 || asked) return;
      asked = true;
      deadline = setTimeout(() => { late = true; }, 4000); // of the event loop that stops the search: a busy machine delays both
      workers = team;
      team[0].onmessage = null;
      client.stop();
      die(team[0]);
    });
    assert.equal(stopped.last.state, 'stopped');
    clearTimeout(deadline);
    assert.equal(late, false);
    assert.ok(stopped.last.evaluations >= 500);
    assert.equal(engine.evaluator(problem({})).evaluate(stopped.genome)[0], stopped.last.bestFitness);
    assert.ok(stopped.last.curve?.length);
    await new Promise((resolve) => setTimeout(resolve, 200));
    assert.equal(workers.length, 3, 'nobody is hired for a search that is being stopped');
    assert.deepEqual(stopped.incidents, []);
  });
}

test('reports come at most 30 times a second, and the rate is about right', async () => {
  /** From the first evaluations on, because a busy machine takes long to start a worker. @type {{ms: number, evaluations: number}[]} */
  const seen = [];
  const { last } = await run(problem({ evaluations: 6000 }), 1, (_, { evaluations }) => {
    if (evaluations > 0) seen.push({ ms: performance.now(), evaluations });
  });
  const seconds = (performance.now() - seen[0].ms) / 1000;
  assert.ok(seen.length <= 30 * seconds + 2, `${seen.length} in ${seconds} s`);
  const rate = (6000 - seen[0].evaluations) / seconds;
  assert.ok(last.rate > 0.5 * rate && last.rate < 2 * rate, `${last.rate}/s, seen ${rate}/s`);
});

test('a damaged document is refused with one clear fault, not tried again and again', async () => {
  const document = problem({});
  document[10] ^= 4;
  await assert.rejects(run(document, 2), (error) => {
    const fault = /** @type {import('../../web/search/engine.js').EngineError} */ (error).fault;
    return fault.code === 'checksum' && fault.what.length > 0;
  });
});
