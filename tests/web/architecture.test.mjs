// SPDX-License-Identifier: MIT
// Every file and folder that docs/architecture.md, CONTRIBUTING.md and README.md name exists.
import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const ROOT = join(dirname(fileURLToPath(import.meta.url)), '../..');

/** Paths of the repository in code spans and links. @param {string} text @returns {string[]} */
function pathsIn(text) {
  const prose = text.replace(/^```.*?^```/gms, '');
  const spans = [...prose.matchAll(/`([^`\n]+)`/g), ...prose.matchAll(/\]\((?!https?:|\.\.\/\.\.\/|#)([^)#\s]+)/g)].map(([, path]) => path);
  return spans.filter((path) => /^\.?[a-z_]+\/[\w./-]*$|^[A-Z_]+\.md$|^LICENSE$/.test(path));
}

test('architecture: each recipe says how many files it takes', async () => {
  const text = await readFile(join(ROOT, 'docs/architecture.md'), 'utf8');
  const rows = text.slice(text.indexOf('## Recipes')).match(/^\| (?!you add|---).*$/gm) ?? [];
  assert.ok(rows.length >= 8, `only ${rows.length} rows found`);
  assert.deepEqual(rows.filter((row) => !/^\|[^|]+\| \d+ \|/.test(row)), []);
});

for (const [page, min] of /** @type {const} */ ([['docs/architecture.md', 40], ['CONTRIBUTING.md', 5], ['README.md', 8]])) {
  test(`architecture: ${page} names only what is there`, async () => {
    const paths = pathsIn(await readFile(join(ROOT, page), 'utf8'));
    assert.ok(paths.length >= min, `only ${paths.length} paths found`);
    // Built files are not in the repository.
    const missing = paths.filter((path) => !path.startsWith('build/') && !existsSync(join(ROOT, path)) && !existsSync(join(ROOT, 'docs', path)));
    assert.deepEqual(missing, []);
  });
}
