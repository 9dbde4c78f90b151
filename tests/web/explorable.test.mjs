// SPDX-License-Identifier: MIT
// Every number that "How things learn to move" states, by the small engine that its stages use.
import assert from 'node:assert/strict';
import { readFile, readdir } from 'node:fs/promises';
import { join } from 'node:path';
import { before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { Climb, measured, random, searched, withGravity, withLength, withPush, withRules, withSlope, withTau } from '../../web/explorable/changes.js';

const ROOT = join(import.meta.dirname, '../..');
const at = (/** @type {string} */ path) => import(pathToFileURL(join(process.cwd(), path)).href); // run in build/wasm/web

/** @type {import('../../web/search/engine.js').Engine} */
let engine;
let text = '';
before(async () => {
  const [{ Engine }, { default: create }] = await Promise.all([at('search/engine.js'), at('search/small_engine_module.js')]);
  engine = await Engine.load(undefined, create);
  text = await readFile(join(ROOT, 'docs/how-things-learn-to-move.md'), 'utf8');
});

/** @param {string} name @returns {Promise<any>} */
const example = async (name) => engine.json(engine.documentFromText(await readFile(join(ROOT, `examples/${name}.json`), 'utf8')));
/** @param {any} document  JSON or bytes @param {string} [term] */
function measure(document, term = 'travel') {
  const motion = engine.motion(document instanceof Uint8Array ? document : engine.documentFromText(JSON.stringify(document)));
  const value = term === 'hash' ? motion.measures().hash : measured(motion, term);
  motion.close();
  return /** @type {any} */ (value);
}
/** @param {any} json */
function found(json) {
  const climb = new Climb(engine, json);
  while (!climb.done) climb.step();
  const best = /** @type {Uint8Array} */ (climb.best());
  climb.close();
  return { best, score: climb.history.at(-1)?.score ?? NaN, climb };
}
/** @param {any} json @param {string} algorithm */
const searchedDocument = (json, algorithm) => engine.documentFromText(JSON.stringify(searched(json, { algorithm, seed: 1, evaluations: 300 })));
/** @param {string[]} sentences */
const states = (...sentences) => { for (const sentence of sentences) assert.ok(text.includes(sentence), `the text does not say: ${sentence}`); };
const metres = (/** @type {number} */ value, places = 1) => `${value.toFixed(places)} m`;

test('the small engine moves the gallery’s figures bit for bit as the others do', async () => {
  const names = (await readdir(join(ROOT, 'examples/gallery'))).filter((name) => name.endsWith('.json'));
  assert.ok(names.length > 10);
  let others = 0;
  for (const name of names) {
    const text = await readFile(join(ROOT, 'examples/gallery', name), 'utf8');
    // It has only the first model.
    if (JSON.parse(text).model > 1) {
      assert.throws(() => engine.documentFromText(text), /needs physical model \d, but this Gaitsmith has models up to 1/);
      others++;
      continue;
    }
    const json = await example(`gallery/${name.slice(0, -'.json'.length)}`);
    assert.equal(measure(json, 'hash'), json.hash, name);
  }
  assert.ok(others < names.length / 4);
});

test('the small engine names the searches that it leaves out', async () => {
  const kangaroo = await example('gallery/kangaroo-hop');
  for (const algorithm of ['rgt', 'sphc', 'shc', 'pose-cycle']) engine.search(searchedDocument(kangaroo, algorithm)).close();
  for (const algorithm of ['ssga', 'cma-es', 'map-elites']) {
    assert.throws(() => engine.search(searchedDocument(kangaroo, algorithm)), /search\.algorithm: is not in this page/);
  }
});

test('a kangaroo needs two of six rules, and its kick must be quick', async () => {
  const kangaroo = await example('gallery/kangaroo-hop');
  assert.equal(kangaroo.controllers[0].rules.length, 6);
  assert.equal(kangaroo.figure.rods.length, 8);
  states(`This kangaroo hops ${metres(measure(kangaroo))} in ${kangaroo.duration_steps / 100} s.`, 'eight stiff rods', 'Rules 2, 4, 5 and 6 can go', 'below 1 m');
  assert.equal(measure(withRules(kangaroo, [0, 2]), 'hash'), measure(kangaroo, 'hash'));
  for (const needed of [[0], [2]]) assert.notEqual(measure(withRules(kangaroo, needed), 'hash'), measure(kangaroo, 'hash'));
  const two = withRules(kangaroo, [0, 2]);
  const [quick, slower, slowest] = [0, 2000, 65535].map((gene) => measure(withTau(two, 1, gene)));
  assert.ok(slower < quick && slower > 0.8 * quick && slowest < 1, `${[quick, slower, slowest]}`);
});

test('rules are good for the world in which they were found', async () => {
  const kangaroo = await example('gallery/kangaroo-hop');
  states(`at 15 m/s², half as much again as on Earth, it still gets ${metres(measure(withGravity(kangaroo, 15)), 0)}`, 'at 8 m/s² it gets less than 3 m');
  assert.ok(measure(withGravity(kangaroo, 8)) < 3);
  const senses = withPush(await example('lessons/3-senses-pushed'), 0, 0);
  states(`Up a slope of 10° these legs get ${metres(measure(withSlope(senses, 10)))}`);
});

test('guessing, climbing, and the wrong hill', async () => {
  const horse = await example('lessons/2-stuck-horse');
  const guesses = Array.from({ length: 100 }, (_, i) => measure(random(engine, horse, i + 1)));
  assert.equal(guesses.filter((far) => far > 1).length, 7);
  states('Seven of them get further than 1 m', `the best gets ${metres(Math.max(...guesses))}`, 'hundreds of numbers');
  const [third, sixth] = [3, 6].map((seed) => found(searched(horse, { algorithm: 'shc', seed, evaluations: 4000 })));
  assert.ok(third.climb.search.genes >= 200 && third.climb.search.genes < 1000, `${third.climb.search.genes} numbers`);
  states(`In the end it gallops ${metres(measure(third.best), 0)}`, `With seed 3 the horse gets ${metres(measure(third.best), 0)}, with seed 6 only ${metres(measure(sixth.best))}`);
  assert.equal(Math.fround(measure(third.best)), third.score, 'the motion that is shown is the one that was scored');
  const scores = third.climb.history.map(({ score }) => score);
  assert.ok(scores.length > 20 && scores.every((score, i) => i === 0 || score > scores[i - 1]));
});

test('a population is more reliable than one climber', async () => {
  const hopper = await example('lessons/5-stuck-hopper');
  assert.equal(hopper.search.population, 10);
  const heights = (/** @type {string} */ algorithm) => [1, 2, 3, 4, 5].map((seed) => found(searched(hopper, { algorithm, seed, evaluations: 5000 })).score);
  const one = heights('shc'), many = heights('sphc');
  states(`with seeds 1 to 3 it jumps ${Math.min(...one.slice(0, 3)).toFixed(1)} to ${metres(Math.max(...one))}`,
    `with seeds 4 and 5 it does not get off the ground, ${metres(Math.max(...one.slice(3)))}`, `The population always gets at least ${metres(Math.min(...many))}`);
});

test('what is paid for is found', async () => {
  const star = await example('lessons/4-no-style');
  const [free, paid] = [0, 10].map((rotations) => found(searched(star, { algorithm: 'pose-cycle', seed: 1, evaluations: 3000, weights: { rotations } })).best);
  states(`For nothing it runs ${metres(measure(free, 'distance'), 0)} and does not turn at all`, 'it gets half as far, and turns over twice');
  assert.ok(measure(free, 'rotations') < 0.2 && Math.round(measure(paid, 'rotations')) === 2);
  assert.ok(Math.abs(measure(paid, 'distance') / measure(free, 'distance') - 0.5) < 0.05);
});

test('pushes: a clock is lucky, senses catch themselves', async () => {
  const [timer, senses] = await Promise.all(['3-clock-pushed', '3-senses-pushed'].map((name) => example(`lessons/${name}`)));
  const pushed = (/** @type {any} */ json, /** @type {number} */ seconds) => measure(withPush(json, seconds, -10));
  states(`They walk well, ${metres(measure(withPush(timer, 0, 0)), 0)}`, `Pushed at 3.0 s they fall, and end at ${metres(pushed(timer, 3), 0)}. Pushed at 3.2 s they get ${metres(pushed(timer, 3.2))}`,
    'from 3.0 to 3.9 s', 'more than 31 m');
  for (let tenth = 30; tenth <= 39; tenth++) assert.ok(pushed(senses, tenth / 10) > 31, `${tenth}`);
});

test('one’s own body finds a motion', async () => {
  const hopper = await example('lessons/5-stuck-hopper');
  for (const length of [0.3, 0.6, 1.1]) {
    const { best } = found(searched(withLength(hopper, 2, length), { algorithm: 'pose-cycle', seed: 1, evaluations: 800, task: { kind: 'travel-right', duration_steps: 500 } }));
    assert.ok(measure(best) > 1, `a foot of ${length} m: ${measure(best)} m`);
  }
});
