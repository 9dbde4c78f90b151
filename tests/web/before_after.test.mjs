// SPDX-License-Identifier: MIT
// The questions before and after the lessons: their form, their results, and the numbers of the page about a study.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { test } from 'node:test';
import { counted, points, pupils, quizCsv } from '../../web/classroom/quiz_results.js';
import { QUESTIONS, SET } from '../../web/classroom/questions.js';
import { readLanguages } from '../../web/book/languages/words.mjs';
import { decodeWork, emptyWork, encodeWork, isWorkFile, readWorkFile, workFile } from '../../web/share/work.js';

const DOCS = join(import.meta.dirname, '../../docs');
const result = (/** @type {Partial<import('../../web/share/work.js').Work['quiz']>} */ quiz = {}) => ({ ...emptyWork(), name: 'K7', quiz: { set: SET, before: [0, 1, 4, null, 3, 2, 1, 0], after: null, ...quiz } });

/** A number from 0 to below 1, the same in every run. @param {number} seed */
const random = (seed) => () => {
  seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
  return seed / 2 ** 32;
};

test('quiz: eight questions with four different answers, whose right ones are not always in the same place', async () => {
  assert.equal(QUESTIONS.length, 8);
  for (const { code, tr } of await readLanguages(join(DOCS, '..'))) {
    const asked = QUESTIONS.map(({ question, answers, right, why }) => ({ question: tr(question), answers: answers.map((words) => tr(words)), right, why: tr(why) }));
    for (const { question, answers, right, why } of asked) {
      assert.ok(/[?]$/.test(question) && /[.]$/.test(why) && new Set(answers).size === 4 && answers[right], question);
      assert.ok(answers.every((words) => words.length < 2.6 * Math.min(...answers.map(({ length }) => length)) + 30), `lengths give it away: ${question}`);
    }
    const longest = asked.filter(({ answers, right }) => answers.every(({ length }) => length <= answers[right].length)).length;
    assert.ok(longest <= 4, `the longest answer is right ${longest} times (${code})`);
  }
  for (let place = 0; place < 4; place++) assert.equal(QUESTIONS.filter(({ right }) => right === place).length, 2, `place ${place}`);
});

test('quiz: a link and a file keep a result, and other work keeps its first form', () => {
  for (const quiz of [{}, { after: [2, 1, 3, 0, 2, 3, 1, 0] }, { before: null, after: [] }]) {
    const work = result(quiz), link = encodeWork(work);
    assert.match(link, /^H2\.\.[\w-]+$/);
    assert.deepEqual([decodeWork(link), readWorkFile(workFile(work))], [work, work]);
    assert.ok(isWorkFile(workFile(work)));
  }
  // A link that an earlier version made.
  assert.deepEqual(decodeWork('H1.AZ4x.eyJsZXNzb24iOiIxLWEtcnVsZSIsInByZWRpY3Rpb25zIjpbXSwiYW5zd2VycyI6WzFdLCJ0ZXh0IjoiIiwibmFtZSI6IkEifQ'),
    { ...emptyWork(), lesson: '1-a-rule', answers: [1], name: 'A', motion: 'AZ4x' });
  assert.equal(encodeWork({ ...emptyWork(), lesson: '1-a-rule', answers: [1], name: 'A', motion: 'AZ4x' }).slice(0, 8), 'H1.AZ4x.');
});

test('quiz: damaged and hostile results are refused with a sentence', () => {
  const packed = (/** @type {unknown} */ quiz, mark = 'H2') => {
    const { motion: _, quiz: __, ...parts } = emptyWork();
    return `${mark}..${Buffer.from(JSON.stringify({ ...parts, quiz })).toString('base64url')}`;
  };
  assert.ok(decodeWork(packed(result().quiz)));
  for (const bad of [undefined, null, 1, [], {}, { ...result().quiz, before: null }, result({ before: [0.5] }).quiz, result({ after: [-1] }).quiz, result({ after: [100] }).quiz, result({ before: Array(41).fill(0) }).quiz,
    { ...result().quiz, set: '<b>' }, { ...result().quiz, set: 1 }, { ...result().quiz, extra: 1 }, { ...result().quiz, before: '1' }, { ...result().quiz, before: { length: 8 } }]) {
    assert.throws(() => decodeWork(packed(bad)), /“quiz” is not the answers of a quiz/, JSON.stringify(bad));
  }
  assert.throws(() => decodeWork(packed(result().quiz, 'H1')), /not known here: “quiz”/);
  assert.throws(() => decodeWork(packed(result().quiz, 'H3')), /newer/);
  assert.throws(() => readWorkFile('{"gaitsmith_work": 2}'), /damaged/);
  const link = encodeWork(result({ after: [1, 2, 3, 0, 1, 2, 3, 4] })), next = random(11);
  for (let i = 0; i < 3000; i++) {
    const at = Math.floor(next() * link.length), letter = String.fromCharCode(32 + Math.floor(next() * 95));
    const damaged = next() < 0.3 ? link.slice(0, at) : link.slice(0, at) + letter + link.slice(at + 1);
    try {
      const read = decodeWork(damaged);
      assert.deepEqual(decodeWork(encodeWork(read)), read, damaged);
      assert.ok(pupils([{ name: read.name, quiz: /** @type {any} */ (read.quiz) }]).pupils.length === 1 && quizCsv(pupils([{ name: read.name, quiz: /** @type {any} */ (read.quiz) }]).pupils, QUESTIONS, SET));
    } catch (error) {
      assert.ok(error instanceof Error && error.name === 'Error' && /[.”]$/.test(error.message), `${damaged}: ${error}`);
    }
  }
});

