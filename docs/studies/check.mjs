// SPDX-License-Identifier: MIT
// Computes rows of a study again and compares every byte:  node docs/studies/check.mjs NAME build/release/shell/gaitsmith [seed]
// The study is copied, three rows are taken out of each of its tables, or of ten of them, and its own resumable command makes them again. Which rows is decided by the
// seed, which is printed. The files' sums (sums.txt) are compared first.
import { spawnSync } from 'node:child_process';
import { createHash, randomInt } from 'node:crypto';
import { cpSync, existsSync, mkdirSync, readFileSync, readdirSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { join, relative, resolve } from 'node:path';

const MOST_TABLES = 10;
const [name = '', program = '', given] = process.argv.slice(2);
const studies = import.meta.dirname, root = join(studies, '../..'), study = join(studies, name);
/** @param {string} what @returns {never} */
function fail(what) {
  console.error(`${name}: ${what}`);
  process.exit(1);
}
if (!/^[a-z-]+$/.test(name) || !existsSync(study)) fail('there is no such study in docs/studies');
/** All files below a folder, by their paths in it. @param {string} folder @returns {string[]} */
const filesIn = (folder) => readdirSync(folder, { recursive: true, withFileTypes: true }).filter((entry) => entry.isFile())
  .map((entry) => relative(folder, join(entry.parentPath ?? entry.path, entry.name))).sort();
const tables = filesIn(study).filter((file) => file.endsWith('.csv'));
const sums = tables.map((file) => `${createHash('sha256').update(readFileSync(join(study, file))).digest('hex')}  ${file}\n`).join('');
const noted = join(study, 'sums.txt');
if (given === '--sums') {
  writeFileSync(noted, sums);
  process.exit(0);
}
if (!existsSync(noted)) fail('has no sums.txt; ./dev study NAME --sums writes it');
if (readFileSync(noted, 'utf8') !== sums) fail('its tables are not those of sums.txt');

const command = ['run', 'run.mjs'].find((each) => existsSync(join(study, each)));
if (!command) fail('has no command "run", so its rows cannot be made again one by one');
const text = readFileSync(join(study, command), 'utf8');
if (!/resumable/i.test(text.slice(0, 600))) fail(`its command does not go on where it ended; run it as a whole: docs/studies/${name}/${command}`);

// The same numbers for the same seed.
let state = Number(given ?? randomInt(1, 2 ** 31));
const seed = state;
const below = (/** @type {number} */ bound) => (state = (state * 48271) % 2147483647) % bound;

const place = join(root, 'build/study-check');
rmSync(place, { recursive: true, force: true });
mkdirSync(join(place, 'docs/studies'), { recursive: true });
for (const entry of readdirSync(root)) if (!['docs', 'build'].includes(entry)) symlinkSync(join(root, entry), join(place, entry));
for (const entry of readdirSync(join(root, 'docs'))) if (entry !== 'studies') symlinkSync(join(root, 'docs', entry), join(place, 'docs', entry));
for (const entry of readdirSync(studies)) if (entry !== name) symlinkSync(join(studies, entry), join(place, 'docs/studies', entry));
const copy = join(place, 'docs/studies', name);
cpSync(study, copy, { recursive: true });

let taken = 0;
const chosen = tables.filter((file) => !file.includes('curves/')); // curves belong to the tables of results
while (chosen.length > MOST_TABLES) chosen.splice(below(chosen.length), 1);
for (const file of chosen) {
  const lines = readFileSync(join(copy, file), 'utf8').split('\n');
  const last = lines.pop(); // what follows the last line's end
  const first = lines.findIndex((line) => !line.startsWith('#')) + 1; // after the names of the columns
  if (lines[0]?.startsWith('# gaitsmith') && spawnSync(program, ['merge', '--complete', '--out', '/dev/null', join(copy, file)]).status !== 0)
    fail(`${file} is not complete, so its command would go on with the rest`);
  for (let i = 0; i < 3 && lines.length > first; i++, taken++) lines.splice(first + below(lines.length - first), 1);
  writeFileSync(join(copy, file), [...lines, last].join('\n'));
}
console.log(`${name}: ${taken} rows of ${chosen.length} tables are made again (seed ${seed})`);
const run = command === 'run' ? [join(copy, 'run')] : [process.execPath, join(copy, command)];
const done = spawnSync(run[0] ?? '', [...run.slice(1), resolve(program)], { cwd: place, stdio: ['ignore', 'ignore', 'inherit'] });
if (done.status !== 0) fail(`its command ends with ${done.status}`);
const sorted = (/** @type {string} */ path) => readFileSync(path, 'utf8').split('\n').sort().join('\n');
const lines = (/** @type {string} */ path) => readFileSync(path, 'utf8').split('\n').length;
if (chosen.some((file) => lines(join(study, file)) !== lines(join(copy, file)))) fail('its command did not make the rows again: it goes on by whole tables. Run it as a whole');
const other = tables.filter((file) => sorted(join(study, file)) !== sorted(join(copy, file)));
if (other.length) fail(`other bytes in ${other.join(', ')}; compare docs/studies/${name} with build/study-check/docs/studies/${name}`);
console.log(`${name}: the same bytes`);
rmSync(place, { recursive: true, force: true });
