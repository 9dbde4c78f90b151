// SPDX-License-Identifier: MIT
// The page's list of shipped documents is that of the folder.
import assert from 'node:assert/strict';
import { readFile, readdir } from 'node:fs/promises';
import { test } from 'node:test';
import { EXAMPLES } from '../../web/share/examples.js';

const folder = new URL('../../examples/', import.meta.url);
const INSIDE = 'star-man-shuffle'; // comes with the application

test('examples: the page offers every shipped document', async () => {
  const names = (await readdir(folder)).filter((name) => name.endsWith('.json')).map((name) => name.slice(0, -5));
  assert.ok(names.includes(INSIDE));
  assert.deepEqual(Object.keys(EXAMPLES).sort(), names.filter((name) => name !== INSIDE).sort());
  for (const name of names) JSON.parse(await readFile(new URL(`${name}.json`, folder), 'utf8'));
});
