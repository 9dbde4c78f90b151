// SPDX-License-Identifier: MIT
// What students hand in, and how the wall judges it.
import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { decodeWork, emptyWork, encodeWork, isWorkFile, readWorkFile, workFile } from '../../web/share/work.js';
import { collect, fromFile } from '../../web/classroom/collected.js';
import { copies, csvOf, sorted } from '../../web/classroom/table.js';

const ROOT = join(import.meta.dirname, '../..');
const BUILT = process.cwd();

const work = () => ({ ...emptyWork(), lesson: '1-a-rule', predictions: [1, null, 12.5], answers: [0, null, 2], text: 'Über die Hüpfer: "zwei" Regeln\nreichen.', name: 'Zoë 🦘', motion: 'AZ4x-_9' });

/** A number from 0 to below 1, the same in every run. @param {number} seed */
const random = (seed) => () => {
  seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
  return seed / 2 ** 32;
};

test('a link and a file keep every part of a work', () => {
  assert.deepEqual(decodeWork(encodeWork(work())), work());
  assert.deepEqual(readWorkFile(workFile(work())), work());
  assert.ok(isWorkFile(workFile(work())) && !isWorkFile('{"gaitsmith": 1}'));
  assert.match(encodeWork(work()), /^[\w.-]+$/, 'no character that chat programs break a link at');
});

test('damaged, newer and hostile work is refused with a sentence', () => {
  const link = encodeWork(work()), [, motion, data] = link.split('.');
  const packed = (/** @type {unknown} */ value) => `H1.${motion}.${Buffer.from(JSON.stringify(value)).toString('base64url')}`;
  const { motion: _, quiz: __, ...parts } = work();
  for (const [bad, why] of /** @type {[string, RegExp][]} */ ([
    [`H3.${motion}.${data}`, /newer/], [`H1.${motion}`, /cut off/], [`${link}.x`, /cut off/], [`H1.${motion}.${data.slice(0, -5)}`, /damaged/],
    [`H1.a b.${data}`, /characters/], ['X', /not work/], [packed([]), /damaged/], [packed(null), /damaged/], [packed({ ...parts, extra: 1 }), /not known here: “extra”/],
    [packed({ ...parts, lesson: '../../x' }), /lesson/], [packed({ ...parts, answers: [0.5] }), /answers/], [packed({ ...parts, predictions: ['1'] }), /predictions/],
    [packed({ ...parts, text: 'x'.repeat(4001) }), /4000/], [packed({ ...parts, name: 1 }), /name/], [packed({ ...parts, answers: Array(41).fill(0) }), /answers/],
    [`H1..${'A'.repeat(40001)}`, /too long/], [`H1..${Buffer.from([0xff, 0xfe]).toString('base64url')}`, /damaged/],
  ])) assert.throws(() => decodeWork(bad), why, bad.slice(0, 60));
  assert.throws(() => readWorkFile('{"gaitsmith_work": 3}'), /newer/);
  assert.throws(() => readWorkFile('{"gaitsmith_work": 1, '), /damaged/);
});

test('no damage makes a work unreadable without a sentence', () => {
  const link = encodeWork(work()), next = random(7);
  for (let i = 0; i < 4000; i++) {
    const at = Math.floor(next() * link.length), letter = String.fromCharCode(32 + Math.floor(next() * 95));
    const bad = next() < 0.5 ? link.slice(0, at) : link.slice(0, at) + letter + link.slice(at + 1);
    try {
      const read = decodeWork(bad);
      assert.deepEqual(decodeWork(encodeWork(read)), read, bad);
    } catch (error) {
      assert.ok(error instanceof Error && /[.”]$/.test(error.message) && error.name === 'Error', `${bad}: ${error}`);
    }
  }
});

test('pasted text: names before links, several links on a line, and lines without a link', () => {
  const link = `https://example.org/g/book/wall.html#${encodeWork({ ...work(), name: '' })}`;
  const { entries, idle } = collect(`Dear Ms Smith,\n\nAnna: ${link}\nBen – https://example.org/g/#AZ4x.\n${link} ${link}\nhttps://example.org/g/\nhttps://example.org/#<script>`);
  assert.equal(idle, 1);
  assert.deepEqual(entries.map((entry) => (entry.fault === undefined ? entry.work.name : 'fault')), ['Anna', 'Ben', '', '', 'fault', 'fault']);
  assert.equal(/** @type {any} */ (entries[1]).work.motion, 'AZ4x', 'a full stop after a link is none of it');
  assert.equal(/** @type {any} */ (fromFile('hand-in.json', workFile(work()))[0]).work.name, 'Zoë 🦘');
  assert.match(fromFile('x.txt', 'nothing')[0].fault ?? '', /no link/);
  assert.equal(collect('x'.repeat(5_000_001)).entries.length, 1);
});

