// SPDX-License-Identifier: MIT
// A motion as a video: draws the figure and the ground, frame by frame, on a separate canvas, in light colours that
// suit any page or slide. The whole motion is known, so the camera moves smoothly instead of reacting to the figure.
import { fixed } from '../languages/language.js';
import { paintBody } from './body_painting.js';
import { paintGround } from './ground_painting.js';

/** @typedef {import('../search/engine.js').RecordedMotion} RecordedMotion */

export const STEPS_PER_SECOND = 100;
const WIDTH = 640;
const HEIGHT = 360;
const GROUND_Y = 292;
const TOP_Y = 62; // of the figure at its highest point
const MAX_WIDTH = 250; // of the figure
const TRAIL_STEPS = 150;
const INK = '#1d2733', SECOND_INK = '#5b6672', PAPER = '#fbfaf6', GROUND = '#efebe3', FAR = '#7c8287', TRAIL = '#2f5fd0';
// As in shell/export/rule_colours.h.
const COLOURS = ['#2092ea', '#dd8a53', '#106c6f', '#61459b', '#eb54a9', '#b4af0f', '#8cb58f', '#804538', '#5b47e0', '#71630f'];
const MIN_TICK = 76;
const EDGE = 28; // margin for labels

export class Film {
  width = WIDTH;
  height = HEIGHT;

