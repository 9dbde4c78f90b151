// SPDX-License-Identifier: MIT
// Reads exported files with independent programs: an XML parser, Khronos' glTF validator, a GIF decoder.
import assert from 'node:assert/strict';
import { readdir, readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { before, test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';

const ROOT = fileURLToPath(new URL('../../', import.meta.url));
const WEB = process.env.GAITSMITH_WEB ?? join(ROOT, 'build/wasm/web');
const foreign = createRequire(join(ROOT, 'web/package.json'));
const { XMLParser, XMLValidator } = foreign('fast-xml-parser');
const { validateString } = foreign('gltf-validator');
const { GifReader } = foreign('omggif');

const ENGLISH = ['{1} poses of {2} from {3} s to {4} s, lettered {5} to {6}.', 'tilted by {1}°', '.'];

/** @type {import('../../web/search/engine.js').Engine} */
let engine;
/** Shipped documents, by name. @type {Map<string, any>} */
const documents = new Map();

before(async () => {
  const { Engine } = await import(pathToFileURL(join(WEB, 'search/engine.js')).href);
  engine = await Engine.load(await WebAssembly.compile(await readFile(join(WEB, 'search/engine_module.wasm'))));
  for (const folder of ['examples', 'tests/golden/motions']) {
    for (const file of (await readdir(join(ROOT, folder))).filter((name) => name.endsWith('.json')))
      documents.set(file, JSON.parse(await readFile(join(ROOT, folder, file), 'utf8')));
  }
});

/** @param {any} document */
const motionOf = (document) => engine.motion(engine.documentFromText(JSON.stringify({ ...document, hash: undefined })));

/** @param {string} svg */
function read(svg) {
  assert.equal(XMLValidator.validate(svg), true, svg.slice(0, 300));
  return new XMLParser({ ignoreAttributes: false, processEntities: true, isArray: (/** @type {string} */ name) => ['g', 'text'].includes(name) }).parse(svg).svg;
}

test('export: a film strip is XML, with a pose for each that is asked for, and names are text', () => {
  for (const [name, document] of documents) {
    const motion = motionOf(document);
    for (const poses of [3, 8, 26]) {
      const svg = read(motion.filmStrip(poses, ENGLISH));
      assert.equal(svg.g.length, poses, name);
      assert.match(svg.desc['#text'], new RegExp(`^${poses} poses of `), name);
    }
    motion.close();
  }
  const title = '</text><script>&amp;"\'</script>]]>\u00e4\u{1f600}';
  const motion = motionOf({ ...documents.get('star-man-shuffle.json'), title, environment: { slope_rad: 0.1 } });
  const svg = read(motion.filmStrip(5, ['{2} <i> {9}', '{1} & <', ',']));
  assert.equal(svg.title['#text'], title);
  assert.equal(svg.text[0]['#text'], title);
  assert.match(svg.text[1]['#text'], /0,00–10,00 s · 5,7 & <$/);
  assert.equal(svg.desc['#text'], 'Mr. Star-Man <i> {9}');
  assert.throws(() => motion.filmStrip(5, ['too few']), /words/);
  motion.close();
});

test('export: Khronos finds nothing in a glTF scene', async () => {
  for (const [name, document] of documents) {
    for (const change of [{}, { title: '"\\\u00e4', environment: { slope_rad: 0.2 }, duration_steps: 1, pushes: [] }]) {
      const motion = motionOf({ ...document, ...change });
      const { issues, info } = await validateString(motion.file('gltf'));
      assert.deepEqual(issues.messages, [], name);
      assert.equal(info.animationCount, 1);
      assert.equal(info.drawCallCount, motion.starts.length);
      motion.close();
    }
  }
});

test('export: Khronos finds nothing in a glTF scene with a drawn ground, and pictures know its heights', async () => {
  const corners = [[2, 0], [2, 0.3], [5, 0.6], [7, -1]].map(([x_m, y_m]) => ({ x_m, y_m }));
  const motion = motionOf({ ...documents.get('star-man-shuffle.json'), model: 2, environment: { ground: corners } });
  const { issues, info } = await validateString(motion.file('gltf'));
  assert.deepEqual(issues.messages, []);
  assert.equal(info.drawCallCount, motion.starts.length + 1);
  assert.deepEqual([...motion.ground.corners], [2, 0, 2, 0.3, 5, 0.6, 7, -1].map(Math.fround));
  const near = (/** @type {number} */ a, /** @type {number} */ b) => assert.ok(Math.abs(a - b) < 1e-6, `${a} is not ${b}`);
  for (const [x, height] of [[-9, 0], [1.99, 0], [2, 0.3], [3.5, 0.45], [5, 0.6], [6, -0.2], [7, -1], [99, -1]]) near(motion.ground.heightAt(x), height);
  assert.deepEqual(motion.ground.between(1, 3).map(([x]) => x), [1, 2, 2, 3]);
  motion.close();
  const level = motionOf(documents.get('star-man-shuffle.json'));
  assert.equal(level.ground.level, true);
  assert.equal(level.ground.heightAt(3), 0);
  level.close();
});

test('export: numbers have a row for each frame, and the film is told the same', () => {
  const motion = motionOf(documents.get('there-and-back.json'));
  const [header, ...rows] = motion.file('csv').trimEnd().split('\n').map((line) => line.split(','));
  assert.equal(rows.length, motion.frames);
  const nodes = header.indexOf('node0_x');
  rows.forEach((row, i) => {
    const frame = motion.numbers.subarray(i * motion.stride, (i + 1) * motion.stride);
    assert.ok(Math.abs(frame[1] - Number(row[1])) < 1e-4 && Math.abs(frame[2] - Number(row[2])) < 1e-4);
    for (let k = 0; k < 2 * motion.endpoints; k++) assert.ok(Math.abs(frame[3 + k] - Number(row[nodes + k])) < 1e-4);
  });
  assert.deepEqual([...new Set(motion.numbers.filter((_, i) => i % motion.stride === 0))], [0, 1]);
  motion.close();
});

/** A canvas that ignores all drawing, and whose pixels count how often they were read. */
function blankCanvas() {
  let asked = 0;
  const canvas = { width: 0, height: 0, getContext: () => context };
  const context = new Proxy({}, {
    get: (_, name) => (name !== 'getImageData' ? () => {} : () => {
      const data = new Uint8ClampedArray(4 * canvas.width * canvas.height).fill(255);
      data.fill(asked++ % 2 ? 0 : 120, 0, 4000);
      return { data };
    }),
    set: () => true,
  });
  return canvas;
}

test('export: a GIF has a frame for every 40 ms, says how far it is, and stops when told', async () => {
  const { gif } = await import(pathToFileURL(join(WEB, 'share/export_film.js')).href);
  Object.assign(globalThis, { document: { createElement: blankCanvas } });
  const motion = motionOf({ ...documents.get('star-man-shuffle.json'), duration_steps: 50 });
  /** @type {number[]} */
  const shares = [];
  const cancel = new AbortController();
  const job = { motion, title: 'A title', poses: 8, signal: cancel.signal, onProgress: (/** @type {number} */ share) => { shares.push(share); } };
  const bytes = await gif(job);
  const film = new GifReader(bytes);
  assert.deepEqual([film.width, film.height, film.numFrames(), film.loopCount()], [640, 360, 13, 0]);
  for (let i = 0; i < 13; i++) assert.equal(film.frameInfo(i).delay, i < 12 ? 4 : 100);
  const pixels = new Uint8Array(4 * 640 * 360);
  film.decodeAndBlitFrameRGBA(12, pixels);
  assert.deepEqual([...pixels.subarray(4 * 640 * 359, 4 * 640 * 359 + 4)], [255, 255, 255, 255]);
  assert.equal(shares.length, 13);
  assert.ok(shares.every((share, i) => share >= 0 && share < 1 && (i === 0 || share > shares[i - 1])));
  await assert.rejects(gif({ ...job, onProgress: () => { cancel.abort(); } }), { name: 'AbortError' });
  motion.close();
});