const row = (/** @type {object} */ parts) => /** @type {import('../../web/classroom/judge.js').Row} */ ({ name: '', lesson: '', fault: '', motion: null, link: '', conditions: [], met: null, changed: [], hash: '', predictions: [], answers: [], text: '', ...parts });

test('rows: their order, copies, and a table that no spreadsheet runs', () => {
  const rows = [row({ name: 'C', hash: 'a', met: false }), row({ name: 'A', hash: 'b', met: true }), row({ name: 'B', hash: 'a', met: null, fault: 'broken' })];
  const names = (/** @type {import('../../web/classroom/table.js').Order} */ order) => sorted(rows, order).map(({ name }) => name).join('');
  assert.deepEqual([names('arrival'), names('name'), names('goal')], ['CAB', 'ABC', 'ACB']);
  assert.deepEqual([...copies(rows)].map(([{ name }, earlier]) => [name, earlier]), [['B', 1]]);
  const csv = csvOf([row({ name: '=HYPERLINK("x")', text: 'a "b",\nc', answers: [{ question: 'q', given: '-1', right: true }], link: 'AZ' })], 'https://example.org/');
  assert.match(csv, /^number,name,/);
  assert.ok(csv.includes('"\'=HYPERLINK(""x"")"') && csv.includes('"a ""b"",\nc"') && csv.includes(',\'-1,yes,https://example.org/#AZ'), csv);
});

