// SPDX-License-Identifier: MIT
// The examples in other engines: senses that are what they say, joints that follow, a push, and a figure that travels.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { engineOf, play } from '../../examples/engines/play.mjs';
import { strongJoint } from '../../examples/engines/figure.mjs';
import { load } from '../../web/runtime/runtime.js';

const ROOT = fileURLToPath(new URL('../../', import.meta.url));
const WEB = process.env.GAITSMITH_WEB ?? join(ROOT, 'build/wasm/web');
const ENGINES = ['planck', 'rapier', 'mujoco'];

/** @type {{Engine: typeof import('../../web/search/engine.js').Engine}} */
const { Engine } = await import(pathToFileURL(join(WEB, 'search/engine.js')).href);
const own = await Engine.load(await WebAssembly.compile(await readFile(join(WEB, 'search/engine_module.wasm'))));

/** A document's controller and model, and how far it travels here [m]. @param {string} name */
async function exported(name) {
  const document = { ...JSON.parse(await readFile(join(ROOT, 'examples', name), 'utf8')), hash: undefined };
  const motion = own.motion(own.documentFromText(JSON.stringify(document)));
  const [controller, mjcf] = [motion.file('controller'), motion.file('mjcf')];
  const x = (/** @type {number} */ frame) => motion.numbers[frame * motion.stride + 1];
  const result = { controller, mjcf, travel: x(motion.frames - 1) - x(0), seconds: (motion.frames - 1) / 100 };
  motion.close();
  return result;
}

/** @param {string} engine @param {import('../../web/runtime/runtime.d.ts').Controller} controller @param {string} mjcf */
const bodyIn = async (engine, controller, mjcf) => (await engineOf(engine, mjcf))(controller, { joint_nm: strongJoint(controller) });

const still = await exported('star-man-shuffle.json');
const crawl = await exported('gallery/inchworm-crawl.json');

for (const engine of ENGINES) {
  test(`${engine}: a figure that stands weighs what it weighs, at the height where it is drawn`, async () => {
    // One rule, for ever: the drawn pose.
    const json = JSON.parse(still.controller);
    json.rules = [{ ...json.rules[0], targets_rad: json.joints.map(() => 0), when: [] }];
    const controller = load(JSON.stringify(json));
    const body = await bodyIn(engine, controller, still.mjcf);
    const before = body.centre();
    play(controller, body, 2);
    const weight = 9.8 * controller.figure.rods.reduce((sum, rod) => sum + rod.mass_kg, 0);
    let pushed = 0;
    for (let k = 0; k <= controller.figure.rods.length; k++) pushed += body.force(k);
    assert.ok(Math.abs(pushed / weight - 1) < 0.03, `${pushed} N instead of ${weight}`);
    assert.ok(Math.abs(body.centre().y - before.y) < 0.01, `${body.centre().y} m instead of ${before.y}`);
    controller.joints.forEach((_, joint) => assert.ok(Math.abs(body.angle(joint)) < 0.02, `joint ${joint} is at ${body.angle(joint)} rad`));
  });

  test(`${engine}: a crawl goes on, and a push makes a difference`, async () => {
    const controller = load(crawl.controller);
    const travel = async (/** @type {{at: number, vx: number}[]} */ pushes) => {
      const way = play(controller, await bodyIn(engine, controller, crawl.mjcf), crawl.seconds, pushes);
      return way.map(({ x }) => x);
    };
    const [alone, again, pushed] = [await travel([]), await travel([]), await travel([{ at: 2, vx: 1 }])];
    assert.deepEqual(alone, again, 'the same twice');
    assert.ok(alone[alone.length - 1] > 0.2 * crawl.travel, `${alone[alone.length - 1]} m of ${crawl.travel}`);
    assert.deepEqual(pushed.slice(0, 200), alone.slice(0, 200));
    assert.ok(pushed[202] > alone[202] + 0.005, 'the push carries it on');
  });
}

test('an unknown sense and an unknown engine are errors that name them', async () => {
  const json = JSON.parse(still.controller);
  json.senses[0].name = 'smell 1';
  const controller = load(JSON.stringify(json));
  const body = await bodyIn('planck', controller, '');
  assert.throws(() => play(controller, body, 0.1), /no reading for smell 1/);
  await assert.rejects(engineOf('chipmunk'), /no engine chipmunk/);
});
