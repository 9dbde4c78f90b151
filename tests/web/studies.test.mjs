// SPDX-License-Identifier: MIT
// The check of studies (docs/studies/check.mjs), on a made-up study with a table for each word of a check.json. CTest runs
// it on the real ones.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { chmodSync, cpSync, existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';

const CHECK = join(import.meta.dirname, '../../docs/studies/check.mjs');
const PROGRAM = process.execPath; // any program: this study only passes it on

/** Makes rows that are missing, as resumable commands do. `wrong` makes another row. @param {string} wrong */
const command = (wrong) => `#!/usr/bin/env bash
set -euo pipefail
cd "$(dirname "$0")"
[ -x "$1" ] || exit 3
row() { grep -q "^$2," "$1" || echo "$2,\${3:-$(($2 * $2))}" >>"$1"; }
for i in 1 2 3 4 5 6; do row rows.csv $i; done
if ! grep -q '^a,' groups.csv; then printf 'a,1,1\\na,2,4\\n' >>groups.csv; echo a,9 >>ends.csv; fi
if ! grep -q '^b,' groups.csv; then printf 'b,1,2\\nb,2,5\\n' >>groups.csv; echo b,8 >>ends.csv; fi
printf 'n,seconds\\n1,%s\\n' "$RANDOM" >timed.csv
printf 'n\\n2\\n1\\n' >whole.csv
${wrong}
`;
const OTHER = `#!/usr/bin/env bash
[ "$2" = twice ] || exit 5
[ -e "$(dirname "$0")/whole.csv" ] || exit 6 # of a pattern before this one's
printf 'n\\n7\\n' >"$(dirname "$0")/other.csv"
`;
const PLAN = { tables: {
  '^groups': { by: ['part'], also: ['ends.csv'], where: { n: '1' } }, '^ends': { kept: true }, '^timed': { whole: true, unlike: ['seconds'] },
  '^whole': { whole: true, most: 1 }, '^other': { whole: true, command: 'other {gaitsmith} twice' } } };
const TABLES = { 'rows.csv': 'n,square\n1,1\n2,4\n3,9\n4,16\n5,25\n6,36\n', 'groups.csv': 'part,n,value\na,1,1\na,2,4\nb,1,2\nb,2,5\n',
  'ends.csv': 'part,end\na,9\nb,8\n', 'timed.csv': 'n,seconds\n1,77\n', 'whole.csv': 'n\n2\n1\n', 'other.csv': 'n\n7\n' };

/** @param {{wrong?: string, plan?: object, tables?: Record<string, string>}} [made] */
function study({ wrong = '', plan = PLAN, tables = TABLES } = {}) {
  const root = mkdtempSync(join(tmpdir(), 'study-')), folder = join(root, 'docs/studies/made-up');
  mkdirSync(folder, { recursive: true });
  cpSync(CHECK, join(root, 'docs/studies/check.mjs'));
  for (const [name, text] of Object.entries({ ...tables, 'question.md': '# ?\n', 'check.json': JSON.stringify(plan), run: command(wrong), other: OTHER,
    '.gitignore': 'raw.csv\n', 'raw.csv': 'not data\n' })) writeFileSync(join(folder, name), text);
  for (const name of ['run', 'other']) chmodSync(join(folder, name), 0o755);
  const check = (/** @type {string[]} */ ...words) => {
    const { status, stdout, stderr } = spawnSync(process.execPath, [join(root, 'docs/studies/check.mjs'), ...words], { encoding: 'utf8' });
    return { status, said: stdout + stderr };
  };
  return { folder, check, sums: () => check('made-up', '--sums'), end: () => rmSync(root, { recursive: true }), copy: join(root, 'build/study-check/made-up') };
}

test('studies: rows, groups, whole files and other commands are made again, for any seed', () => {
  const { check, sums, end, copy, folder } = study();
  sums();
  assert.equal(readFileSync(join(folder, 'sums.txt'), 'utf8').trim().split('\n').length, 6);
  for (const seed of ['1', '2', '3', '44', '999999999']) {
    const { status, said } = check('made-up', PROGRAM, seed);
    assert.equal(status, 0, said);
    for (const words of ['3 rows of rows.csv', /[ab] of groups.csv, ends.csv/, 'all of whole.csv', 'all of other.csv', 'all of timed.csv', 'the same bytes'])
      assert.match(said, new RegExp(words));
  }
  assert.ok(!existsSync(copy), 'the copy goes');
  assert.equal(check('made-up', PROGRAM, '5').said, check('made-up', PROGRAM, '5').said);
  assert.equal(check('--all').status, 0);
  assert.match(check().said, /made-up: 6 tables/);
  end();
});

test('studies: what comes out otherwise is noticed', () => {
  for (const [wrong, words] of [
    ['sed -i \'s/^[1-6],.*/1,2/\' rows.csv', 'other bytes in rows.csv'],
    ['echo 7,49 >>rows.csv', 'other bytes in rows.csv'],
    ['sed -i \'s/^a,1,1$/a,1,3/; s/^b,1,2$/b,1,3/\' groups.csv', 'other bytes in groups.csv'],
    ['sed -i \'s/,[89]$/,7/\' ends.csv', 'other bytes in ends.csv'],
    ['printf \'n\\n1\\n2\\n\' >whole.csv', 'other bytes in whole.csv'],
    ['sed -i \'s/^1,/2,/\' timed.csv', 'other bytes in timed.csv'],
    ['rm timed.csv', 'not made again: timed.csv'],
    ['exit 4', 'run ends with 4'],
  ]) {
    const { check, sums, end } = study({ wrong });
    sums();
    const { status, said } = check('made-up', PROGRAM, '1');
    assert.equal(status, 1, `${wrong}: ${said}`);
    assert.ok(said.includes(words ?? ''), `${wrong}: ${said}`);
    end();
  }
});

test('studies: what is wrong with a folder, or with what was typed, is said', () => {
  const { folder, check, sums, end } = study();
  assert.match(check('--all').said, /made-up has no sums.txt/);
  sums();
  for (const [words, said] of /** @type {[string[], RegExp][]} */ ([[['made-up'], /'' is no program/], [['made-up', '/nowhere', '1'], /'\/nowhere' is no program/],
    [['made-up', tmpdir()], /is no program/], [['made-up', PROGRAM, 'abc'], /'abc' is no seed/], [['made-up', PROGRAM, '0'], /'0' is no seed/], [['another', PROGRAM], /no study 'another'/]]))
    assert.match(check(...words).said, said);
  writeFileSync(join(folder, 'rows.csv'), 'n,square\n');
  for (const words of [['--all'], ['made-up', PROGRAM]]) assert.match(check(...words).said, /made-up has other data than sums.txt says/);
  end();
  for (const [plan, said] of /** @type {[object, RegExp][]} */ ([[{ tables: { '^rows': { hole: true } } }, /unknown word in check.json: 'hole'/],
    [{ tables: { '^gone': { whole: true } } }, /no file for '\^gone'/], [{ log: 'of nothing' }, /^$/]])) {
    const other = study({ plan });
    other.sums();
    assert.match(other.check('--all').said, said);
    if ('log' in plan) assert.match(other.check('made-up', PROGRAM).said, /made-up is a log: of nothing/);
    other.end();
  }
});
