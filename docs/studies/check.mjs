// SPDX-License-Identifier: MIT
// Are a study's data what was found, and do they come out again?
//   node docs/studies/check.mjs                                                the folders, and how each is made again
//   node docs/studies/check.mjs NAME --sums                                    notes the sums of its data, in sums.txt
//   node docs/studies/check.mjs --all                                          every folder's sums, and what belongs into each
//   node docs/studies/check.mjs NAME build/release/shell/gaitsmith [seed]      makes rows again and compares every byte
// The study is copied, three rows are taken out of each of its tables, or of ten of them, and its own resumable command makes
// them again. Which rows is decided by the seed, which is printed. A folder's check.json says what is different there:
//   {"log": "why nothing here is made again"}, or {"tables": {PATTERN: HOW, …}}, of which the first that fits a file's name counts:
//   "command"  what makes it, from the folder: words, with {gaitsmith} and {box2d} for programs. Else run or run.mjs
//   "by"       columns: one row is drawn, and all that are the same in these go, because they are made together
//   "also"     tables of which the same rows go
//   "whole"    the file goes, and all of it is made again. "most": of so many files of this pattern, else as of others
//   "times"    columns that no run repeats, which are not compared
//   "kept"     the table is made with others: nothing is taken out of it, but it is compared
import { spawnSync } from 'node:child_process';
import { createHash, randomInt } from 'node:crypto';
import { cpSync, existsSync, mkdirSync, readFileSync, readdirSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { join, relative, resolve } from 'node:path';

/** @typedef {{command?: string, by?: string[], also?: string[], whole?: boolean, most?: number, times?: string[], kept?: boolean}} How */
/** @typedef {{log?: string, tables?: Record<string, How>}} Plan */
const MOST_TABLES = 10, ROWS = 3;
const studies = import.meta.dirname, root = join(studies, '../..');
/** @param {string} what @returns {never} */
function fail(what) {
  console.error(what);
  process.exit(1);
}
/** All files below a folder, by their paths in it. @param {string} folder @returns {string[]} */
const filesIn = (folder) => readdirSync(folder, { recursive: true, withFileTypes: true }).filter((entry) => entry.isFile())
  .map((entry) => relative(folder, join(entry.parentPath ?? entry.path, entry.name))).sort();
const names = readdirSync(studies, { withFileTypes: true }).filter((entry) => entry.isDirectory()).map((entry) => entry.name).sort();
const has = (/** @type {string} */ name, /** @type {string} */ file) => existsSync(join(studies, name, file));
/** @param {string} name @returns {Plan} */
const planOf = (name) => (has(name, 'check.json') ? JSON.parse(readFileSync(join(studies, name, 'check.json'), 'utf8')) : {});
/** A study's data. @param {string} name */
const dataOf = (name) => filesIn(join(studies, name)).filter((file) => /\.(csv|json)$/.test(file) && file !== 'check.json');
/** @param {string} name */
const sumsOf = (name) => dataOf(name).map((file) => `${createHash('sha256').update(readFileSync(join(studies, name, file))).digest('hex')}  ${file}\n`).join('');
/** @param {string} name */
const commandOf = (name) => ['run', 'run.mjs'].find((each) => has(name, each));

/** What a folder lacks, or ''. @param {string} name */
function lacks(name) {
  if (planOf(name).log) return '';
  if (!has(name, 'question.md')) return 'has no question.md';
  if (!has(name, 'sums.txt')) return `has no sums.txt; ./dev study ${name} --sums writes it`;
  if (readFileSync(join(studies, name, 'sums.txt'), 'utf8') !== sumsOf(name)) return 'has other data than sums.txt says';
  return commandOf(name) || dataOf(name).every((file) => howOf(name)(file).command) ? '' : 'has no command "run"';
}

/** How each table of a study is made again: of the first pattern that fits. @param {string} name @returns {(file: string) => How} */
function howOf(name) {
  const ways = Object.entries(planOf(name).tables ?? {}).map(([pattern, how]) => ({ fits: new RegExp(pattern), how }));
  return (file) => ways.find(({ fits }) => fits.test(file))?.how ?? (/(^|\/)curves\/|\.json$/.test(file) ? { kept: true } : {}); // curves are made with their results
}

/** A table as text before its rows, names of columns, rows. @param {string} path */
function read(path) {
  const lines = readFileSync(path, 'utf8').trimEnd().split('\n');
  const head = lines.findIndex((line) => !line.startsWith('#'));
  const columns = (lines[head] ?? '').split(',');
  /** What a row has in these columns. @param {string} row @param {string[]} of */
  const cells = (row, of) => of.map((column) => row.split(',')[columns.indexOf(column)]).join(',');
  return { above: lines.slice(0, head + 1), columns, rows: lines.slice(head + 1), cells };
}
/** A file's lines in an order of their own, without what no run repeats. @param {string} path @param {How} how */
function lasting(path, { times = [] }) {
  if (!path.endsWith('.csv')) return readFileSync(path, 'utf8');
  const { above, columns, rows, cells } = read(path);
  const kept = columns.filter((column) => !times.includes(column));
  return [...above, ...rows.map((row) => (times.length ? cells(row, kept) : row)).sort()].join('\n');
}

/** @param {string} name @param {string} program @param {number} seed */
function makeAgain(name, program, seed) {
  let state = seed; // the same numbers for the same seed
  const below = (/** @type {number} */ bound) => (state = (state * 48271) % 2147483647) % bound;
  const study = join(studies, name), how = howOf(name), place = join(root, 'build/study-check', name), copy = join(place, 'docs/studies', name);
  rmSync(place, { recursive: true, force: true });
  mkdirSync(join(place, 'docs/studies'), { recursive: true });
  for (const entry of readdirSync(root)) if (entry !== 'docs') symlinkSync(join(root, entry), join(place, entry));
  for (const entry of readdirSync(join(root, 'docs'))) if (entry !== 'studies') symlinkSync(join(root, 'docs', entry), join(place, 'docs', entry));
  for (const entry of readdirSync(studies)) if (entry !== name) symlinkSync(join(studies, entry), join(place, 'docs/studies', entry));
  cpSync(study, copy, { recursive: true });

  const tables = dataOf(name), chosen = tables.filter((file) => !how(file).kept);
  const drop = (/** @type {(file: string) => boolean} */ fits, /** @type {number} */ most) => {
    for (let of = chosen.filter(fits); of.length > most; of = chosen.filter(fits)) chosen.splice(chosen.indexOf(of[below(of.length)] ?? ''), 1);
  };
  for (const way of new Set(chosen.map(how))) if (way.most) drop((file) => how(file) === way, way.most);
  drop(() => true, MOST_TABLES);
  const taken = /** @type {string[]} */ ([]), commands = new Set();
  for (const file of chosen) {
    const { command, by, also = [], whole } = how(file), path = join(copy, file);
    commands.add(command ?? `${commandOf(name)} {gaitsmith}`);
    if (whole || !file.endsWith('.csv')) {
      rmSync(path);
      taken.push(`all of ${file}`);
      continue;
    }
    const { above, columns, rows, cells } = read(path);
    if (above[0]?.startsWith('# gaitsmith') && spawnSync(program, ['merge', '--complete', '--out', '/dev/null', path]).status !== 0)
      fail(`${name}: ${file} is not complete, so its command would go on with the rest`);
    if (by) {
      const key = cells(rows[below(rows.length)] ?? '', by);
      for (const each of [file, ...also]) {
        const other = read(join(copy, each));
        writeFileSync(join(copy, each), `${[...other.above, ...other.rows.filter((row) => other.cells(row, by) !== key)].join('\n')}\n`);
      }
      taken.push(`${key} of ${[file, ...also].join(', ')}`);
      continue;
    }
    const left = [...rows];
    for (let i = 0; i < ROWS && left.length; i++) left.splice(below(left.length), 1);
    writeFileSync(path, `${[...above, ...left].join('\n')}\n`);
    taken.push(`${rows.length - left.length} rows of ${columns.length} columns of ${file}`);
  }
  console.log(`${name}, seed ${seed}: to be made again are\n  ${taken.join('\n  ')}`);
  for (const command of commands) {
    const [script = '', ...words] = String(command).split(' ');
    const programs = { '{gaitsmith}': resolve(program), '{box2d}': join(root, 'build/release/examples/box2d_figure') };
    const given = [join(copy, script), ...words.map((word) => programs[/** @type {keyof typeof programs} */ (word)] ?? word)];
    const [first = '', ...rest] = script.endsWith('.mjs') ? [process.execPath, ...given] : given;
    const done = spawnSync(first, rest, { cwd: place, stdio: ['ignore', 'ignore', 'inherit'] });
    if (done.status !== 0) fail(`${name}: ${script} ends with ${done.status ?? done.error?.message}`);
  }
  const gone = tables.filter((file) => !existsSync(join(copy, file)));
  if (gone.length) fail(`${name}: not made again: ${gone.join(', ')}`);
  const other = tables.filter((file) => lasting(join(study, file), how(file)) !== lasting(join(copy, file), how(file)));
  if (other.length) fail(`${name}: other bytes in ${other.join(', ')}; compare docs/studies/${name} with build/study-check/${name}/docs/studies/${name}`);
  console.log(`${name}: the same bytes`);
  rmSync(place, { recursive: true, force: true });
}

const [name = '', program = '', given] = process.argv.slice(2);
if (name === '--all' || name === '') {
  for (const each of names) {
    const { log } = planOf(each), fault = lacks(each);
    if (name === '') console.log(`${each}: ${fault || (log ? `a log: ${log}` : `${dataOf(each).length} tables`)}`);
    else if (fault) fail(`${each} ${fault}`);
  }
} else {
  if (!names.includes(name)) fail(`there is no study '${name}' in docs/studies. There are ${names.join(', ')}`);
  if (program === '--sums') {
    writeFileSync(join(studies, name, 'sums.txt'), sumsOf(name));
  } else {
    const { log } = planOf(name), fault = lacks(name);
    if (log) fail(`${name} is a log: ${log}`);
    if (fault) fail(`${name} ${fault}`);
    makeAgain(name, program, Number(given ?? randomInt(1, 2 ** 31)));
  }
}