test('the judge simulates, compares with the goal and says what was changed', async () => {
  const at = (/** @type {string} */ path) => import(pathToFileURL(join(BUILT, path)).href);
  assert.ok(existsSync(join(BUILT, 'classroom/judge.js')), 'run in build/wasm/web');
  const [{ Engine }, tables, { Judge, figureOf, worldOf }] = await Promise.all([at('search/engine.js'), at('catalogue/catalogue.js'), at('classroom/judge.js')]);
  const engine = await Engine.load();
  const text = await readFile(join(ROOT, 'examples/gallery/kangaroo-hop.json'), 'utf8');
  const bytes = engine.documentFromText(text), json = engine.json(bytes);
  const facts = { name: '1-a-rule', title: '1. A rule', goals: ['rules <= 6, travel >= 20'], predictions: [{ question: 'How many?', answers: ['one', 'two'] }],
    quizzes: [{ question: 'Who?', answers: ['a', 'b'], right: 1 }], worlds: [worldOf(json)], figures: [figureOf(json)] };
  const judge = new Judge(engine, tables, [facts]);
  const sent = { ...emptyWork(), lesson: '1-a-rule', predictions: [1], answers: [1], text: '<b>x</b>', motion: engine.link(bytes) };
  const good = judge.judge({ work: sent, source: '' }, '');
  assert.equal(good.fault, '');
  assert.deepEqual([good.met, good.changed, good.predictions[0].given, good.answers[0]], [true, [], 'two', { question: 'Who?', given: 'b', right: true }]);
  assert.equal(good.hash, json.hash, 'the motion is simulated here, bit for bit');
  assert.match(good.conditions[1].text, /^travel 25\.\d+ \(≥ 20\)$/);
  // Tilted, pushed and with another figure
  const tilted = engine.documentFromText(JSON.stringify({ ...json, hash: undefined, environment: { ...json.environment, slope_rad: -0.1 }, pushes: [{ step: 100, endpoint: 0, impulse_x_ns: 1, impulse_y_ns: 0 }] }));
  const helped = judge.judge({ work: { ...sent, motion: engine.link(tilted) }, source: '' }, '');
  assert.deepEqual(helped.changed, ['slope -5.73°', '1 push']);
  const steps = engine.documentFromText(JSON.stringify({ ...json, hash: undefined, model: 2, environment: { ...json.environment, ground: [{ x_m: 2 }, { x_m: 2, y_m: 0.3 }] } }));
  assert.ok(judge.judge({ work: { ...sent, motion: engine.link(steps) }, source: '' }, '').changed.includes('drawn ground with 2 corners'));
  const other = engine.link(engine.documentFromText(await readFile(join(ROOT, 'examples/star-man-shuffle.json'), 'utf8')));
  assert.ok(judge.judge({ work: { ...sent, motion: other }, source: '' }, '').changed.includes('another figure'));
  // What a link cannot show is not held against anyone; what it shows is compared.
  const judgedBy = (/** @type {string} */ goal, /** @type {Uint8Array} */ motion) => judge.judge({ work: { ...emptyWork(), motion: engine.link(motion) }, source: '' }, goal);
  assert.deepEqual(judgedBy('controller = new, seed != 3, travel >= 20', bytes).conditions.map((/** @type {any} */ condition) => condition.met), [null, null, true]);
  assert.equal(judgedBy('controller = new', bytes).met, null);
  assert.deepEqual(judgedBy('pushes = 1, push_right >= 1, push_time = 1, world = usual', tilted).conditions.map((/** @type {any} */ condition) => condition.met), [true, true, true, false]);
  assert.equal(judgedBy('pushes = 0, world = usual', bytes).met, true);
  const thrown = engine.documentFromText(JSON.stringify({ ...json, hash: undefined, start: { ...json.start, velocity_x_mps: 20 } }));
  assert.equal(judgedBy('world = usual', thrown).met, false, 'a figure that is thrown has help');
  assert.deepEqual(judge.judge({ work: { ...sent, motion: engine.link(thrown) }, source: '' }, '').changed, ['velocity x 20']);
  const weak = { ...json, model: 2, hash: undefined, figure: { ...json.figure, rods: json.figure.rods.map((/** @type {any} */ rod) => ({ ...rod, strength: 3 })) } };
  const limited = engine.documentFromText(JSON.stringify(weak));
  assert.equal(judgedBy('world = usual', limited).met, false, 'limited joints are another world');
  assert.equal(judgedBy('world = earth', limited).met, true, 'but on earth');
  assert.equal(judgedBy('world = earth', thrown).met, false);
  assert.deepEqual(judge.judge({ work: { ...sent, motion: engine.link(limited) }, source: '' }, '').changed, ['joint strength 3']);
  const unlimited = engine.documentFromText(JSON.stringify({ ...weak, model: 1 }));
  assert.equal(judgedBy('world = usual', unlimited).met, true, 'a strength that nothing uses changes nothing');
  assert.equal(judgedBy('switch > 0', bytes).met, false, 'a motion of one clip has no switch');
  // A figure of springs: softer ones are another figure, and its joints have no strength.
  const table = engine.documentFromText(await readFile(join(ROOT, 'examples/gallery/table-trip.json'), 'utf8')), ofTable = engine.json(table);
  const springy = new Judge(engine, tables, [{ ...facts, worlds: [worldOf(ofTable)], figures: [figureOf(ofTable)] }]);
  const softer = engine.documentFromText(JSON.stringify({ ...ofTable, hash: undefined,
    figure: { ...ofTable.figure, springs: ofTable.figure.springs.map((/** @type {any} */ spring) => ({ ...spring, stiffness_npm: spring.stiffness_npm / 2 })) } }));
  const judged = (/** @type {Uint8Array} */ motion) => springy.judge({ work: { ...sent, motion: engine.link(motion) }, source: '' }, '');
  assert.deepEqual([judged(table).fault, judged(table).changed, judged(table).hash], ['', [], ofTable.hash]);
  assert.deepEqual(judged(softer).changed, ['another figure']);
  assert.equal(judgedBy('world = usual', table).met, true);
  // Without a lesson the goal is the teacher's.
  const free = judge.judge({ work: { ...emptyWork(), motion: other }, source: '' }, 'distance >= 1000');
  assert.deepEqual([free.met, free.changed], [false, []]);
  assert.match(judge.judge({ work: { ...sent, motion: 'AZ4broken' }, source: '' }, '').fault, /\S/);
  assert.equal(judge.judge({ work: { ...sent, motion: '' }, source: '' }, '').met, null, 'answers without a motion are a row, too');
  assert.equal(judge.judge({ work: { ...sent, lesson: 'unknown' }, source: '' }, '').lesson, 'unknown');
});
