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
//   "where"    values of columns: only such rows are drawn for "by", because others do not come out again
//   "whole"    the file goes, all of it is made again, and the order of its rows counts. "most": of so many files of this pattern
//   "unlike"   columns that do not come out again, such as times, and are not compared
//   "kept"     the file is made with others: nothing is taken out of it, but it is compared
// Commands run in the order of their patterns. Files that the folder's .gitignore names are neither data nor copied.
import { spawnSync } from 'node:child_process';
import { createHash, randomInt } from 'node:crypto';
import { accessSync, constants, cpSync, existsSync, mkdirSync, readFileSync, readdirSync, rmSync, statSync, symlinkSync, writeFileSync } from 'node:fs';
import { basename, join, relative, resolve } from 'node:path';

/** @typedef {{command?: string, by?: string[], also?: string[], where?: Record<string, string>, whole?: boolean, most?: number, unlike?: string[], kept?: boolean}} How */
/** @typedef {{log?: string, tables?: Record<string, How>}} Plan */
const MOST_TABLES = 10, ROWS = 3;
const WORDS = ['command', 'by', 'also', 'where', 'whole', 'most', 'unlike', 'kept'];
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
/** @type {Map<string, Plan>} */
const plans = new Map();
/** @param {string} name @returns {Plan} */
function planOf(name) {
  const plan = plans.get(name) ?? (has(name, 'check.json') ? JSON.parse(readFileSync(join(studies, name, 'check.json'), 'utf8')) : {});
  plans.set(name, plan);
  return plan;
}
/** @param {string} name @returns {string[]} */
const ignoredIn = (name) => (has(name, '.gitignore') ? readFileSync(join(studies, name, '.gitignore'), 'utf8').split('\n') : []);
/** A study's data. @param {string} name */
const dataOf = (name) => filesIn(join(studies, name)).filter((file) => /\.(csv|json)$/.test(file) && file !== 'check.json' && !ignoredIn(name).includes(file));
/** @param {string} name */
const sumsOf = (name) => dataOf(name).map((file) => `${createHash('sha256').update(readFileSync(join(studies, name, file))).digest('hex')}  ${file}\n`).join('');
/** @param {string} name */
const commandOf = (name) => ['run', 'run.mjs'].find((each) => has(name, each));

/** @param {string} path */
function isProgram(path) {
  try {
    accessSync(path, constants.X_OK);
    return statSync(path).isFile();
  } catch {
    return false;
  }
}

