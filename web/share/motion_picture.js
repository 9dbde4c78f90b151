// SPDX-License-Identifier: MIT
// A small picture of a motion: the figure runs over its ground and the view follows it, or, where little should move,
// some of its poses stand side by side.
import { mixed, paintBody } from './body_painting.js';
import { paintGround } from './ground_painting.js';

/** @typedef {import('../search/engine.js').RecordedMotion} RecordedMotion */
/** The page's colours. @typedef {{paper: string, ink: string, ink2: string, line: string, soft: string}} Colours */

const COLOURS = /** @type {const} */ (['paper', 'ink', 'ink2', 'line', 'soft']);
const FRAMES_PER_S = 100;
const POSES = 4;
const GROUND = 0.82; // of the height
export const FAR_SHARE = 0.57; // how much of the body's colour far limbs keep, as on the stage
const FIGURE_SHARE = 0.52; // of the height, for the figure as it starts
const WIDTH_SHARE = 0.6; // of the width, for a figure longer than high
const LEAST_ACROSS_M = 1.6;
const REST_S = 0.8; // at the end, before it begins again

export function pageColours() {
  const style = getComputedStyle(document.documentElement);
  return /** @type {Colours} */ (Object.fromEntries(COLOURS.map((name) => [name, style.getPropertyValue(`--${name}`).trim()])));
}

export class MotionPicture {
  /** Metres from the ground to the top of the figure as it starts, and its centre's height. */
  #height = 0.1;
  #centre = 0;

  /** @param {RecordedMotion} motion @param {{distance: number} | null} [cycle]  of a loop: it goes on without an end */
  constructor(motion, cycle = null) {
    this.motion = motion;
    this.cycle = cycle;
    const heights = this.#endpoints(0).map(([, y]) => y);
    this.#height = Math.max(0.1, ...heights);
    this.#centre = motion.numbers[2];
  }

