// SPDX-License-Identifier: MIT
// What docs/dependencies.md says of npm packages is what is installed: every one of them, its version, its licence.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const ROOT = join(dirname(fileURLToPath(import.meta.url)), '../..');
const json = async (/** @type {string} */ file) => JSON.parse(await readFile(join(ROOT, 'web', file), 'utf8'));

test('dependencies: the page names every npm package with its version and licence', async () => {
  const text = await readFile(join(ROOT, 'docs/dependencies.md'), 'utf8');
  const told = [...text.matchAll(/^\| `([^`]+)` \| ([^|]+) \| ([^|]+) \| npm/gm)].map(([, name, version, licence]) => [name, version.trim(), licence.trim()]);
  const { devDependencies, dependencies } = await json('package.json');
  assert.equal(dependencies, undefined);
  const real = await Promise.all(Object.keys(devDependencies).map(async (name) => {
    const { version, license } = await json(`node_modules/${name}/package.json`);
    assert.equal(version, devDependencies[name], `${name} is pinned`);
    return [name, version, license];
  }));
  assert.deepEqual(told.sort(), real.sort());
});
