// SPDX-License-Identifier: MIT
// Exported files of pixels: pictures that move, sprite sheets, and the parts and bones that DragonBones' player moves. The
// figure is painted where the motion has it.
import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { inflateSync } from 'node:zlib';
import { ExportedMotions, ROOT } from './exported_motions.mjs';

/** @typedef {import('../../web/search/recorded_motion.js').RecordedMotion} RecordedMotion */
/** Bytes of red, green, blue and opacity. @typedef {{width: number, height: number, rgba: Uint8Array}} Picture */

const { unzipSync } = createRequire(join(ROOT, 'web/package.json'))('fflate');
const SIGNATURE = '89504e470d0a1a0a';
const BODY_LENGTH = 8;
const FAR = 1;

/** @type {ExportedMotions} */
let motions;
before(async () => { motions = await ExportedMotions.load(); });

/** A PNG's chunks in order. @param {Uint8Array} bytes */
function chunksOf(bytes) {
  const file = Buffer.from(bytes.buffer, bytes.byteOffset, bytes.length);
  assert.equal(file.toString('hex', 0, 8), SIGNATURE);
  const chunks = [];
  for (let at = 8; at < file.length;) {
    const size = file.readUInt32BE(at);
    chunks.push({ type: file.toString('latin1', at + 4, at + 8), data: file.subarray(at + 8, at + 8 + size) });
    at += size + 12;
  }
  assert.equal(chunks.at(-1)?.type, 'IEND');
  return chunks;
}

/** Rows of unfiltered pixels. @param {Buffer} data  compressed @param {number} width @param {number} height @param {number} channels */
function rowsOf(data, width, height, channels) {
  const raw = inflateSync(data), row = width * channels;
  assert.equal(raw.length, height * (row + 1));
  const pixels = Buffer.alloc(height * row);
  for (let y = 0; y < height; y++) {
    assert.equal(raw[y * (row + 1)], 0, 'a filter that this reader does not know');
    raw.copy(pixels, y * row, y * (row + 1) + 1, (y + 1) * (row + 1));
  }
  return pixels;
}

/** @param {Uint8Array} bytes @returns {Picture} */
function pictureOf(bytes) {
  const chunks = chunksOf(bytes), header = chunks[0].data;
  assert.deepEqual([header[8], header[9]], [8, 6], 'eight bits each of red, green, blue and opacity');
  const [width, height] = [header.readUInt32BE(0), header.readUInt32BE(4)];
  return { width, height, rgba: rowsOf(Buffer.concat(chunks.filter(({ type }) => type === 'IDAT').map(({ data }) => data)), width, height, 4) };
}

/** The frames of a PNG that moves, laid over one another as a browser does. @param {Uint8Array} bytes */
function framesOf(bytes) {
  const chunks = chunksOf(bytes), header = chunks[0].data;
  const [width, height] = [header.readUInt32BE(0), header.readUInt32BE(4)];
  const palette = /** @type {{data: Buffer}} */ (chunks.find(({ type }) => type === 'PLTE')).data;
  const clear = /** @type {{data: Buffer}} */ (chunks.find(({ type }) => type === 'tRNS')).data;
  assert.equal(clear[0], 0);
  assert.ok(clear.subarray(1).every((opacity) => opacity === 255));
  const control = /** @type {{data: Buffer}} */ (chunks.find(({ type }) => type === 'acTL')).data;
  const rgba = new Uint8Array(4 * width * height);
  /** @type {{rgba: Uint8Array, delay: number}[]} */
  const frames = [];
  /** @type {{box: number[], over: boolean, delay: number, parts: Buffer[]} | null} */
  let open = null;
  let number = 0;
  const close = () => {
    if (!open) return;
    const [w, h, left, top] = open.box;
    const indices = rowsOf(Buffer.concat(open.parts), w, h, 1);
    indices.forEach((index, i) => {
      if (index === 0 && open?.over) return;
      const at = 4 * ((top + Math.floor(i / w)) * width + left + (i % w));
      rgba.set([...palette.subarray(3 * index, 3 * index + 3), index === 0 ? 0 : 255], at);
    });
    frames.push({ rgba: rgba.slice(), delay: open.delay });
  };
  for (const { type, data } of chunks) {
    if (type === 'fcTL') {
      close();
      assert.equal(data.readUInt32BE(0), number++);
      assert.equal(data[24], 0, 'a frame stays until the next one');
      open = { box: [4, 8, 12, 16].map((at) => data.readUInt32BE(at)), over: data[25] === 1, delay: data.readUInt16BE(20) / data.readUInt16BE(22), parts: [] };
    } else if (type === 'IDAT') {
      open?.parts.push(data);
    } else if (type === 'fdAT') {
      assert.equal(data.readUInt32BE(0), number++);
      open?.parts.push(data.subarray(4));
    }
  }
  close();
  assert.deepEqual([control.readUInt32BE(0), control.readUInt32BE(4)], [frames.length, 0]);
  return { width, height, frames };
}

