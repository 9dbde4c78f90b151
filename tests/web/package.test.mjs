// SPDX-License-Identifier: MIT
// The engine's npm package in another project: installed from its archive, its example run by Node and in a browser
// (tests/browser), its types used by TypeScript.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtemp, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const WEB = join(dirname(fileURLToPath(import.meta.url)), '../../web');

test('package: it installs without a network, its example runs, and its types hold', async () => {
  const folder = await mkdtemp(join(tmpdir(), 'consumer-'));
  try {
    const run = (/** @type {string} */ program, /** @type {string[]} */ ...options) =>
      execFileSync(program, options, { cwd: folder, encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });
    run(process.execPath, join(WEB, 'package/pack.mjs'), process.cwd(), folder); // the tests run where the engine was built
    await writeFile(join(folder, 'package.json'), '{ "private": true, "type": "module" }');
    const archive = (await readdir(folder)).find((name) => /^gaitsmith-engine-\d+\.\d+\.\d+\.tgz$/.test(name));
    assert.ok(archive, 'no archive with a version');
    run('npm', 'install', '--offline', '--no-audit', '--no-fund', `./${archive}`);

    const packed = join(folder, 'node_modules/gaitsmith-engine');
    assert.match(run(process.execPath, join(packed, 'example.js')), /^moved [1-9][0-9]*\.[0-9]{2} m\n$/);
    const example = (await readFile(join(packed, 'example.js'), 'utf8')).replace('\'./engine.js\'', '\'gaitsmith-engine\'');
    assert.ok(example.trim().split('\n').length <= 11);
    await writeFile(join(folder, 'example.ts'), `${example}\nconst wrong: string = search.done;\nengine.search('a text');\n`);
    let output = '';
    try {
      run(process.execPath, join(WEB, 'node_modules/typescript/bin/tsc'), '--noEmit', '--strict', '--module', 'nodenext', '--target', 'es2022', '--lib', 'es2022,dom', '--skipLibCheck', 'example.ts');
    } catch (error) {
      output = /** @type {any} */ (error).stdout;
    }
    const faults = output.trim().split('\n').filter((line) => /error TS/.test(line));
    assert.equal(faults.length, 2, output); // the two intended errors
    assert.match(faults[0], /boolean.* is not assignable to type 'string'/);
    assert.match(faults[1], /'string' is not assignable to parameter of type 'Uint8Array/);
  } finally {
    await rm(folder, { recursive: true });
  }
});
