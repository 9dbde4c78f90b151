// SPDX-License-Identifier: MIT
// Each packed file of ./dev packages, installed and used from itself alone, in an empty folder. ./dev test runs this without a
// network:
//
//   GAITSMITH_PACKAGES=build/packages node --test tests/packages/packages.test.mjs
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir, userInfo } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';

const HERE = dirname(fileURLToPath(import.meta.url));
const ROOT = join(HERE, '../..');
const PACKED = resolve(process.env.GAITSMITH_PACKAGES ?? join(ROOT, 'build/packages'));
const TSC = join(ROOT, 'web/node_modules/typescript/bin/tsc');
const VERSION = /project\(gaitsmith VERSION (\S+)/.exec(readFileSync(join(ROOT, 'CMakeLists.txt'), 'utf8'))?.[1];
const EXAMPLES = { 'star-man-shuffle': 'rules', 'star-man-network': 'network', 'there-and-back': 'rules' }; // examples, and what controls them

let scratch = '';
before(() => { scratch = mkdtempSync(join(tmpdir(), 'packages-')); });
after(() => rmSync(scratch, { recursive: true }));

/** @param {string} folder @param {string} program @param {string[]} options */
const runIn = (folder, program, ...options) => execFileSync(program, options, { cwd: folder, encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });
/** @param {string} name */
const has = (name) => !spawnSync(name, ['--version'], { stdio: 'ignore' }).error;
/** @param {RegExp} pattern */
const packed = (pattern) => {
  const [name, ...others] = readdirSync(PACKED).filter((each) => pattern.test(each));
  assert.ok(name && others.length === 0, `one file like ${pattern} in ${readdirSync(PACKED)}`);
  return name;
};
const emptyFolder = () => mkdtempSync(join(scratch, 'empty-'));
/** @param {string} name @returns {string} a folder */
function unpacked(name) {
  const folder = emptyFolder();
  if (name.endsWith('.deb')) runIn(folder, 'dpkg-deb', '-x', join(PACKED, name), '.');
  else if (/\.t?gz$/.test(name)) runIn(folder, 'tar', '-xzf', join(PACKED, name));
  else writeFileSync(join(folder, name), readFileSync(join(PACKED, name)));
  return folder;
}
/** @param {string} folder @returns {string[]} */
const filesIn = (folder) => readdirSync(folder, { recursive: true, withFileTypes: true }).filter((entry) => entry.isFile())
  .map((entry) => join(entry.parentPath ?? entry.path, entry.name).slice(folder.length + 1)).sort();
/** A program of the README of a package. @param {string} markdown */
const exampleOf = (markdown) => /```js\n([^]*?)```/.exec(markdown)?.[1] ?? assert.fail('no example');

/** Installs a package without a network. @param {string} name @returns {string} the folder in which it is a dependency */
function installed(name) {
  const folder = emptyFolder();
  writeFileSync(join(folder, 'package.json'), '{ "private": true, "type": "module" }');
  runIn(folder, 'npm', 'install', '--offline', '--no-audit', '--no-fund', '--cache', join(scratch, 'npm'), join(PACKED, name));
  return folder;
}

/** The errors that TypeScript reports. @param {string} folder @param {string} text */
function typeErrors(folder, text) {
  writeFileSync(join(folder, 'example.ts'), text);
  const { stdout } = spawnSync(process.execPath, [TSC, '--noEmit', '--strict', '--module', 'nodenext', '--target', 'es2022', '--lib', 'es2022,dom', 'example.ts'], { cwd: folder, encoding: 'utf8' });
  return stdout.split('\n').filter((line) => /error TS/.test(line));
}

/**
 * Controllers that the packed program exports from the examples beside it, what they sense there in each step, and what they decide.
 * @returns {{name: string, controller: string, senses: string, targets: string}[]} controller, senses: files
 */
function controllers() {
  const usr = join(unpacked(packed(/^gaitsmith_.*\.tar\.gz$/)), 'usr');
  return Object.entries(EXAMPLES).map(([name, kind]) => {
    const [controller, senses] = ['json', 'senses'].map((end) => join(usr, `${name}.${end}`));
    const example = join(usr, `share/doc/gaitsmith/examples/${name}.json`);
    runIn(usr, join(usr, 'bin/gaitsmith'), 'export', example, '--controller', controller);
    const about = JSON.parse(readFileSync(controller, 'utf8'));
    assert.equal(about.kind, kind);
    const rows = runIn(usr, join(usr, 'bin/gaitsmith'), 'senses', example).trim().split('\n').slice(1).map((row) => row.split(',').map(Number));
    const first = 3 + about.senses.length;
    writeFileSync(senses, rows.slice(1).map((row) => `${row.slice(3, first).join(' ')}\n`).join(''));
    const targets = rows.map((row) => `${[...new Uint32Array(Float32Array.from(row.slice(first, first + about.joints.length)).buffer), row[2] - (kind === 'rules' ? 1 : 0)].join(' ')}\n`).join('');
    return { name, controller, senses, targets };
  });
}

test('packages: SHA256SUMS has every file, and its line is right', () => {
  const lines = readFileSync(join(PACKED, 'SHA256SUMS'), 'utf8').trim().split('\n');
  assert.deepEqual(lines.map((line) => line.slice(66)), readdirSync(PACKED).filter((name) => name !== 'SHA256SUMS').sort());
  if (has('sha256sum')) runIn(PACKED, 'sha256sum', '--strict', '-c', 'SHA256SUMS');
  else for (const line of lines) assert.equal(line.slice(0, 64), createHash('sha256').update(readFileSync(join(PACKED, line.slice(66)))).digest('hex'), line);
});

test('packages: PROVENANCE.json names the commit, and every file with its licence', () => {
  const told = JSON.parse(readFileSync(join(PACKED, 'PROVENANCE.json'), 'utf8'));
  const git = (/** @type {string[]} */ ...options) => runIn(ROOT, 'git', ...options).trim();
  assert.equal(told.version, VERSION);
  assert.equal(told.commit, git('rev-parse', 'HEAD'));
  assert.equal(Date.parse(told.time), 1000 * Number(git('log', '-1', '--format=%ct')));
  assert.equal(told.clean, git('status', '--porcelain') === '');
  assert.match(told.tools.Emscripten, /^Emscripten \d+\.\d+\.\d+/);
  assert.match(told.tools['C++'], /^\w+ \d+\.\d+/);
  assert.deepEqual(told.files.map((/** @type {any} */ { file }) => file), readdirSync(PACKED).filter((name) => !/^[A-Z\d]+(\.json)?$/.test(name)).sort());
  assert.ok(told.files.length >= 5);
  for (const { file, sha256, licence, holds } of told.files) {
    assert.equal(sha256, createHash('sha256').update(readFileSync(join(PACKED, file))).digest('hex'));
    assert.match(licence, /^MIT/);
    const folder = unpacked(file);
    const texts = filesIn(folder).filter((name) => /LICENSE$|copyright$|THIRD-PARTY\.txt$|^gaitsmith-.*\.h$/.test(name)).map((name) => readFileSync(join(folder, name), 'utf8')).join('\n');
    assert.match(texts, /^ *MIT License\n[^]*The above copyright notice/m, `${file} has no licence`);
    for (const name of holds) {
      assert.ok(told.third_party.some((/** @type {any} */ part) => part.name === name && /\d/.test(part.version) && /^sha\d+[:-]/.test(part.checksum)), `${name} has no provenance`);
      assert.ok(texts.includes(name), `${file} has no notice of ${name}`);
    }
    for (const name of filesIn(folder)) {
      const bytes = readFileSync(join(folder, name), 'latin1');
      for (const place of [ROOT, process.env.HOME || '/root', `/${userInfo().username}/`, 'registry.']) assert.ok(place.length < 3 || !bytes.includes(place), `${file}: ${name} has ${place}`);
    }
  }
});

test('packages: the engine for npm', () => {
  const folder = installed(packed(/^gaitsmith-engine-\d+\.\d+\.\d+\.tgz$/));
  const own = join(folder, 'node_modules/gaitsmith-engine');
  assert.match(runIn(folder, process.execPath, join(own, 'example.js')), /^moved [1-9][0-9]*\.[0-9]{2} m\n$/);
  const example = readFileSync(join(own, 'example.js'), 'utf8').replace('\'./engine.js\'', '\'gaitsmith-engine\'');
  assert.ok(example.trim().split('\n').length <= 11);
  const faults = typeErrors(folder, `${example}\nconst wrong: string = search.done;\nengine.search('a text');\n`);
  assert.equal(faults.length, 2, faults.join('\n')); // the two intended errors
  assert.match(faults[0], /boolean.* is not assignable to type 'string'/);
  assert.match(faults[1], /'string' is not assignable to parameter of type 'Uint8Array/);
});

test('packages: the runtime for npm, and the header, which decides the same', () => {
  const name = packed(/^gaitsmith-runtime-\d+\.\d+\.\d+\.tgz$/);
  const folder = installed(name);
  const readme = readFileSync(join(folder, 'node_modules/gaitsmith-runtime/README.md'), 'utf8');
  const example = exampleOf(readme);
  assert.ok(example.trim().split('\n').length <= 10);
  writeFileSync(join(folder, 'hold.mjs'), example);
  assert.ok(readme.includes(`It prints \`${runIn(folder, process.execPath, 'hold.mjs').trim()}\`.`), 'the README prints something else');
  const faults = typeErrors(folder, `import { begin, load, step } from 'gaitsmith-runtime';
const controller = load('');
const state = begin(controller);
step(controller, state, [0, 1]);
const target: Float32Array = state.target;
const wrong: string = state.rule;
step(controller, state, 'a text');\n`);
  assert.equal(faults.length, 2, faults.join('\n'));
  assert.match(faults[0], /'number' is not assignable to type 'string'/);
  assert.match(faults[1], /'string' is not assignable to parameter of type 'ArrayLike<number>/);

  writeFileSync(join(folder, 'targets.mjs'), `import { readFileSync } from 'node:fs';
import { begin, load, step } from 'gaitsmith-runtime';
const controller = load(readFileSync(process.argv[2], 'utf8'));
const state = begin(controller);
const print = () => console.log([...new Uint32Array(state.target.buffer).subarray(0, controller.joints.length), state.rule].join(' '));
print();
for (const row of readFileSync(process.argv[3], 'utf8').trim().split('\\n')) {
  step(controller, state, Float32Array.from(row.split(' '), Number));
  print();
}\n`);
  const header = emptyFolder();
  writeFileSync(join(header, 'gaitsmith.h'), readFileSync(join(PACKED, packed(/^gaitsmith-.*\.h$/))));
  writeFileSync(join(header, 'targets.c'), readFileSync(join(HERE, 'targets.c')));
  runIn(header, 'cc', '-std=c99', '-Wall', '-Wextra', '-Werror', '-ffp-contract=off', 'targets.c', '-o', 'targets');
  for (const { name, controller, senses, targets } of controllers()) {
    assert.ok(new Set(targets.split('\n')).size > 2, `${name} decides nothing`);
    assert.equal(runIn(folder, process.execPath, 'targets.mjs', controller, senses), targets, `${name}: the module decides otherwise than the simulator`);
    assert.equal(runIn(header, './targets', controller, senses), targets, `${name}: the header decides otherwise than the simulator`);
  }
  const shipped = unpacked(name);
  assert.equal(readFileSync(join(shipped, 'package/gaitsmith.h'), 'utf8').replace(/^.*\n/, ''), readFileSync(join(header, 'gaitsmith.h'), 'utf8').replace(/^.*\n\/\* gaitsmith\.h of [^]*?\*\/\n/, ''), 'both packages have the same header');
});

test('packages: the library for CMake', () => {
  const name = packed(/-cmake-.*\.tar\.gz$/);
  const folder = unpacked(name);
  const build = join(folder, 'build');
  assert.deepEqual(readdirSync(folder), [name.replace('.tar.gz', '')]);
  runIn(folder, 'cmake', '-G', 'Ninja', '-S', join(ROOT, 'tests/consumer'), '-B', build, `-DCMAKE_PREFIX_PATH=${join(folder, name.replace('.tar.gz', ''))}`,
    `-DHELLO=${join(folder, name.replace('.tar.gz', ''), 'share/doc/gaitsmith/examples/hello_figure.cpp')}`, '-DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF');
  runIn(folder, 'cmake', '--build', build);
  const used = /^gaitsmith_DIR:PATH=(.*)$/m.exec(readFileSync(join(build, 'CMakeCache.txt'), 'utf8'))?.[1] ?? '';
  assert.ok(used.startsWith(folder), `it used ${used}`);
  assert.match(runIn(folder, join(build, 'consumer')), /^moved \d+\.\d+ m/);

  // Eigen is not needed, but for the inside of the planner.
  const include = join(folder, name.replace('.tar.gz', ''), 'include/gaitsmith');
  const headers = filesIn(include).filter((header) => !header.startsWith('core/spacetime/'));
  assert.ok(headers.length > 100);
  writeFileSync(join(folder, 'all.cpp'), headers.map((header) => `#include "${header}"\n`).join(''));
  runIn(folder, 'c++', '-std=c++23', '-fsyntax-only', '-Wno-psabi', '-I', include, 'all.cpp');
});

/** The program, wherever it is unpacked. @param {string} folder */
function checkProgram(folder) {
  const gaitsmith = join(folder, 'usr/bin/gaitsmith');
  const about = join(folder, 'usr/share/doc/gaitsmith');
  assert.equal(runIn(folder, gaitsmith, 'version'), `gaitsmith ${VERSION}\n`);
  const examples = readdirSync(join(about, 'examples'));
  assert.ok(examples.length >= 5 && examples.every((name) => name.endsWith('.json')));
  for (const name of examples) assert.match(runIn(folder, gaitsmith, 'validate', join(about, 'examples', name)), /valid/, name);
  assert.ok(!/\.(symtab|debug_info)/.test(has('readelf') ? runIn(folder, 'readelf', '-S', '-W', gaitsmith) : ''), 'it is not stripped');
  const manual = join(folder, 'usr/share/man/man1/gaitsmith.1.gz');
  const page = execFileSync('gzip', ['-dc', manual], { encoding: 'utf8' });
  assert.match(page, new RegExp(`^\\.TH GAITSMITH 1 \\d{4}-\\d\\d-\\d\\d "gaitsmith ${VERSION}"`));
  for (const section of ['NAME', 'SYNOPSIS', 'DESCRIPTION', 'SYNTHESIZE', 'EXPORT']) assert.match(page, new RegExp(`^\\.SH ${section}$`, 'm'));
  if (has('man') && /^man \d/.test(runIn(folder, 'man', '--version'))) { // the one of Debian, which reports faults
    const { stdout, stderr } = spawnSync('man', ['--warnings', '-E', 'UTF-8', '-l', manual], { encoding: 'utf8', env: { ...process.env, MANWIDTH: '100' } });
    assert.equal(stderr, '');
    assert.match(stdout, /gaitsmith validate DOC/);
  }
  assert.match(execFileSync('gzip', ['-dc', join(about, 'changelog.gz')], { encoding: 'utf8' }), /^# Changes/);
}

test('packages: the program as a tarball', () => checkProgram(unpacked(packed(/^gaitsmith_.*\.tar\.gz$/))));

test('packages: the program for Debian', (t) => {
  if (process.platform !== 'linux' || !has('dpkg-deb')) return t.skip('dpkg-deb is not here');
  const name = packed(/^gaitsmith_.*\.deb$/);
  const folder = unpacked(name);
  checkProgram(folder);
  const control = runIn(PACKED, 'dpkg-deb', '-f', name);
  for (const field of [/^Package: gaitsmith$/m, new RegExp(`^Version: ${VERSION}$`, 'm'), new RegExp(`^Architecture: ${/_([^_]+)\.deb$/.exec(name)?.[1]}$`, 'm'), /^Depends: .*libc6 .*libstdc\+\+6/m, /^Maintainer: ./m]) assert.match(control, field);
  assert.match(runIn(PACKED, 'dpkg-deb', '-c', name), /^-rwxr-xr-x root\/root .* \.\/usr\/bin\/gaitsmith$/m);
  const tarball = unpacked(packed(/^gaitsmith_.*\.tar\.gz$/));
  assert.deepEqual(filesIn(folder), filesIn(tarball));
  for (const file of filesIn(folder)) assert.ok(existsSync(join(tarball, file)) && readFileSync(join(folder, file)).equals(readFileSync(join(tarball, file))), file);
});
