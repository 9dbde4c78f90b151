// SPDX-License-Identifier: MIT
// Motions per second of one thread: Box2D, our native builds, our WASM under Node and in Chromium. Measured in short
// alternating rounds and by processor time, so that other load on the machine affects all of them equally. Claims (a)
// and (b) of docs/performance.md. Writes build/bench-rivals.json.
import { mkdirSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { ROOT, serve, startChromium, stopAll } from '../browser/browsers.mjs';
import { keep, median } from './machine.mjs';
import { NativeRounds } from './native_rounds.mjs';

const ROUNDS = 7;
const ROUND_MS = 250;
const WARM_UP_MS = 600; // the compiler's second pass has finished by then
const PEERS = ['peers', 'peers-limited']; // the second in model 2, its joints as strong as Box2D's motors
const WORKLOADS = [...PEERS, 'random', 'gait'];
const SITE = join(ROOT, 'build/site');
const FOLDER = join(ROOT, 'build/bench');

/** @typedef {{document: string, genomes: number[]}} Work */
/** @typedef {(workload: string, ms: number) => Promise<number>} Contestant  motions per second of processor time */

/**
 * In the page or under Node: runs the engine for about `ms`.
 * @param {string} engineAddress  engine.js
 * @param {Work} work @param {number} ms
 * @returns {Promise<number>} number of simulated motions
 */
async function evaluate(engineAddress, { document, genomes }, ms) {
  const { Engine } = /** @type {typeof import('../../web/search/engine.js')} */ (await import(engineAddress));
  const kept = /** @type {{benchEngine?: import('../../web/search/engine.js').Engine}} */ (globalThis);
  const engine = (kept.benchEngine ??= await Engine.load());
  const evaluator = engine.evaluator(engine.documentFromText(document));
  const batch = Uint16Array.from(genomes);
  let done = 0;
  for (const start = performance.now(); performance.now() - start < ms; done += batch.length / evaluator.genes) evaluator.evaluate(batch);
  evaluator.close();
  return done;
}

/** @param {() => number | Promise<number>} seconds  spent so far @param {() => Promise<number>} work  returns the number of motions */
async function perSecondOf(seconds, work) {
  const before = await seconds();
  const done = await work();
  return done / ((await seconds()) - before);
}
const nodeSeconds = () => (process.cpuUsage().user + process.cpuUsage().system) / 1e6;

/** @type {Record<string, Contestant>} */
const contestants = {};
/** @type {Record<string, object>} */
const about = {};
for (const build of ['release', 'release-clang']) {
  const native = NativeRounds.of(build);
  if (!native) continue;
  const { lanes, ...compiled } = JSON.parse(await native.ask('about'));
  const name = `native ${compiled.compiler.split(' ')[0].replace('GNU', 'gcc').toLowerCase()}`;
  about[name] = { ...compiled, lanes };
  contestants[name] = async (workload, ms) => Number(await native.ask(`${workload} ${lanes} ${ms}`));
  if (build === 'release') {
    mkdirSync(FOLDER, { recursive: true });
    await native.ask(`write ${FOLDER}`);
    contestants.box2d = async (workload, ms) => (PEERS.includes(workload) ? Number(await native.ask(`box2d ${workload} ${ms}`)) : 0);
  }
}

/** @type {Record<string, Work>} */
const works = {};
for (const name of WORKLOADS) {
  const genes = await readFile(join(FOLDER, `${name}.genes`));
  works[name] = {
    document: await readFile(join(FOLDER, `${name}.json`), 'utf8'),
    genomes: [...new Uint16Array(genes.buffer, genes.byteOffset, genes.length / 2)],
  };
}
const engineAddress = pathToFileURL(join(ROOT, 'build/wasm/web/search/engine.js')).href;
contestants['wasm node'] = (workload, ms) => perSecondOf(nodeSeconds, () => evaluate(engineAddress, works[workload], ms));

const browser = await startChromium();
if (browser) {
  const address = await serve(SITE);
  const page = await browser.newPage();
  await page.goto(`${address}an-empty-page`);
  const devtools = await page.createCDPSession();
  await devtools.send('Performance.enable');
  const threadSeconds = async () => {
    const { metrics } = await devtools.send('Performance.getMetrics');
    return metrics.find(({ name }) => name === 'ThreadTime')?.value ?? NaN;
  };
  contestants['wasm chromium'] = (workload, ms) =>
    perSecondOf(threadSeconds, () => page.evaluate(evaluate, `${address}search/engine.js`, works[workload], ms));
  about['wasm chromium'] = { version: await browser.version() };
}

/** @type {Record<string, Record<string, number[]>>} */
const rates = {};
for (const workload of WORKLOADS) {
  rates[workload] = Object.fromEntries(Object.keys(contestants).map((name) => [name, []]));
  for (const [name, contestant] of Object.entries(contestants)) await contestant(workload, name.startsWith('wasm') ? WARM_UP_MS : 1);
}
for (let round = 0; round < ROUNDS; round++) {
  for (const workload of WORKLOADS) {
    for (const [name, contestant] of Object.entries(contestants)) {
      const rate = await contestant(workload, ROUND_MS);
      if (rate > 0) rates[workload][name].push(rate);
    }
  }
}

/** @type {Record<string, Record<string, {median: number, best: number}>>} */
const perSecond = {};
for (const workload of WORKLOADS) {
  perSecond[workload] = {};
  for (const [name, values] of Object.entries(rates[workload])) {
    if (values.length) perSecond[workload][name] = { median: Math.round(median(values)), best: Math.round(Math.max(...values)) };
  }
}

/** Medians of the ratios of neighbouring rounds. @param {string} workload @param {string} one @param {string[]} others */
function ratio(workload, one, others) {
  const ours = rates[workload][one] ?? [];
  const theirs = others.map((name) => rates[workload][name] ?? []).filter((values) => values.length);
  if (!ours.length || !theirs.length) return null;
  return median(ours.map((rate, round) => rate / Math.max(...theirs.map((values) => values[round]))));
}

/** @param {string} workload */
const overBox2d = (workload) => Object.fromEntries([...natives, 'wasm node', 'wasm chromium'].map((name) => [name, ratio(workload, name, ['box2d'])]));
const natives = Object.keys(contestants).filter((name) => name.startsWith('native'));
await keep('rivals', {
  about,
  motionsPerSecond: perSecond,
  overBox2d: overBox2d('peers'),
  overBox2dLimited: overBox2d('peers-limited'),
  wasmOverFasterNative: Object.fromEntries(WORKLOADS.map((workload) => [workload, {
    node: ratio(workload, 'wasm node', natives),
    chromium: ratio(workload, 'wasm chromium', natives),
  }])),
});
await browser?.close();
stopAll();
process.exit(0); // the native programs end when their input ends
