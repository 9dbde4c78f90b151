// SPDX-License-Identifier: MIT
// Paints a figure on a small canvas, as the stage draws it. The engine computes the outline.
import { BODY_LENGTH } from '../search/engine.js';

const STEPS = 8;
const LEAST_RADIUS = 0.6; // [px]
const LEAST_EYE = 1.1; // [px]

/** Where a point is on the canvas: x metres are at left + x * scale, y metres at ground - y * scale. @typedef {{left: number, ground: number, scale: number}} View */
/** @typedef {{body: string, far: string, eye: string}} Ink */

/** @param {CanvasRenderingContext2D} context @param {Float32Array} body  of RecordedMotion.body @param {View} view @param {Ink} ink */
export function paintBody(context, body, { left, ground, scale }, ink) {
  for (let at = 0; at < body.length; at += BODY_LENGTH) {
    const [x1, y1, r1, x2, y2, r2, belly, tone] = body.subarray(at, at + BODY_LENGTH);
    context.fillStyle = tone === 2 ? ink.eye : tone === 1 ? ink.far : ink.body;
    context.beginPath();
    const radius = (/** @type {number} */ metres) => Math.max(tone === 2 ? LEAST_EYE : LEAST_RADIUS, metres * scale);
    outline(context, [left + x1 * scale, ground - y1 * scale, radius(r1)], [left + x2 * scale, ground - y2 * scale, radius(r2)], belly * scale);
    context.fill();
  }
}

/**
 * Two discs and the hull around them, perhaps swollen halfway.
 * @param {CanvasRenderingContext2D} context @param {[number, number, number]} from  x, y, radius
 * @param {[number, number, number]} to @param {number} belly
 */
function outline(context, [x1, y1, r1], [x2, y2, r2], belly) {
  const [dx, dy] = [x2 - x1, y2 - y1];
  const length = Math.hypot(dx, dy);
  if (length <= Math.abs(r1 - r2) + 0.01) {
    const [x, y, radius] = r1 > r2 ? [x1, y1, r1] : [x2, y2, r2];
    return context.arc(x, y, radius, 0, 2 * Math.PI);
  }
  const angle = Math.atan2(dy, dx);
  const touch = belly > 0 ? Math.PI / 2 : Math.acos((r1 - r2) / length);
  const swell = (/** @type {number} */ side) => {
    for (let step = 1; belly > 0 && step < STEPS; step++) {
      const share = (side > 0 ? STEPS - step : step) / STEPS;
      const radius = side * (r1 + (r2 - r1) * share + belly * Math.sin(share * Math.PI));
      context.lineTo(x1 + dx * share - radius * Math.sin(angle), y1 + dy * share + radius * Math.cos(angle));
    }
  };
  context.arc(x2, y2, r2, angle - touch, angle + touch);
  swell(1);
  context.arc(x1, y1, r1, angle + touch, angle + 2 * Math.PI - touch);
  swell(-1);
  context.closePath();
}

/** A colour between two others. @param {string} from  #rrggbb @param {string} to @param {number} share  of `to` */
export function mixed(from, to, share) {
  const part = (/** @type {number} */ at) => {
    const [a, b] = [from, to].map((colour) => parseInt(colour.slice(at, at + 2), 16));
    return Math.round(a + (b - a) * share);
  };
  return `rgb(${part(1)} ${part(3)} ${part(5)})`;
}
