// SPDX-License-Identifier: MIT
// A recorded motion for JavaScript: its frames, the figure's outline, and files made of it.
import { DrawnGround } from './drawn_ground.js';

/** @typedef {import('./engine.js').Engine} Engine */

/** Numbers in a part of RecordedMotion.body. */
export const BODY_LENGTH = 8;

/** The motion of a document's figure, for drawing and as files for other programs. */
export class RecordedMotion {
  /** @param {Engine} engine @param {number} handle */
  constructor(engine, handle) {
    this.engine = engine;
    this.handle = handle;
    const { module } = engine;
    this.frames = module._gs_motion_frames(handle);
    const rods = module._gs_motion_rods(handle);
    /** For each rod the endpoint at its start; rod i ends at endpoint i + 1. A figure of springs has no rods. */
    this.starts = new Int32Array(engine.bytesAt(module._gs_motion_starts(handle), 4 * rods).buffer);
    /** Ends of rods, or nodes. */
    this.endpoints = module._gs_motion_endpoints(handle);
    /** How far the figure's outline reaches below the endpoints on which it stands [m]. */
    this.sole = module._gs_motion_sole(handle);
    /**
     * Length of a frame: the active controller (-1: none), then x and y of the centre of mass and of every endpoint
     * [m].
     */
    this.stride = 3 + 2 * this.endpoints;
    const at = module._gs_motion_numbers(handle);
    /** All frames, one after another. */
    this.numbers = new Float32Array(engine.bytesAt(at, 4 * this.stride * this.frames).buffer);
    const corners = module._gs_motion_corners(handle);
    this.ground = new DrawnGround(new Float32Array(engine.bytesAt(module._gs_motion_ground(handle), 8 * corners).buffer));
  }

  /**
   * The figure's outline in a frame: BODY_LENGTH numbers for each part and for the eye, in the order of drawing: x, y and
   * radius at both ends, how far the radius swells halfway [m], and 0 for a near part, 1 for a far one, 2 for the eye.
   * @param {number} frame @returns {Float32Array}
   */
  body(frame) {
    const at = this.engine.module._gs_motion_body(this.handle, frame);
    return new Float32Array(this.engine.bytesAt(at, 4 * this.engine.module._gs_motion_body_size(this.handle)).buffer);
  }

  /** @param {number} poses @param {string[]} words  FilmStripWords of shell/export/film_strip.h, in order */
  filmStrip(poses, words) {
    const size = this.engine.put(new TextEncoder().encode(words.map((word) => `${word}\0`).join('')));
    return this.#text(this.engine.module._gs_motion_film_strip(this.handle, size, poses));
  }

  /** The text of an exported file. @param {string} name  in shell/export/exporters.h, such as 'csv' */
  file(name) { return new TextDecoder().decode(this.bytes(name)); }

  /** An exported file of any kind. @param {string} name  such as 'apng' @returns {Uint8Array<ArrayBuffer>} */
  bytes(name) {
    const size = this.engine.put(new TextEncoder().encode(name));
    return this.#bytes(this.engine.module._gs_motion_file(this.handle, size));
  }

  /** The sprite sheet, a ZIP. @param {number} frames @param {number} size  the longer side of a frame [px] */
  sprites(frames, size) { return this.#bytes(this.engine.module._gs_motion_sprites(this.handle, frames, size)); }

  /**
   * The terms of the whole motion, whether its simulation failed, and its hash.
   * @returns {{terms: {name: string, value: number | null}[], broke: boolean, hash: string}}
   */
  measures() { return JSON.parse(this.#text(this.engine.module._gs_motion_measures(this.handle))); }

  /**
   * What is known of a loop: lengths of time and way in s and m, gap and slide in longest rods (core/gait/closed_loop.h); later:
   * its controller had to run on to find it. null: of a whole motion.
   * @returns {{period: number, distance: number, turns: number, likeness: number, gap: number, slide: number, later: boolean} | null}
   */
  cycle() { return JSON.parse(this.#text(this.engine.module._gs_motion_loop(this.handle))); }

  close() { this.engine.module._gs_motion_close(this.handle); }

  /** @param {number} at */
  #text(at) { return new TextDecoder().decode(this.#bytes(at)); }

  /** @param {number} at */
  #bytes(at) {
    this.engine.orThrow(at);
    return this.engine.bytesAt(at, this.engine.module._gs_motion_text_size(this.handle));
  }
}