/** @param {Uint8Array} rgba @param {number} at @returns {number[]} */
const colourAt = (rgba, at) => [...rgba.subarray(4 * at, 4 * at + 3)];

/**
 * The figure's parts in a frame: ends and radii [m], and whether each is far or the eye.
 * @param {RecordedMotion} motion @param {number} frame
 */
function partsOf(motion, frame) {
  const numbers = motion.body(frame);
  return Array.from({ length: numbers.length / BODY_LENGTH }, (_, i) => {
    const [x0, y0, r0, x1, y1, r1, belly, kind] = numbers.subarray(i * BODY_LENGTH, (i + 1) * BODY_LENGTH);
    return { from: [x0, y0], to: [x1, y1], radii: [r0, (r0 + r1) / 2 + belly, r1], kind };
  });
}

/**
 * Points on a part's middle line, where it is thick enough to cover a pixel.
 * @param {{from: number[], to: number[], radii: number[]}} part @param {number} least  the radius [m]
 */
const pointsOn = ({ from, to, radii }, least) => [0, 0.5, 1].filter((_, i) => radii[i] >= least)
  .map((share) => [from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1])]);

test('PNG that moves: its frames have the figure where the motion has it, for as long as it lasts', () => {
  motions.each((motion, name) => {
    if (name !== 'a loop' && !/shuffle|network/.test(name)) return; // each takes a second
    const { width, height, frames } = framesOf(motion.bytes('apng'));
    assert.deepEqual([width, height], [640, 360]);
    const lottie = JSON.parse(motion.file('lottie'));
    const scale = Number(/^1 m = ([\d.]+) px$/.exec(lottie.meta.d)?.[1]);
    const seconds = frames.reduce((sum, { delay }) => sum + delay, 0);
    const whole = (motion.frames - 1) / 100;
    assert.ok(name === 'a loop' ? Math.abs(seconds - whole) < 1e-9 : seconds >= whole && seconds < whole + 1.05, `${name}: ${seconds} s`);
    assert.ok(frames.every(({ rgba }) => rgba.every((value, i) => i % 4 !== 3 || value === 255)), 'all of a frame is opaque');
    const ground = lottie.layers.find((/** @type {any} */ { nm }) => nm === 'ground').ks.p;
    const viewAt = (/** @type {number} */ frame) => {
      if (!ground.a) return ground.k;
      const next = ground.k.findIndex((/** @type {any} */ { t }) => t >= frame);
      const [a, b] = [ground.k[Math.max(0, next - 1)], ground.k[next < 0 ? ground.k.length - 1 : next]];
      const share = b.t > a.t ? (frame - a.t) / (b.t - a.t) : 0;
      return a.s.map((/** @type {number} */ value, /** @type {number} */ i) => value + share * (b.s[i] - value));
    };
    let seen = 0;
    frames.forEach(({ rgba }, i) => {
      const [x, y] = viewAt(4 * i);
      for (const part of partsOf(motion, 4 * i).filter(({ kind }) => kind < 2)) {
        for (const [px, py] of pointsOn(part, 2 / scale)) {
          const at = [Math.round(x + (px - motion.numbers[1]) * scale - 0.5), Math.round(y - motion.sole * scale - py * scale - 0.5)];
          if (at[0] < 0 || at[0] >= width) continue;
          const dark = colourAt(rgba, at[1] * width + at[0]).reduce((sum, value) => sum + value, 0);
          assert.ok(dark < (part.kind === FAR ? 470 : 300) || dark > 700, `${name}: frame ${i} at ${at} is ${dark}`); // the eye is bright
          seen += dark < 470 ? 1 : 0;
        }
      }
    });
    assert.ok(seen > 5 * frames.length, `${name}: ${seen} points`);
  });
});

