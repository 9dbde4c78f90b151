// SPDX-License-Identifier: MIT
// docs/dependencies.md lists all installed npm packages with their versions and licences.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const ROOT = join(dirname(fileURLToPath(import.meta.url)), '../..');
const json = async (/** @type {string} */ file) => JSON.parse(await readFile(join(ROOT, 'web', file), 'utf8'));

test('dependencies: the page names every npm package with its version and licence', async () => {
  const text = await readFile(join(ROOT, 'docs/dependencies.md'), 'utf8');
  const [shipped, others] = text.split('## To build').map((part) => [...part.matchAll(/^\| `([^`]+)` \| ([^|]+) \| ([^|]+) \| npm/gm)]
    .map(([, name, version, licence]) => [name, version.trim(), licence.trim()]).sort());
  const { devDependencies, dependencies } = await json('package.json');
  for (const [documented, pinned] of [[shipped, dependencies], [others, devDependencies]]) {
    const real = await Promise.all(Object.keys(pinned).map(async (name) => {
      const { version, license } = await json(`node_modules/${name}/package.json`);
      assert.equal(version, pinned[name], `${name} is pinned`);
      return [name, version, license];
    }));
    assert.deepEqual(documented, real.sort());
  }
});

// So that `npm audit --omit=dev` checks exactly the shipped packages.
test('dependencies: what is shipped from npm brings nothing else along', async () => {
  const { packages } = await json('package-lock.json');
  const shipped = Object.entries(packages).filter(([folder, { dev }]) => folder !== '' && !dev).map(([folder]) => folder.slice('node_modules/'.length));
  assert.deepEqual(shipped.sort(), Object.keys(packages[''].dependencies).sort());
});
