// SPDX-License-Identifier: MIT
// Videos of a motion. A GIF is made as fast as possible, a WebM is recorded in real time.
import { Film, STEPS_PER_SECOND } from './film.js';
import { GIFEncoder, nearestColorIndex, quantize } from './gifenc.js';
import { withDuration } from './webm_duration.js';

/** @typedef {import('./export_formats.js').ExportJob} ExportJob */

const STEPS_PER_FRAME = 4; // GIF delays are in hundredths of a second, and browsers do not play delays below two correctly
const LAST_FRAME_MS = 1000; // shows that the motion starts again
const BLENDS = 48; // colours beside those of the film
const SAMPLES = 6; // frames from which the palette is made
const WEBM_RATE = 60;
const WEBM_BITS = 8e5; // a second: about half as many as the GIF has, and nothing looks blurred

/** Lets the page handle events. */
const pause = () => new Promise((resolve) => setTimeout(resolve));

/** The film's colours, unchanged, and colours for its blends. @param {Film} film @returns {number[][]} */
function paletteOf(film) {
  const last = film.motion.frames - 1;
  const samples = Array.from({ length: SAMPLES }, (_, i) => {
    film.draw(Math.round(last * i / (SAMPLES - 1)));
    return film.pixels();
  });
  const all = new Uint8ClampedArray(samples.length * samples[0].length);
  samples.forEach((sample, i) => all.set(sample, i * sample.length));
  const own = film.colours.map((hex) => [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16)));
  return [...own, ...quantize(all, BLENDS, { format: 'rgb565' })];
}

/** Finds the palette's colour for each pixel. The encoder's own function merges similar colours. */
class Painter {
  /** @type {Map<number, number>} */
  #known = new Map();

  /** @param {number[][]} palette */
  constructor(palette) { this.palette = palette; }

  /** @param {Uint8ClampedArray} rgba */
  indices(rgba) {
    const pixels = new Uint32Array(rgba.buffer, rgba.byteOffset, rgba.length / 4);
    const indices = new Uint8Array(pixels.length);
    let last = -1;
    let index = 0;
    for (let i = 0; i < pixels.length; i++) {
      if (pixels[i] !== last) {
        last = pixels[i];
        index = this.#known.get(last) ?? this.#nearest(last, rgba.subarray(4 * i, 4 * i + 3));
      }
      indices[i] = index;
    }
    return indices;
  }

  /** @param {number} pixel @param {Uint8ClampedArray} rgb */
  #nearest(pixel, rgb) {
    const index = nearestColorIndex(this.palette, [...rgb]);
    this.#known.set(pixel, index);
    return index;
  }
}

/**
 * The frames of a GIF. A loop's are evenly spaced, without the last one, which is its first.
 * @param {number} frames @param {boolean} loops
 */
function shownFrames(frames, loops) {
  const steps = frames - 1;
  const count = loops ? Math.max(2, Math.round(steps / STEPS_PER_FRAME)) : Math.ceil(frames / STEPS_PER_FRAME);
  return Array.from({ length: count }, (_, i) => (loops ? Math.round((i * steps) / count) : i * STEPS_PER_FRAME));
}

/** @param {ExportJob} job @returns {Promise<BlobPart>} */
export async function gif({ motion, title, signal, onProgress, cycle = null }) {
  const film = new Film(motion, title, cycle);
  const palette = paletteOf(film);
  const painter = new Painter(palette);
  const encoder = GIFEncoder();
  const shown = shownFrames(motion.frames, cycle !== null);
  for (const [i, frame] of shown.entries()) {
    film.draw(frame);
    const last = i === shown.length - 1 && !cycle;
    const delay = last ? LAST_FRAME_MS : 1000 * STEPS_PER_FRAME / STEPS_PER_SECOND;
    const options = i === 0 ? { palette, delay, repeat: 0 } : { delay };
    encoder.writeFrame(painter.indices(film.pixels()), film.width, film.height, options);
    onProgress(i / shown.length);
    await pause();
    signal.throwIfAborted();
  }
  encoder.finish();
  return new Uint8Array(encoder.bytes());
}

/** @param {ExportJob} job @returns {Promise<BlobPart>} */
export async function webm({ motion, title, signal, onProgress, cycle = null }) {
  const film = new Film(motion, title, cycle);
  film.draw(0);
  const stream = film.canvas.captureStream(WEBM_RATE);
  const recorder = new MediaRecorder(stream, { mimeType: 'video/webm', videoBitsPerSecond: WEBM_BITS });
  /** @type {Blob[]} */
  const parts = [];
  recorder.ondataavailable = ({ data }) => parts.push(data);
  const ended = new Promise((resolve, reject) => {
    recorder.onstop = resolve;
    recorder.onerror = () => reject(new Error('the browser stopped recording'));
  });
  // On a busy machine recorders need a while to begin, and would miss a short motion. A drawing is what wakes them.
  const started = new Promise((resolve) => { recorder.onstart = resolve; });
  film.draw(0);
  recorder.start();
  await Promise.race([started, ended]);
  const start = performance.now();
  let recordedMs = 0;
  try {
    for (let frame = 0; frame < motion.frames; frame = Math.floor((performance.now() - start) * STEPS_PER_SECOND / 1000)) {
      film.draw(frame);
      onProgress(frame / motion.frames);
      await new Promise((resolve) => setTimeout(resolve, 1000 / WEBM_RATE));
      signal.throwIfAborted();
    }
    film.draw(motion.frames - 1);
    await pause();
    recordedMs = performance.now() - start;
  } finally {
    if (recorder.state !== 'inactive') recorder.stop();
    for (const track of stream.getTracks()) track.stop();
  }
  await ended;
  return withDuration(new Uint8Array(await new Blob(parts).arrayBuffer()), recordedMs);
}
