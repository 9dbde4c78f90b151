// SPDX-License-Identifier: MIT
// Lessons that are written in the page: their files, and what the page inserts.
//
//   GAITSMITH_SITE=build/site node --test tests/web/new_lesson.test.mjs   also weighs the page
import assert from 'node:assert/strict';
import { readdir, readFile } from 'node:fs/promises';
import { join, resolve } from 'node:path';
import { test } from 'node:test';
import { gzipSync } from 'node:zlib';
import { Faults } from '../../web/book/faults.mjs';
import { goal, motion, motionLink, prediction, quiz } from '../../web/book/teaching/inserts.js';
import { fileOf, KEYS, lessonOf, lessonText } from '../../web/book/teaching/lesson_file.mjs';

const LESSONS = join(import.meta.dirname, '../../docs/lessons');
const SITE = process.env.GAITSMITH_SITE && resolve(process.env.GAITSMITH_SITE);
const MAX_GZIP = 120e3; // own scripts of the page

/** @param {string} text @param {string} [file] */
const read = (text, file = 'x.md') => {
  const faults = new Faults(), page = lessonOf(text, file, faults);
  return { fields: Object.fromEntries([...page.lesson.fields].map(([key, { value }]) => [key, value])), body: page.body, faults: faults.sentences, number: page.lesson.number };
};

/** A number from 0 to below 1, the same in every run. @param {number} seed */
const random = (seed) => () => {
  seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
  return seed / 2 ** 32;
};

test('new lesson: a file that was written is read as it was', () => {
  const next = random(3), letters = ['a', 'B', ' ', '"', ':', '#', '-', '---', 'ü', '\\', '\'', '`', '>', '[', '\t'];
  const words = () => Array.from({ length: Math.floor(next() * 9) }, () => letters[Math.floor(next() * letters.length)]).join('').replace(/\s+/g, ' ').trim();
  for (let i = 0; i < 2000; i++) {
    const fields = Object.fromEntries(KEYS.map((key) => [key, words()]).filter(([, value]) => value !== ''));
    const body = Array.from({ length: 5 }, words).join('\n').trimEnd();
    const again = read(lessonText(fields, body));
    assert.deepEqual([again.fields, again.body], [fields, `${body}\n`], JSON.stringify(fields));
  }
});

test('new lesson: every lesson of the book is written as it was read', async () => {
  for (const file of await readdir(LESSONS)) {
    const text = await readFile(join(LESSONS, file), 'utf8'), { fields, body, faults, number } = read(text, file);
    assert.deepEqual([faults, number > 0], [[], true], file);
    const again = read(lessonText(fields, body), file);
    assert.deepEqual([again.fields, again.body], [fields, `${body.trimEnd()}\n`], file);
  }
});

test('new lesson: what a file lacks has a line, and its name has a form', () => {
  assert.deepEqual(read('---\ntitle: A\nminutes: x\n---\n').faults, ['docs/lessons/x.md:1: a lesson needs "open:" between its --- lines', 'docs/lessons/x.md:3: "minutes" is a whole number']);
  assert.match(read('---\ntitle: A\nminutes: 5\nopen: a\n---\n', 'A B.md').faults[0], /:1: the name of a lesson's file/);
  assert.deepEqual(['Über "Straße" & Co.', '3 legs', '!!!', 'x'.repeat(90)].map(fileOf), ['uber-strasse-co.md', 'legs.md', 'lesson.md', `${'x'.repeat(60)}.md`]);
  for (const title of ['Why?', 'Øre', '−5', '  a  ']) assert.deepEqual(read(lessonText({ title, minutes: '5', open: 'a' }, ''), fileOf(title)).faults, [], title);
});

test('new lesson: links of the playground become links of the book, with the motion inside', () => {
  assert.equal(motionLink('https://example.org/g/?edit&lang=de&panels=style&goal=travel%3E%3D8#AZ4x-_9'), '../../web/index.html?panels=style&goal=travel%3E%3D8#AZ4x-_9');
  assert.equal(motionLink(' http://localhost:8080/index.html#AZ4 '), '../../web/index.html#AZ4');
  for (const none of ['', 'AZ4', 'https://example.org/', 'https://example.org/#', 'https://example.org/#a b', 'javascript:1#"><b>']) assert.equal(motionLink(none), '', none);
  const first = motion('Text\n', 'l', 'a [b]', false), second = motion(`Text\n\n${first.end}\n[motion-7]: x\n`, 'l', 'c', true);
  assert.deepEqual([first, second], [{ inserted: '[a b][motion-1]', end: '[motion-1]: l' }, { inserted: '![c][motion-8]', end: '[motion-8]: l' }]);
});

test('new lesson: inserted blocks have the form that the builder reads', () => {
  assert.equal(goal('distance >= 8', 'Go\n8 m.'), '\n```goal\ndistance >= 8\nGo 8 m.\n```\n');
  assert.equal(prediction('How far?', ['0 to 40 by 1 m']), '\n```predict\nHow far?\n0 to 40 by 1 m\n```\n');
  assert.equal(prediction('Who?', ['a', 'b']), '\n```predict\nWho?\n( ) a\n( ) b\n```\n');
  assert.equal(quiz('Why? ```', [{ answer: 'a | b', why: 'so', right: true }, { answer: 'c', why: 'no', right: false }]), '\n```quiz\nWhy?\n(x) a / b | so\n( ) c | no\n```\n');
});

test('new lesson: the page is light, and its licences are there', { skip: !SITE && 'no built site is given as GAITSMITH_SITE' }, async () => {
  const script = await readFile(join(/** @type {string} */ (SITE), 'book/new_lesson.js'));
  assert.ok(gzipSync(script).length <= MAX_GZIP, `${gzipSync(script).length} bytes`);
  const licences = await readFile(join(/** @type {string} */ (SITE), 'book/new_lesson.LICENSE.txt'), 'utf8');
  for (const name of ['entities', 'linkify-it', 'markdown-it', 'mdurl', 'punycode.js', 'uc.micro']) assert.match(licences, new RegExp(`^${name}\n\n`, 'm'));
});
