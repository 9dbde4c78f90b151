// SPDX-License-Identifier: MIT
// The tables of studies are those whose sums were noted when they were made.
import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';

const STUDIES = join(import.meta.dirname, '../../docs/studies');

test('studies: every table has the sum that was noted', () => {
  const noted = readdirSync(STUDIES).filter((name) => existsSync(join(STUDIES, name, 'sums.txt')));
  assert.ok(noted.length > 10, `${noted.length} studies have sums`);
  for (const name of noted) {
    const lines = readFileSync(join(STUDIES, name, 'sums.txt'), 'utf8').trimEnd().split('\n');
    for (const line of lines) {
      const [sum = '', file = ''] = line.split('  ');
      assert.equal(createHash('sha256').update(readFileSync(join(STUDIES, name, file))).digest('hex'), sum, `docs/studies/${name}/${file}`);
    }
    const tables = readdirSync(join(STUDIES, name), { recursive: true }).map(String).filter((file) => file.endsWith('.csv'));
    assert.equal(lines.length, tables.length, `docs/studies/${name}: a table has no sum, or a sum no table`);
  }
});
