// SPDX-License-Identifier: MIT
// Files that other programs play: from each of them, read as its program reads it, follow the places of all rods, and they
// are where the motion has them. MuJoCo loads the models itself; tests/browser and tests/peers have other programs play the others.
import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { before, test } from 'node:test';
import { along, readScene } from '../peers/godot_text.mjs';
import { ExportedMotions, ROOT } from './exported_motions.mjs';

/** @typedef {import('../../web/search/recorded_motion.js').RecordedMotion} RecordedMotion */
/** A rod's place: where it starts, and its direction. @typedef {{x: number, y: number, turn: number}} Place */
/** What a file says of a rod: its parent, its place there and its own turn at a time. @typedef {{parent: number, at: (s: number) => Place, length: number}} Bone */

const foreign = createRequire(join(ROOT, 'web/package.json'));
const { XMLParser, XMLValidator } = foreign('fast-xml-parser');
const PX = 1; // how exact the files are

/** @type {ExportedMotions} */
let motions;
before(async () => { motions = await ExportedMotions.load(); });

/** Where rods start and end, one after another. @param {Bone[]} bones  parents first @param {number} time */
function endpointsAt(bones, time) {
  /** @type {Place[]} */
  const places = [];
  /** @type {[number, number][]} */
  const ends = [];
  for (const { parent, at, length } of bones) {
    const own = at(time);
    const of = parent < 0 ? { x: 0, y: 0, turn: 0 } : places[parent];
    const [cosine, sine] = [Math.cos(of.turn), Math.sin(of.turn)];
    const place = { x: of.x + cosine * own.x - sine * own.y, y: of.y + sine * own.x + cosine * own.y, turn: of.turn + own.turn };
    places.push(place);
    if (ends.length === 0) ends.push([place.x, place.y]);
    ends.push([place.x + length * Math.cos(place.turn), place.y + length * Math.sin(place.turn)]);
  }
  return ends;
}

/**
 * Compares a file's rods with the motion, at every frame. @param {RecordedMotion} motion @param {Bone[]} bones
 * @param {number} scale  pixels a metre @param {string} name @param {(frame: number) => [number, number]} origin  where the file has x = 0 on the ground [px]
 */
function compare(motion, bones, scale, name, origin) {
  assert.equal(bones.length, motion.starts.length, name);
  for (let frame = 0; frame < motion.frames; frame++) {
    const ends = endpointsAt(bones, frame / 100);
    const [left, ground] = origin(frame);
    ends.forEach(([x, y], k) => {
      const at = frame * motion.stride + 3 + 2 * k;
      const off = Math.hypot(x - left - scale * motion.numbers[at], y - ground + scale * motion.numbers[at + 1]);
      assert.ok(off <= PX, `${name}: endpoint ${k} is ${off} px away at frame ${frame}`);
    });
  }
}

/** The rods' lengths in a file [px]. @param {RecordedMotion} motion @param {number} scale */
const lengthsOf = ({ numbers, starts }, scale) => [...starts].map((start, rod) =>
  scale * Math.hypot(numbers[5 + 2 * rod] - numbers[3 + 2 * start], numbers[6 + 2 * rod] - numbers[4 + 2 * start]));

/**
 * Where a picture has x = 0 on the ground: its view begins at the first centre of mass, and figures stand on their soles.
 * @param {RecordedMotion} motion @param {number} scale @param {{t: number, v: number[]}[]} ground  keys of the ground
 * @returns {(frame: number) => [number, number]}
 */
const viewed = (motion, scale, ground) => (frame) => {
  const [x, y] = along(ground, frame / 100);
  return [x - motion.numbers[1] * scale, y - motion.sole * scale];
};

test('Lottie: its layers have the rods where the motion has them, and its colours are slots', () => {
  motions.each((motion, name) => {
    const lottie = JSON.parse(motion.file('lottie'));
    assert.deepEqual(Object.keys(lottie.slots), ['paper', 'ground', 'ink', 'far', 'line']);
    assert.deepEqual([lottie.w, lottie.h, lottie.fr, lottie.ip, lottie.op], [640, 360, 100, 0, motion.frames - (name === 'a loop' ? 1 : 0)]);
    const layers = new Map(lottie.layers.map((/** @type {any} */ layer) => [layer.ind, layer]));
    assert.equal(layers.size, lottie.layers.length, 'two layers have the same number');
    const keysOf = (/** @type {any} */ { a, k }) => (a ? k.map((/** @type {any} */ key) => ({ t: key.t / 100, v: key.s })) : [{ t: 0, v: [k].flat() }]);
    const rods = lottie.layers.filter((/** @type {any} */ { nm }) => nm.startsWith('rod ')).sort((/** @type {any} */ a, /** @type {any} */ b) => a.ind - b.ind);
    const figure = lottie.layers.find((/** @type {any} */ { nm }) => nm === 'figure');
    const ground = keysOf(lottie.layers.find((/** @type {any} */ { nm }) => nm === 'ground').ks.p);
    const start = keysOf(figure.ks.p);
    const scale = Number(/^1 m = ([\d.]+) px$/.exec(lottie.meta.d)?.[1]);
    const lengths = lengthsOf(motion, scale);
    const bones = rods.map((/** @type {any} */ { parent, ks }, /** @type {number} */ rod) => {
      const [place, turn] = [keysOf(ks.p), keysOf(ks.r)];
      return /** @type {Bone} */ ({
        parent: parent === figure.ind ? -1 : parent - 1,
        length: lengths[rod],
        at: (s) => {
          const [x, y] = parent === figure.ind ? along(start, s) : along(place, s);
          return { x, y, turn: (along(turn, s)[0] * Math.PI) / 180 };
        },
      });
    });
    compare(motion, bones, scale, name, viewed(motion, scale, ground));
    // A shape for each part of the figure, and the eye.
    assert.equal(lottie.layers.filter((/** @type {any} */ { nm }) => nm === 'shape').length, motion.body(0).length / 8, name);
    if (name === 'a loop') return;
    assert.ok(motion.file('lottie').length < 250_000, `${name}: ${motion.file('lottie').length} bytes`);
  });
});

