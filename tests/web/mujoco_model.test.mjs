// SPDX-License-Identifier: MIT
// MuJoCo loads the models of every shipped motion: their poses have all endpoints where the motion has them, and they start as
// the motion does. tests/peers lets them fly.
import assert from 'node:assert/strict';
import { readdir, readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';
import loadMujoco from '../../web/node_modules/@mujoco/mujoco/mujoco.js';

const ROOT = fileURLToPath(new URL('../../', import.meta.url));
const WEB = process.env.GAITSMITH_WEB ?? join(ROOT, 'build/wasm/web');
const STEPS_BETWEEN = 25; // of the motion, between two poses
const BALL_M = 0.01;

/** @type {{Engine: typeof import('../../web/search/engine.js').Engine}} */
const { Engine } = await import(pathToFileURL(join(WEB, 'search/engine.js')).href);
const engine = await Engine.load(await WebAssembly.compile(await readFile(join(WEB, 'search/engine_module.wasm'))));
const mujoco = await loadMujoco();
const shipped = (await Promise.all(['examples', 'examples/gallery', 'tests/golden/limited'].map(async (folder) =>
  Promise.all((await readdir(join(ROOT, folder))).filter((name) => name.endsWith('.json')).map(async (name) => readFile(join(ROOT, folder, name), 'utf8')))))).flat()
  .map((text) => JSON.parse(text)).filter(({ figure }) => figure.rods.length > 0);

/** @param {any} document */
const motionOf = (document) => engine.motion(engine.documentFromText(JSON.stringify({ ...document, hash: undefined })));
/** @param {number} a @param {number} b @param {string} what @param {number} [off] */
const near = (a, b, what, off = 1e-4) => assert.ok(Math.abs(a - b) <= off * Math.max(1, Math.abs(b)), `${what}: ${a} is not ${b}`);

/** Calls with the motion and MuJoCo's model of it. @param {any} document @param {(motion: import('../../web/search/recorded_motion.js').RecordedMotion, model: any, data: any) => void} body */
function withModel(document, body) {
  const motion = motionOf(document);
  const model = mujoco.MjModel.from_xml_string(motion.file('mjcf'));
  const data = new mujoco.MjData(model);
  try {
    body(motion, model, data);
  } finally {
    data.delete();
    model.delete();
    motion.close();
  }
}

test('MuJoCo: every shipped motion is a model whose poses are the motion’s', () => {
  for (const document of shipped) {
    withModel(document, (motion, model, data) => {
      const { rods } = document.figure;
      assert.equal(model.nbody, rods.length + 1);
      assert.equal(model.nkey, 1 + Math.floor((motion.frames - 1) / STEPS_BETWEEN));
      // The balls at the rods' ends. MuJoCo numbers them depth first, so both are sorted by place.
      for (let key = 0; key < model.nkey; key++) {
        mujoco.mj_resetDataKeyframe(model, data, key);
        mujoco.mj_forward(model, data);
        const frame = key * STEPS_BETWEEN;
        /** @type {number[][]} */
        const has = [];
        /** @type {number[][]} */
        const is = [];
        for (let geom = 0; geom < model.ngeom; geom++) {
          if (model.geom_contype[geom] === 1) is.push([data.geom_xpos[3 * geom], data.geom_xpos[3 * geom + 2]]);
        }
        for (let k = 0; k < motion.endpoints; k++) has.push([motion.numbers[frame * motion.stride + 3 + 2 * k], motion.numbers[frame * motion.stride + 4 + 2 * k]]);
        assert.equal(is.length, has.length);
        const away = (/** @type {number[]} */ from, /** @type {number[][]} */ others) => Math.min(...others.map((to) => Math.hypot(from[0] - to[0], from[1] - to[1])));
        for (const point of is) assert.ok(away(point, has) < 1e-4 * Math.max(1, Math.abs(point[0])), `${document.title}, key ${key}: nothing ends at ${point}`);
        for (const point of has) assert.ok(away(point, is) < 1e-4 * Math.max(1, Math.abs(point[0])), `${document.title}, key ${key}: ${point} is missing`);
        near(data.subtree_com[0], motion.numbers[frame * motion.stride + 1], `${document.title}, key ${key}, centre`);
      }
    });
  }
});

test('MuJoCo: the model starts as thrown, with the strength and the ground of the document', () => {
  const [document] = shipped.filter(({ model = 1 }) => model > 1);
  assert.ok(document);
  const start = { drop_height_m: 2, velocity_x_mps: 1.5, velocity_y_mps: 3, spin_radps: 4 };
  const ground = [[2, 0], [2, 0.3], [5, 0.6], [7, -1]].map(([x_m, y_m]) => ({ x_m, y_m }));
  const environment = { gravity_mps2: 5, friction: 0.6, slope_rad: 0.1, ground };
  withModel({ ...document, start, environment }, (motion, model, data) => {
    mujoco.mj_resetDataKeyframe(model, data, 0);
    mujoco.mj_forward(model, data);
    mujoco.mj_subtreeVel(model, data);
    near(data.subtree_linvel[0], 1.5, 'forth');
    near(data.subtree_linvel[2], 3, 'up');
    near(data.qvel[2], 4, 'spin');
    near(Math.hypot(...model.opt.gravity), 5, 'gravity');
    near(model.opt.gravity[0] / model.opt.gravity[2], Math.tan(0.1), 'slope');
    for (let geom = 0; geom < model.ngeom; geom++) near(model.geom_friction[3 * geom], 0.6, 'friction');
    // The balls' centres are where the page has the ground.
    for (const x of [-20, 1, 3.5, 4.9, 6, 20]) near(groundAt(model, data, x) + BALL_M, motion.ground.heightAt(x), `the ground at ${x} m`, 0.005);
    assert.ok(model.nu > 0);
    for (let actuator = 0; actuator < model.nu; actuator++) assert.ok(model.actuator_forcerange[2 * actuator + 1] > 0);
  });
});

test('MuJoCo: nothing of a ground sticks out beyond it', () => {
  const [document] = shipped.filter(({ model = 1 }) => model > 1);
  // A thin hurdle, a narrow gap, and a step down.
  const ground = [[1, 0], [1, 0.4], [1.04, 0.4], [1.04, 0], [2, 0], [2, -0.5], [2.1, -0.5], [2.1, 0], [3, 0], [3, -0.3]].map(([x_m, y_m]) => ({ x_m, y_m }));
  withModel({ ...document, environment: { ground } }, (motion, model, data) => {
    mujoco.mj_forward(model, data);
    for (let i = 0; i < 400; i++) {
      const x = 0.0051 + i / 100;
      near(groundAt(model, data, x) + BALL_M, motion.ground.heightAt(x), `the ground at ${x} m`, 1e-4);
    }
  });
});

test('MuJoCo: a loop begins with the velocity that it has there', () => {
  const document = shipped.find(({ title }) => title === 'Mr. Star-Man shuffles');
  const motion = engine.loop(engine.documentFromText(JSON.stringify({ ...document, hash: undefined })));
  const model = mujoco.MjModel.from_xml_string(motion.file('mjcf'));
  const data = new mujoco.MjData(model);
  mujoco.mj_resetDataKeyframe(model, data, 0);
  mujoco.mj_forward(model, data);
  mujoco.mj_subtreeVel(model, data);
  const x = (/** @type {number} */ frame) => motion.numbers[frame * motion.stride + 1];
  near(data.subtree_linvel[0], (x(1) - x(0)) / 0.01, 'forth', 0.1);
  assert.ok(data.subtree_linvel[0] > 0.5);
  data.delete();
  model.delete();
  motion.close();
});

/** Height of the ground at a place, looked at from above [m]. @param {any} model @param {any} data @param {number} x */
function groundAt(model, data, x) {
  const geom = new mujoco.IntBuffer(1);
  // Beside the figure, which is at y = 0.
  const way = /** @type {any} */ (mujoco).mj_ray(model, data, [x, 0.5, 50], [0, 0, -1], null, 1, -1, geom, null);
  geom.delete();
  return 50 - way;
}
