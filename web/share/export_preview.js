// SPDX-License-Identifier: MIT
// The motion that is about to be exported, playing: the whole of it, one cycle of it, or as it is planned.
import { MotionPicture, pageColours } from './motion_picture.js';

/** @typedef {import('../search/engine.js').Engine} Engine */
/** @typedef {import('../search/engine.js').RecordedMotion} RecordedMotion */
/** @typedef {NonNullable<ReturnType<RecordedMotion['cycle']>>} Cycle */
/** part: what of the motion. halves, inPlace: of a loop (Engine.loop). @typedef {{part: string, halves: boolean, inPlace: boolean}} Choice */

const FRAME_MS = 1000 / 30;

/** Opens the chosen part of a document's motion. @param {Engine} engine @param {Uint8Array} document @param {Choice} choice @returns {RecordedMotion} */
export function openPart(engine, document, { part, halves, inPlace }) {
  if (part === 'loop') return engine.loop(document, { halves, inPlace });
  return part === 'planned' ? engine.plannedMotion(document) : engine.motion(document);
}

/** What is known of a loop, with the way that its frames come. @param {RecordedMotion} motion @param {boolean} inPlace @returns {Cycle | null} */
export function cycleOf(motion, inPlace) {
  const cycle = motion.cycle();
  return cycle && inPlace ? { ...cycle, distance: 0 } : cycle;
}

export class ExportPreview {
  /** @type {MotionPicture | null} */
  #picture = null;
  #began = 0;
  #drawn = 0;
  #frame = 0;
  #calm = matchMedia('(prefers-reduced-motion: reduce)').matches;

  /** @param {HTMLCanvasElement} canvas */
  constructor(canvas) { this.canvas = canvas; }

  /** Plays a motion from its beginning; it is closed with this. @param {RecordedMotion} motion @param {Cycle | null} cycle */
  show(motion, cycle) {
    this.close();
    this.#picture = new MotionPicture(motion, cycle);
    this.#began = performance.now();
    if (this.#calm) this.#picture.strip(this.canvas, pageColours());
    else this.#next();
  }

  /** What is playing. */
  get motion() { return this.#picture?.motion ?? null; }

  close() {
    cancelAnimationFrame(this.#frame);
    this.#picture?.close();
    this.#picture = null;
  }

  #next() {
    this.#frame = requestAnimationFrame((now) => {
      if (now - this.#drawn >= FRAME_MS) {
        this.#drawn = now;
        this.#picture?.play(this.canvas, Math.max(0, now - this.#began) / 1000, pageColours());
      }
      this.#next();
    });
  }
}