test('PNG that moves: figures of springs are in every frame', () => {
  motions.eachOfSprings((motion, name) => {
    const { frames } = framesOf(motion.bytes('apng'));
    assert.equal(frames.length, Math.floor((motion.frames - (name === 'a loop' ? 2 : 1)) / 4) + 1);
    const inked = frames.map(({ rgba }) => rgba.reduce((sum, value, i) => sum + (i % 4 === 0 && value + rgba[i + 1] + rgba[i + 2] < 300 ? 1 : 0), 0));
    assert.ok(Math.min(...inked) > 800 && Math.max(...inked) < 2.5 * Math.min(...inked), `${name}: ${Math.min(...inked)} to ${Math.max(...inked)} pixels`);
  });
});

test('sprites: each frame has the figure where the motion has it, and nothing else', () => {
  /** @param {RecordedMotion} motion @param {string} name */
  const check = (motion, name) => {
    const files = unzipSync(motion.sprites(12, 96));
    assert.deepEqual(Object.keys(files), ['sprites.png', 'sprites.json']);
    const sheet = pictureOf(files['sprites.png']);
    const { frames, meta } = JSON.parse(new TextDecoder().decode(files['sprites.json']));
    assert.equal(frames.length, 12);
    assert.deepEqual(meta.size, { w: sheet.width, h: sheet.height });
    assert.equal(meta.image, 'sprites.png');
    assert.deepEqual([meta.frameTags[0].from, meta.frameTags[0].to], [0, 11]);
    const [ground] = meta.slices[0].keys;
    const scale = Number(meta.pixelsPerMetre);
    const loop = name === 'a loop', last = motion.frames - 1;
    const steps = frames.map((/** @type {any} */ _, /** @type {number} */ i) => Math.round((i * last) / (loop ? 12 : 11)));
    const time = frames.reduce((/** @type {number} */ sum, /** @type {any} */ { duration }) => sum + duration, 0);
    assert.ok(Math.abs(time - 10 * last * (loop ? 1 : 12 / 11)) <= 1, `${name}: ${time} ms`);
    const taken = new Set();
    let painted = 0, longest = 0, pivots = 0;
    frames.forEach((/** @type {any} */ { frame, sourceSize, rotated, trimmed }, /** @type {number} */ i) => {
      assert.ok(!rotated && !trimmed);
      assert.deepEqual(sourceSize, { w: frame.w, h: frame.h });
      assert.ok(frame.x + frame.w <= sheet.width && frame.y + frame.h <= sheet.height);
      taken.add(`${frame.x} ${frame.y}`);
      longest = Math.max(longest, frame.w, frame.h);
      // A frame's margin is empty.
      const opacity = (/** @type {number} */ x, /** @type {number} */ y) => sheet.rgba[4 * ((frame.y + y) * sheet.width + frame.x + x) + 3];
      for (let x = 0; x < frame.w; x++) assert.ok(opacity(x, 0) === 0 && opacity(x, frame.h - 1) === 0, `${name}: row of sprite ${i}`);
      for (let y = 0; y < frame.h; y++) assert.ok(opacity(0, y) === 0 && opacity(frame.w - 1, y) === 0, `${name}: column of sprite ${i}`);
      const middle = Number(/^(-?[\d.]+) m$/.exec(meta.layers[0].cels[i].data)?.[1]) + motion.numbers[1]; // 0: the view at the start
      for (const part of partsOf(motion, steps[i])) {
        if (motion.ground.corners.length > 0) continue; // a drawn ground's height is smoothed
        for (const [x, y] of pointsOn(part, 1.5 / scale)) {
          const at = [Math.floor(ground.pivot.x + (x - middle) * scale), ground.bounds.y - Math.ceil((y + motion.sole) * scale)];
          assert.ok(opacity(at[0], at[1]) > 60, `${name}: sprite ${i} at ${at} of ${frame.w}×${frame.h}`);
          painted++;
        }
      }
      pivots += ground.bounds.y >= 0 && ground.bounds.y < frame.h ? 1 : 0;
    });
    assert.equal(taken.size, 12);
    assert.ok(longest <= 96 && longest > 90, `${name}: ${longest} px`);
    if (motion.ground.corners.length > 0) return;
    assert.ok(painted > 100 || motion.starts.length < 4, `${name}: ${painted} points`);
    assert.equal(pivots, 12, name);
  };
  motions.each(check);
  motions.eachOfSprings(check);
});