  /** @param {RecordedMotion} motion @param {string} title @param {{distance: number} | null} [cycle]  of a loop, without title and time */
  constructor(motion, title, cycle = null) {
    this.motion = motion;
    this.title = title;
    this.cycle = cycle;
    this.canvas = document.createElement('canvas');
    this.canvas.width = WIDTH;
    this.canvas.height = HEIGHT;
    this.context = /** @type {CanvasRenderingContext2D} */ (this.canvas.getContext('2d', { willReadFrequently: true }));
    const { widest, top } = sizes(motion);
    const { sole } = motion;
    this.scale = Math.min(MAX_WIDTH / widest, (GROUND_Y - TOP_Y) / Math.max(top + 2 * sole, 1e-6));
    this.sole = sole * this.scale;
    this.tick = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000, 20000].find((length) => length * this.scale >= MIN_TICK) ?? 50000;
    const xs = Float64Array.from({ length: motion.frames }, (_, i) => this.#numberAt(i, 1));
    const steps = motion.frames - 1;
    if (cycle) this.tick = evenTick(this.tick, cycle.distance);
    // The view of a loop moves evenly, so that nothing shows where it begins again.
    this.cameras = cycle ? xs.map((_, i) => xs[0] + (cycle.distance * i) / steps) : smooth(xs);
    // The view rises and falls with a drawn ground.
    this.levels = motion.ground.level ? new Float64Array(motion.frames) : smooth(xs.map((x) => motion.ground.heightAt(x)));
    this.severalControllers = new Set(Array.from({ length: motion.frames }, (_, i) => this.#numberAt(i, 0))).size > 1;
  }

  /** The whole picture of one step. @param {number} frame */
  draw(frame) {
    const { context: c } = this;
    c.fillStyle = PAPER;
    c.fillRect(0, 0, WIDTH, HEIGHT);
    this.#ground(frame);
    this.#trail(frame);
    this.#figure(frame);
    if (this.cycle) return;
    c.textBaseline = 'alphabetic';
    c.textAlign = 'right';
    this.#text(`${fixed(frame / STEPS_PER_SECOND, 2)} s`, WIDTH - 20, 34, SECOND_INK, '14px');
    c.textAlign = 'left';
    this.#text(this.title, 20, 34, INK, '600 16px', WIDTH - 130);
    const controller = this.#numberAt(frame, 0);
    if (!this.severalControllers || controller < 0) return;
    c.fillStyle = COLOURS[controller % COLOURS.length];
    c.fillRect(20, 44, 36, 4);
  }

  /** The colours of the frames, as #rrggbb, without blends. */
  get colours() {
    const controllers = new Set(Array.from({ length: this.motion.frames }, (_, i) => this.#numberAt(i, 0)).filter((one) => one >= 0));
    return [PAPER, GROUND, INK, FAR, SECOND_INK, TRAIL, ...[...controllers].map((one) => COLOURS[one % COLOURS.length])];
  }

  /** @returns {Uint8ClampedArray} RGBA of the last drawn frame */
  pixels() { return this.context.getImageData(0, 0, WIDTH, HEIGHT).data; }

  /** @param {number} frame @param {number} which */
  #numberAt(frame, which) { return this.motion.numbers[frame * this.motion.stride + which]; }
  /** @param {number} metres @param {number} frame */
  #x(metres, frame) { return WIDTH / 2 + (metres - this.cameras[frame]) * this.scale; }
  /** The figure stands on the lower edge of its outline. @param {number} metres @param {number} frame */
  #y(metres, frame) { return GROUND_Y - this.sole - (metres - this.levels[frame]) * this.scale; }

  /** @param {string} text @param {number} x @param {number} y @param {string} colour @param {string} font @param {number} [maxWidth] */
  #text(text, x, y, colour, font, maxWidth) {
    this.context.font = `${font} Inter, Helvetica, Arial, sans-serif`;
    this.context.fillStyle = colour;
    this.context.fillText(text, x, y, maxWidth);
  }

  /** @param {number} frame */
  #ground(frame) {
    const { context: c } = this;
    const reach = WIDTH / 2 / this.scale + this.tick;
    if (this.motion.ground.level) {
      c.fillStyle = GROUND;
      c.fillRect(0, GROUND_Y, WIDTH, HEIGHT - GROUND_Y);
      c.fillStyle = SECOND_INK;
      c.fillRect(0, GROUND_Y - 0.75, WIDTH, 1.5);
    } else {
      const line = this.motion.ground.between(this.cameras[frame] - reach, this.cameras[frame] + reach);
      paintGround(c, line.map(([x, y]) => [this.#x(x, frame), this.#surface(y, frame)]), HEIGHT, { fill: GROUND, line: SECOND_INK, width: 1.5 });
    }
    c.textAlign = 'center';
    const first = Math.ceil((this.cameras[frame] - reach) / this.tick);
    for (let mark = first; this.tick > 0 && mark * this.tick < this.cameras[frame] + reach; mark++) {
      const x = this.#x(mark * this.tick, frame);
      c.fillStyle = SECOND_INK;
      const y = this.#surface(this.motion.ground.heightAt(mark * this.tick), frame);
      c.fillRect(x - 0.5, y, 1, 8);
      const metres = fixed(Math.abs(mark * this.tick), this.tick < 1 ? 1 : 0);
      if (this.cycle || x < EDGE || x > WIDTH - EDGE) continue; // a cut label could be misread
      this.#text(`${mark < 0 ? '−' : ''}${metres} m`, x, this.#label(mark * this.tick, frame), SECOND_INK, '12px');
    }
  }

  /** Where the ground's line at a height is. @param {number} metres @param {number} frame */
  #surface(metres, frame) { return GROUND_Y - (metres - this.levels[frame]) * this.scale; }
  /** The label of a mark is below the ground from its left end to its right end. @param {number} metres @param {number} frame */
  #label(metres, frame) {
    const half = 16 / this.scale;
    const low = Math.min(...this.motion.ground.between(metres - half, metres + half).map(([, y]) => y));
    return this.#surface(low, frame) + 24;
  }

  /** @param {number} frame */
  #trail(frame) {
    const { context: c } = this;
    c.strokeStyle = TRAIL;
    c.lineWidth = 1.5;
    for (let i = Math.max(this.cycle ? -Infinity : 1, frame - TRAIL_STEPS); i <= frame; i++) {
      c.globalAlpha = 0.5 * (1 - (frame - i) / TRAIL_STEPS);
      c.beginPath();
      c.moveTo(...this.#middle(i - 1, frame));
      c.lineTo(...this.#middle(i, frame));
      c.stroke();
    }
    c.globalAlpha = 1;
  }

  /** Where the centre of mass was; in a loop also before its beginning. @param {number} moment @param {number} frame @returns {[number, number]} */
  #middle(moment, frame) {
    const steps = this.motion.frames - 1;
    const gone = this.cycle ? Math.floor(moment / steps) : 0;
    const at = moment - gone * steps;
    return [this.#x(this.#numberAt(at, 1) + gone * (this.cycle?.distance ?? 0), frame), this.#y(this.#numberAt(at, 2), frame)];
  }

  /** @param {number} frame */
  #figure(frame) {
    const view = { left: this.#x(0, frame), ground: this.#y(0, frame), scale: this.scale };
    paintBody(this.context, this.motion.body(frame), view, { body: INK, far: FAR, eye: PAPER });
  }
}

/** The figure's greatest width and height [m]. @param {RecordedMotion} motion */
function sizes({ numbers, stride, frames, endpoints, ground }) {
  let widest = 0;
  let top = 0;
  for (let i = 0; i < frames; i++) {
    let left = Infinity;
    let right = -Infinity;
    const level = ground.heightAt(numbers[i * stride + 1]);
    for (let k = 0; k < endpoints; k++) {
      const x = numbers[i * stride + 3 + 2 * k];
      left = Math.min(left, x);
      right = Math.max(right, x);
      top = Math.max(top, numbers[i * stride + 4 + 2 * k] - level);
    }
    widest = Math.max(widest, right - left);
  }
  // A motion that explodes must not shrink its figure to nothing.
  const bounded = Math.max(1e-6, Math.min(widest, 1000));
  return { widest: bounded, top: Math.min(top, 50 * bounded) };
}

/** The distance of marks nearest to `tick` of which a loop's way is a multiple; 0: its way is too short for marks. @param {number} tick @param {number} distance */
function evenTick(tick, distance) {
  const marks = Math.round(Math.abs(distance) / tick);
  if (Math.abs(distance) < 1e-6) return tick;
  return marks > 0 ? Math.abs(distance) / marks : 0;
}

/** Two moving averages over one second. @param {Float64Array} values */
function smooth(values) {
  for (let pass = 0; pass < 2; pass++) {
    const sums = new Float64Array(values.length + 1);
    values.forEach((value, i) => { sums[i + 1] = sums[i] + value; });
    values = values.map((_, i) => {
      const half = Math.min(STEPS_PER_SECOND / 2, i, values.length - 1 - i);
      return (sums[i + half + 1] - sums[i - half]) / (2 * half + 1);
    });
  }
  return values;
}