/** What a folder lacks, or ''. @param {string} name */
function lacks(name) {
  if (planOf(name).log) return '';
  if (!has(name, 'question.md')) return 'has no question.md';
  if (!has(name, 'sums.txt')) return `has no sums.txt; ./dev study ${name} --sums writes it`;
  if (readFileSync(join(studies, name, 'sums.txt'), 'utf8') !== sumsOf(name)) return 'has other data than sums.txt says';
  for (const [pattern, how] of Object.entries(planOf(name).tables ?? {})) {
    const strange = Object.keys(how).find((word) => !WORDS.includes(word));
    if (strange) return `has an unknown word in check.json: '${strange}'`;
    if (!dataOf(name).some((file) => new RegExp(pattern).test(file))) return `has no file for '${pattern}' of check.json`;
  }
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
/** What a run repeats of a file. Rows that are made again come last, so their order does not count. @param {string} path @param {How} how */
function lasting(path, { unlike = [], whole }) {
  if (!path.endsWith('.csv') || (whole && !unlike.length)) return readFileSync(path, 'utf8');
  const { above, columns, rows, cells } = read(path);
  const kept = columns.filter((column) => !unlike.includes(column));
  const lines = rows.map((row) => (unlike.length ? cells(row, kept) : row));
  return [...above, ...(whole ? lines : lines.sort())].join('\n');
}

/** Copies a study to where the rest of the repository is linked. @param {string} name @param {string} place @returns {string} the copy */
function copyTo(name, place) {
  const copy = join(place, 'docs/studies', name);
  const link = (/** @type {string} */ folder, /** @type {string} */ without) => {
    for (const entry of readdirSync(join(root, folder))) if (entry !== without) symlinkSync(join(root, folder, entry), join(place, folder, entry));
  };
  rmSync(place, { recursive: true, force: true });
  mkdirSync(join(place, 'docs/studies'), { recursive: true });
  link('', 'docs');
  link('docs', 'studies');
  link('docs/studies', name);
  cpSync(join(studies, name), copy, { recursive: true, filter: (from) => !ignoredIn(name).includes(basename(from)) });
  return copy;
}

/** The files from which something is taken. @param {string} name @param {(bound: number) => number} below  a random number */
function draw(name, below) {
  const how = howOf(name), chosen = dataOf(name).filter((file) => !how(file).kept);
  const drop = (/** @type {(file: string) => boolean} */ fits, /** @type {number} */ most) => {
    for (let of = chosen.filter(fits); of.length > most; of = chosen.filter(fits)) chosen.splice(chosen.indexOf(of[below(of.length)] ?? ''), 1);
  };
  for (const way of new Set(chosen.map(how))) if (way.most) drop((file) => how(file) === way, way.most);
  drop(() => true, MOST_TABLES);
  return chosen;
}

/** Takes out of a table what is to be made again, and says what. @param {string} copy @param {string} file @param {How} how @param {(bound: number) => number} below @returns {string} */
function takeFrom(copy, file, { by, also = [], where = {}, whole }, below) {
  if (whole || !file.endsWith('.csv')) {
    rmSync(join(copy, file));
    return `all of ${file}`;
  }
  const write = (/** @type {string} */ name, /** @type {string[]} */ lines) => writeFileSync(join(copy, name), `${lines.join('\n')}\n`);
  const { above, rows, cells } = read(join(copy, file));
  if (by) {
    const drawn = rows.filter((row) => cells(row, Object.keys(where)) === Object.values(where).join(','));
    const key = cells(drawn[below(drawn.length)] ?? '', by);
    for (const each of [file, ...also]) {
      const table = read(join(copy, each));
      write(each, [...table.above, ...table.rows.filter((row) => table.cells(row, by) !== key)]);
    }
    return `${key} of ${[file, ...also].join(', ')}`;
  }
  const left = [...rows];
  for (let i = 0; i < ROWS && left.length; i++) left.splice(below(left.length), 1);
  write(file, [...above, ...left]);
  return `${rows.length - left.length} rows of ${file}`;
}

/** Runs what makes these files, each command once. @param {string} name @param {string[]} files @param {string} copy @param {string} program */
function run(name, files, copy, program) {
  const order = Object.values(planOf(name).tables ?? {});
  const ways = files.map(howOf(name)).sort((a, b) => order.indexOf(a) - order.indexOf(b));
  const programs = new Map([['{gaitsmith}', resolve(program)], ['{box2d}', join(root, 'build/release/examples/box2d_figure')]]);
  for (const command of new Set(ways.map((way) => way.command ?? `${commandOf(name)} {gaitsmith}`))) {
    const [script = '', ...words] = command.split(' ');
    const line = [join(copy, script), ...words.map((word) => programs.get(word) ?? word)];
    if (script.endsWith('.mjs')) line.unshift(process.execPath);
    const done = spawnSync(line[0] ?? '', line.slice(1), { cwd: join(copy, '../../..'), stdio: ['ignore', 'ignore', 'inherit'] });
    if (done.status !== 0) fail(`${name}: ${script} ends with ${done.status ?? done.error?.message}`);
  }
}

/** @param {string} name @param {string} program @param {number} seed */
function makeAgain(name, program, seed) {
  let state = seed; // the same numbers for the same seed
  const below = (/** @type {number} */ bound) => (state = (state * 48271) % 2147483647) % bound;
  const study = join(studies, name), how = howOf(name), place = join(root, 'build/study-check', name), copy = copyTo(name, place);
  const files = draw(name, below);
  for (const file of files) {
    if (!file.endsWith('.csv') || !read(join(copy, file)).above[0]?.startsWith('# gaitsmith')) continue;
    if (spawnSync(program, ['merge', '--complete', '--out', '/dev/null', join(copy, file)]).status !== 0)
      fail(`${name}: ${file} is not complete, so its command would go on with the rest`);
  }
  const taken = files.map((file) => takeFrom(copy, file, how(file), below));
  console.log(`${name}, seed ${seed}: to be made again are\n  ${taken.join('\n  ')}`);
  run(name, files, copy, program);
  const gone = dataOf(name).filter((file) => !existsSync(join(copy, file)));
  if (gone.length) fail(`${name}: not made again: ${gone.join(', ')}`);
  const other = dataOf(name).filter((file) => lasting(join(study, file), how(file)) !== lasting(join(copy, file), how(file)));
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
    if (!isProgram(program)) fail(`'${program}' is no program: check.mjs ${name} build/release/shell/gaitsmith [seed]`);
    if (given !== undefined && !/^[1-9]\d{0,8}$/.test(given)) fail(`'${given}' is no seed: a whole number from 1 to 999999999`);
    makeAgain(name, program, Number(given ?? randomInt(1, 1e9)));
  }
}