test('DragonBones: its player moves bones and parts to where the motion has them, within a pixel', async () => {
  // The player asks its browser only for a clock, which these tests set by hand.
  Object.assign(globalThis, { requestAnimationFrame: () => 0, navigator: globalThis.navigator ?? { userAgent: '', maxTouchPoints: 0 } });
  const lib = (/** @type {string} */ name) => import(pathToFileURL(join(ROOT, 'web/node_modules', name)).href);
  const [{ PixiFactory }, { Texture, TextureSource }] = [await lib('pixi-dragonbones-runtime/lib/index.mjs'), await lib('pixi.js/lib/index.mjs')];
  let number = 0;
  motions.each((motion, name) => {
    const files = unzipSync(motion.bytes('dragonbones'));
    assert.deepEqual(Object.keys(files), ['figure_ske.json', 'figure_tex.json', 'figure_tex.png']);
    const [skeleton, atlas] = ['figure_ske.json', 'figure_tex.json'].map((file) => JSON.parse(new TextDecoder().decode(files[file])));
    const picture = pictureOf(files[atlas.imagePath]);
    assert.deepEqual([atlas.width, atlas.height], [picture.width, picture.height]);
    const factory = PixiFactory.newInstance(), own = String(number++);
    assert.ok(factory.parseDragonBonesData(skeleton, own), name);
    factory.parseTextureAtlasData(atlas, new Texture({ source: new TextureSource({ width: picture.width, height: picture.height }) }), own);
    const { armature, animation } = factory.buildArmatureDisplay('figure', own, '', own);
    assert.equal(animation.animations.motion.playTimes, name === 'a loop' ? 0 : 1);
    assert.equal(animation.animations.motion.frameCount, motion.frames - 1);
    assert.equal(armature.getSlots().length, motion.body(0).length / BODY_LENGTH);
    const scale = 100;
    for (let frame = 0; frame < motion.frames; frame++) {
      animation.gotoAndStopByFrame('motion', frame);
      armature.advanceTime(0);
      const endpoint = (/** @type {number} */ k) => [0, 1].map((axis) => (axis ? -scale : scale) * motion.numbers[frame * motion.stride + 3 + 2 * k + axis]);
      motion.starts.forEach((start, rod) => {
        const bone = armature.getBones()[rod], { tx, ty, a, b } = bone.globalTransformMatrix;
        const tip = [tx + a * bone.boneData.length, ty + b * bone.boneData.length];
        for (const [at, k] of /** @type {[number[], number][]} */ ([[[tx, ty], start], [tip, rod + 1]])) {
          const off = Math.hypot(at[0] - endpoint(k)[0], at[1] - endpoint(k)[1]);
          assert.ok(off <= 1, `${name}: endpoint ${k} is ${off} px away at frame ${frame}`);
        }
      });
      if (frame % 50 > 0) continue;
      // The middle line of each part lies in its picture.
      partsOf(motion, frame).forEach((part, i) => {
        const slot = armature.getSlots()[i], { a, b, c, d, tx, ty } = slot.globalTransformMatrix;
        const region = atlas.SubTexture.find((/** @type {any} */ sub) => sub.name === slot.name);
        for (const [x, y] of pointsOn(part, 2 / scale)) {
          const off = [scale * x - tx, -scale * y - ty];
          const inside = [(a * off[0] + b * off[1]) + region.width / 2, (c * off[0] + d * off[1]) + region.height / 2];
          assert.ok(inside[0] >= 0 && inside[0] <= region.width && inside[1] >= 0 && inside[1] <= region.height, `${name}: ${inside} of part ${i} at frame ${frame}`);
          const pixel = (region.y + Math.min(region.height - 1, Math.floor(inside[1]))) * picture.width + region.x + Math.min(region.width - 1, Math.floor(inside[0]));
          assert.ok(picture.rgba[4 * pixel + 3] > 100, `${name}: part ${i} is not painted at ${inside}`);
        }
      });
    }
  });
});