  /** Paints the moment at this time of a clock. @param {HTMLCanvasElement} canvas @param {number} seconds @param {Colours} colours */
  play(canvas, seconds, colours) {
    const { frame, gone } = this.#moment(seconds);
    const { context, width, height, scale } = this.#begin(canvas, colours);
    const [ownX, y] = this.#middle(frame);
    // The view of a loop moves evenly, so that nothing shows where it begins again.
    const x = this.cycle ? this.#middle(0)[0] + (this.cycle.distance * frame) / (this.motion.frames - 1) + gone : ownX;
    const level = this.#levelAt(frame);
    // The view rises with a jump, and with the ground.
    const ground = GROUND * height + (level + Math.max(0, y - level - Math.max(1.5 * this.#centre, (0.35 * height) / scale))) * scale;
    const left = width / 2 - x * scale;
    this.#paintGround(context, { left, ground, scale }, width, height, colours);
    this.#paintFigure(context, frame, { left: left + gone * scale, ground, scale }, colours);
  }

  /** The frame at this time of a clock, and how far the loops before have come [m]. @param {number} seconds */
  #moment(seconds) {
    const { frames } = this.motion;
    const steps = this.cycle ? frames - 1 : frames + REST_S * FRAMES_PER_S; // a loop's last frame is its first
    const at = Math.floor(seconds * FRAMES_PER_S);
    return { frame: Math.min(at % steps, frames - 1), gone: this.cycle ? Math.floor(at / steps) * this.cycle.distance : 0 };
  }

  /** Paints some poses side by side. @param {HTMLCanvasElement} canvas @param {Colours} colours */
  strip(canvas, colours) {
    const { context, width, height, scale } = this.#begin(canvas, colours);
    const smaller = Math.min(scale, (0.9 * width) / POSES / this.#span());
    const ground = GROUND * height;
    this.#paintGround(context, { left: 0, ground, scale: 0 }, width, height, colours);
    for (let pose = 0; pose < POSES; pose++) {
      const frame = Math.round((pose * (this.motion.frames - 1)) / (POSES - 1));
      const [x, y] = this.#middle(frame);
      // The strip's ground is level: each pose is as high as it is above its own.
      const level = this.motion.ground.heightAt(x);
      const lifted = level * smaller + Math.max(0, (y - level) * smaller - 0.55 * height);
      this.#paintFigure(context, frame, { left: ((pose + 0.5) / POSES) * width - x * smaller, ground: ground + lifted, scale: smaller }, colours);
    }
  }

  close() { this.motion.close(); }

  /** @param {HTMLCanvasElement} canvas @param {Colours} colours */
  #begin(canvas, colours) {
    const density = Math.min(2, devicePixelRatio || 1);
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    if (canvas.width !== Math.round(width * density)) canvas.width = Math.round(width * density);
    if (canvas.height !== Math.round(height * density)) canvas.height = Math.round(height * density);
    const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
    context.setTransform(density, 0, 0, density, 0, 0);
    context.fillStyle = colours.paper;
    context.fillRect(0, 0, width, height);
    const scale = Math.min((FIGURE_SHARE * height) / this.#height, (WIDTH_SHARE * width) / this.#span(), width / LEAST_ACROSS_M);
    return { context, width, height, scale };
  }

  /**
   * The ground with a mark at every metre; scale 0: without marks.
   * @param {CanvasRenderingContext2D} context @param {import('./body_painting.js').View} view
   * @param {number} width @param {number} height @param {Colours} colours
   */
  #paintGround(context, { left, ground, scale }, width, height, { soft, ink2 }) {
    const drawn = this.motion.ground;
    const level = scale === 0 || drawn.level;
    if (level && ground > height) return;
    if (level) {
      context.fillStyle = soft;
      context.fillRect(0, ground, width, height - ground);
      context.fillStyle = ink2;
      context.fillRect(0, ground, width, 1);
    } else {
      const line = drawn.between(-left / scale, (width - left) / scale);
      paintGround(context, line.map(([x, y]) => [left + x * scale, ground - y * scale]), height, { fill: soft, line: ink2, width: 1 });
      context.fillStyle = ink2;
    }
    for (let metre = Math.ceil(-left / scale); scale > 0 && left + metre * scale < width; metre++) {
      context.fillRect(Math.round(left + metre * scale), ground - drawn.heightAt(metre) * scale, 1, metre % 5 === 0 ? 7 : 4);
    }
  }

  /** @param {CanvasRenderingContext2D} context @param {number} frame @param {import('./body_painting.js').View} view @param {Colours} colours */
  #paintFigure(context, frame, view, { paper, ink }) {
    // It stands on the lower edge of its outline.
    const standing = { ...view, ground: view.ground - this.motion.sole * view.scale };
    paintBody(context, this.motion.body(frame), standing, { body: ink, far: mixed(paper, ink, FAR_SHARE), eye: paper });
  }

  /** The ground's height around the figure, smoothed over half a second [m]. @param {number} frame */
  #levelAt(frame) {
    const { ground, frames } = this.motion;
    if (ground.level) return 0;
    const places = Array.from({ length: 11 }, (_, i) => Math.min(Math.max(0, frame + 5 * (i - 5)), frames - 1));
    return places.reduce((sum, place) => sum + ground.heightAt(this.#middle(place)[0]), 0) / places.length;
  }

  /** The centre of mass [m]. @param {number} frame @returns {[number, number]} */
  #middle(frame) {
    const { numbers, stride } = this.motion;
    return [numbers[frame * stride + 1], numbers[frame * stride + 2]];
  }

  /** @param {number} frame @returns {[number, number][]} */
  #endpoints(frame) {
    const { numbers, stride, endpoints } = this.motion;
    return Array.from({ length: endpoints }, (_, k) => [numbers[frame * stride + 3 + 2 * k], numbers[frame * stride + 4 + 2 * k]]);
  }

  /** Width of the figure as it starts [m]. */
  #span() {
    const across = this.#endpoints(0).map(([x]) => x);
    return Math.max(0.3, Math.max(...across) - Math.min(...across), this.#height);
  }
}
