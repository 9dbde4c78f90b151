// SPDX-License-Identifier: MIT
// The JavaScript for games is small, has the types that it says, and refuses damaged controllers. That it decides as the simulator does
// is checked by tests/runtime/replay_test.sh, which needs the command line.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtemp, readdir, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import * as runtime from '../../web/runtime/runtime.js';

const ROOT = fileURLToPath(new URL('../../', import.meta.url));
const KIB = 1024;
const controllers = async () => {
  const folder = join(ROOT, 'tests/golden/controllers');
  return Promise.all((await readdir(folder)).map(async (name) => ({ name, text: await readFile(join(folder, name), 'utf8') })));
};
/** The error of a text. @param {string} text @returns {any} */
const fault = (text) => {
  try { runtime.load(text); } catch (error) {
    assert.ok(error instanceof runtime.ControllerError, `${error}`);
    return { code: error.code, where: error.where };
  }
  return undefined;
};

test('runtime: script and header have at most 5 KB, compressed', async () => {
  const folder = await mkdtemp(join(tmpdir(), 'runtime-'));
  try {
    execFileSync(process.execPath, [join(ROOT, 'web/build/minify.mjs'), folder, join(ROOT, 'web'), join(ROOT, 'web/runtime/runtime.js')]);
    assert.ok(gzipSync(await readFile(join(folder, 'runtime/runtime.js')), { level: 9 }).length <= 5 * KIB);
  } finally {
    await rm(folder, { recursive: true });
  }
  assert.ok(gzipSync(await readFile(join(ROOT, 'core/runtime/gaitsmith.h')), { level: 9 }).length <= 5 * KIB);
});

test('runtime: the types name what the script exports', async () => {
  const types = await readFile(join(ROOT, 'web/runtime/runtime.d.ts'), 'utf8');
  assert.deepEqual([...types.matchAll(/^export (?:function|class) (\w+)/gm)].map(([, name]) => name).sort(), Object.keys(runtime).sort());
});

test('runtime: loads a controller of every kind and lets it decide', async () => {
  const all = await controllers();
  assert.deepEqual(all.map(({ name }) => name).sort(), ['network.json', 'rules.json', 'sight.json', 'springs.json', 'timer.json', 'trajectory.json']);
  for (const { name, text } of all) {
    const controller = runtime.load(text);
    assert.equal(controller.step_s, Math.fround(0.01), name);
    const state = runtime.begin(controller);
    const senses = controller.senses.map((_, i) => runtime.normalise(controller, i, 0.1));
    for (let i = 0; i < 200; ++i) runtime.step(controller, state, senses);
    assert.equal(state.target.length, controller.joints.length, name);
    state.target.forEach((angle, j) => assert.ok(angle >= controller.joints[j].min_rad - 1e-6 && angle <= controller.joints[j].max_rad + 1e-6, `${name}: joint ${j}`));
  }
});

test('runtime: refuses texts that are cut', async () => {
  for (const { name, text } of await controllers()) {
    const whole = text.trimEnd();
    for (let size = 0; size < whole.length; size += 97) assert.deepEqual(fault(whole.slice(0, size)), { code: 'syntax', where: '' }, name);
  }
});

test('runtime: says which part is wrong', async () => {
  const text = (await controllers()).find(({ name }) => name === 'rules.json')?.text ?? '';
  /** @param {(json: any) => void} change */
  const changed = (change) => {
    const json = JSON.parse(text);
    change(json);
    return fault(JSON.stringify(json));
  };
  assert.equal(changed(() => {}), undefined);
  assert.deepEqual(changed((json) => { json.version = 2; }), { code: 'range', where: 'version' });
  assert.deepEqual(changed((json) => { json.kind = 'reflex'; }), { code: 'range', where: 'kind' });
  assert.deepEqual(changed((json) => { json.rules[1].tau_s = -1; }), { code: 'range', where: 'rules[1].tau_s' });
  assert.deepEqual(changed((json) => { json.rules[1].decay = '1'; }), { code: 'syntax', where: 'rules[1].decay' });
  assert.deepEqual(changed((json) => { delete json.rules[1].decay; }), { code: 'shape', where: 'rules[1].decay' });
  assert.deepEqual(changed((json) => { json.rules[2].when = [[99, 0, 1]]; }), { code: 'shape', where: 'rules[2].when[0]' });
  assert.deepEqual(changed((json) => { json.rules[0].targets_rad.pop(); }), { code: 'shape', where: 'rules[0].targets_rad' });
  assert.deepEqual(changed((json) => { json.rules = Array(33).fill(json.rules[0]); }), { code: 'range', where: 'rules' });
  assert.deepEqual(changed((json) => { json.senses[0].clip = 'some'; }), { code: 'range', where: 'senses[0].clip' });
  assert.deepEqual(changed((json) => { json.joints = null; }), { code: 'syntax', where: 'joints' });
  assert.deepEqual(changed((json) => { json.rules = []; }), { code: 'shape', where: 'rules' });
  for (const wrong of ['', '1', 'null', '[]', '{}', '"rules"']) assert.ok(fault(wrong), wrong);
});