test('moving SVG: its groups have the rods where the motion has them, also at rest, and names are text', () => {
  motions.each((motion, name) => {
    const text = motion.file('animated-svg');
    assert.equal(XMLValidator.validate(text), true, name);
    const seconds = Number(/animation:([\d.]+)s linear infinite/.exec(text)?.[1]);
    assert.equal(seconds.toFixed(2), ((motion.frames - 1) / 100 + (name === 'a loop' ? 0 : 1)).toFixed(2), name);
    /** @param {string} of */
    const keysOf = (of) => [...(new RegExp(`-${of}\\{(.*)\\}\\n`).exec(text)?.[1] ?? '').matchAll(/([\d.]+)%(?:,100%)?\{transform:\w+\(([^)]*)\)\}/g)]
      .map(([, share, value]) => ({ t: (Number(share) / 100) * seconds, v: value.split(',').map(parseFloat) }));
    /** @type {Bone[]} */
    const bones = [];
    const still = /** @type {Record<string, string>} */ ({});
    const scale = Number(/<!-- 1 m = ([\d.]+) px -->/.exec(text)?.[1]);
    const lengths = lengthsOf(motion, scale);
    let shapes = 0;
    /** Groups within groups; those of a bone may come several times. @param {any} group @param {number} parent @param {number} joint */
    const walk = (group, parent, joint) => {
      const [, number] = /^moves b(\d+)$/.exec(group['@_class'] ?? '') ?? [];
      const moved = /^translate\(([\d.]+) 0\)$/.exec(group['@_transform'] ?? '');
      if (number !== undefined) {
        const bone = Number(number);
        const [turn, start] = [keysOf(`b${bone}`), keysOf('figure')];
        still[`b${bone}`] = group['@_transform'];
        if (bones[bone]) assert.equal(bones[bone].parent, parent, name);
        bones[bone] = { parent, length: lengths[bone], at: (s) => {
          const [x, y] = parent < 0 ? along(start, s) : [joint, 0];
          return { x, y, turn: (along(turn, s)[0] * Math.PI) / 180 };
        } };
        shapes += group.path?.length ?? 0;
      }
      for (const child of group.g ?? []) walk(child, number === undefined ? parent : Number(number), moved ? Number(moved[1]) : 0);
    };
    const svg = new XMLParser({ ignoreAttributes: false, isArray: (/** @type {string} */ tag) => ['g', 'path'].includes(tag) }).parse(text).svg;
    const [way, figure] = svg.g;
    assert.equal(way['@_class'], 'moves way');
    walk(figure, -1, 0);
    assert.equal(shapes, motion.body(0).length / 8, name);
    compare(motion, bones, scale, name, viewed(motion, scale, keysOf('way')));
    bones.forEach(({ at }, i) => {
      const turn = Number(/^rotate\((.*)\)$/.exec(still[`b${i}`])?.[1]);
      assert.ok(Math.abs((turn * Math.PI) / 180 - at(0).turn) < 1e-3, `${name}: the first frame of rod ${i}`);
    });
    assert.match(text, /prefers-reduced-motion/);
    assert.match(text, /prefers-color-scheme:dark/);
  });
  const title = '</title><script>&amp;"\'</style>]]>ä';
  const motion = motions.engine.motion(motions.bytesOf({ ...motions.documents.get('star-man-shuffle.json'), title }));
  const parsed = new XMLParser({ ignoreAttributes: false, processEntities: true }).parse(motion.file('animated-svg')).svg;
  assert.equal(parsed.title['#text'], title);
  motion.close();
});

test('Godot: scenes of both formats have the rods where the motion has them', () => {
  for (const [id, format] of /** @type {const} */ ([['godot3', 2], ['godot', 3]])) {
    motions.each((motion, name) => {
      const scene = readScene(motion.file(id));
      assert.equal(scene.format, format);
      assert.equal(scene.length, (motion.frames - 1) / 100);
      assert.equal(scene.loops, name === 'a loop');
      compare(motion, scene.bones, 100, `${name}, format ${format}`, () => [0, 0]);
    });
  }
});

test('Godot: a title is a string', () => {
  const title = '"\\ \u00e4 [node]';
  const motion = motions.engine.motion(motions.bytesOf({ ...motions.documents.get('star-man-shuffle.json'), title }));
  assert.equal(readScene(motion.file('godot')).title, title);
  motion.close();
});

test('a loop that turns ends a whole turn further, and two loops in a page have names of their own', () => {
  const [shuffle, turning] = [motions.documents.get('star-man-shuffle.json'), motions.cartwheel].map((document) => motions.engine.loop(motions.bytesOf(document)));
  const root = JSON.parse(turning.file('lottie')).layers.find((/** @type {any} */ { parent, ks }) => ks.r.a && parent > turning.starts.length);
  const keys = root.ks.r.k;
  const turns = (keys[keys.length - 1].s[0] - keys[0].s[0]) / 360;
  assert.ok(Math.abs(Math.abs(turns) - 1) < 1e-3, `${turns} turns`);
  const idOf = (/** @type {RecordedMotion} */ motion) => /class="(g[0-9a-f]{8})"/.exec(motion.file('animated-svg'))?.[1];
  assert.ok(idOf(shuffle) && idOf(turning));
  assert.notEqual(idOf(shuffle), idOf(turning));
  shuffle.close();
  turning.close();
});