test('quiz: rounds of one name are one student, and the same link does not count twice', () => {
  const all = QUESTIONS.map(({ right }) => right), none = QUESTIONS.map(() => 4);
  const quiz = (/** @type {number[] | null} */ before, /** @type {number[] | null} */ after) => ({ set: SET, before, after });
  const { pupils: found, repeated } = pupils([
    { name: 'K7', quiz: quiz(none, null) }, { name: '', quiz: quiz(none, all) }, { name: ' k7 ', quiz: quiz(null, all) }, { name: '', quiz: quiz(none, all) }, { name: '', quiz: quiz(none, null) }, { name: '', quiz: quiz(none, null) },
    { name: 'B', quiz: quiz(all, null) }, { name: 'b', quiz: quiz(none, null) },
  ]);
  assert.deepEqual(found, [{ name: 'K7', before: none, after: all }, { name: '', before: none, after: all }, { name: '', before: none, after: null }, { name: '', before: none, after: null }, { name: 'B', before: none, after: null }]);
  assert.equal(repeated, 2);
});

test('quiz: counts add up, for any class', () => {
  const next = random(5), round = () => (next() < 0.2 ? null : QUESTIONS.map(() => (next() < 0.1 ? null : Math.floor(next() * 5))));
  for (let i = 0; i < 200; i++) {
    const class_ = Array.from({ length: Math.floor(next() * 30) }, (_, k) => ({ name: `P${k}`, before: round(), after: round() }));
    for (const [k, { before, after, both, kept, gained, lost, neither }] of counted(class_, QUESTIONS).entries()) {
      assert.equal(kept + gained + lost + neither, both);
      for (const [name, counts] of /** @type {const} */ ([['before', before], ['after', after]])) {
        const given = class_.filter((pupil) => pupil[name]);
        assert.equal(counts.answered, given.length);
        assert.equal(counts.right, counts.choices[QUESTIONS[k].right]);
        assert.equal(counts.choices.reduce((sum, each) => sum + each, 0), given.filter((pupil) => pupil[name]?.[k] !== null).length);
      }
    }
    const sums = class_.map((pupil) => points(pupil.before, QUESTIONS) ?? 0);
    assert.equal(sums.reduce((sum, each) => sum + each, 0), counted(class_, QUESTIONS).reduce((sum, { before }) => sum + before.right, 0));
    assert.equal(quizCsv(class_, QUESTIONS, SET).trim().split('\r\n').length, class_.length + 1);
  }
  const lines = quizCsv([{ name: '=1+1', before: [2, 4, null, 9, 0, 1, 2, 3], after: null }], QUESTIONS, SET).split('\r\n');
  assert.match(lines[0], /^number,name,questions,before_1,.*,before_8,after_1,.*,after_8,before_right,after_right$/);
  assert.equal(lines[1], `1,'=1+1,${SET},c,?,,,a,b,c,d,,,,,,,,,1,`);
});

test('study: the numbers of pupils follow from the formula', async () => {
  const text = await readFile(join(DOCS, 'does-it-teach.md'), 'utf8');
  const [rho, m, icc] = [0.5, 25, 0.1];
  assert.match(text, /ρ = 0\.5, m = 25 and ICC = 0\.1/);
  const rows = [...text.matchAll(/^\| d = ([\d.]+) \| ([\d.]+) \| (\d+) \| (\d+) \| (\d+) \|$/gm)].map((row) => row.slice(1).map(Number));
  assert.equal(rows.length, 3);
  for (const [d, inPoints, alone, byClasses, classes] of rows) {
    const n = (2 * (1.96 + 0.842) ** 2 * (1 - rho ** 2)) / d ** 2, design = 1 + (m - 1) * icc;
    assert.deepEqual([inPoints, alone, byClasses, classes], [2 * d, Math.ceil(n), Math.ceil(n * design), Math.ceil((n * design) / m)].map((each) => Number(each.toFixed(6))), `d = ${d}`);
  }
  const ideas = [...text.matchAll(/^\| (\d) \| [^|]+ \| (\d) \|$/gm)].map(([, question, lesson]) => [Number(question), Number(lesson)]);
  assert.deepEqual(ideas, QUESTIONS.map(({ lesson }, i) => [i + 1, lesson]), 'each question has its lesson');
});
