// SPDX-License-Identifier: MIT
// The tables of shell/words/hints: the same controls in every language, and none that the sources do not have.
// The browsers' scenario "hints" checks that every control has a sentence.
import assert from 'node:assert/strict';
import { readdir, readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { before, test } from 'node:test';
import { fileURLToPath } from 'node:url';

const SHELL = fileURLToPath(new URL('../../shell/', import.meta.url));

/** @type {Map<string, Record<string, string>>} */
const tables = new Map();
let sources = '';

before(async () => {
  for (const file of await readdir(join(SHELL, 'words/hints'))) tables.set(file, JSON.parse(await readFile(join(SHELL, 'words/hints', file), 'utf8')));
  const files = (await readdir(SHELL, { recursive: true })).filter((file) => file.endsWith('.cpp'));
  sources = (await Promise.all(files.map((file) => readFile(join(SHELL, file), 'utf8')))).join('\n');
});

test('hints: every language of the canvas has the sentences of the same controls', async () => {
  const languages = await readdir(join(SHELL, 'words/languages'));
  assert.deepEqual([...tables.keys()].sort(), ['en.json', ...languages].sort());
  const english = tables.get('en.json') ?? {};
  for (const [file, table] of tables) {
    assert.deepEqual(Object.keys(table), Object.keys(english), file);
    for (const [id, sentence] of Object.entries(table)) {
      assert.match(sentence, /\.$/, `${file}, ${id}: a sentence ends with a full stop`);
      assert.deepEqual(sentence.match(/\{\d\}/g), english[id].match(/\{\d\}/g), `${file}, ${id}: the same places`);
    }
  }
});

test('hints: every sentence is of a control that exists', () => {
  const strange = Object.keys(tables.get('en.json') ?? {}).filter((family) => {
    const pieces = family.replace(/!$/, '').split('*').map((piece) => piece.replace(/\/\d*$/, '')).filter(Boolean);
    return !pieces.every((piece) => sources.includes(`"${piece}`) || sources.includes(`${piece}"`));
  });
  assert.deepEqual(strange, []);
});

test('hints: no family hides a later one', () => {
  const families = Object.keys(tables.get('en.json') ?? {});
  const hidden = families.filter((later, at) => families.slice(0, at).some((family) => {
    const [start, end] = family.split('*');
    return end !== undefined && later.endsWith('!') === family.endsWith('!') && later.length + 1 >= family.length && later.startsWith(start) && later.endsWith(end);
  }));
  assert.deepEqual(hidden, []);
});
