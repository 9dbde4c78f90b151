// SPDX-License-Identifier: MIT
// Paints a drawn ground on a canvas.

/**
 * @param {CanvasRenderingContext2D} context @param {[number, number][]} line  the surface from left to right, on the canvas
 * @param {number} bottom  of the ground, on the canvas @param {{fill: string, line: string, width: number}} ink
 */
export function paintGround(context, line, bottom, ink) {
  context.beginPath();
  for (const [x, y] of line) context.lineTo(x, y);
  context.lineTo(line[line.length - 1][0], bottom);
  context.lineTo(line[0][0], bottom);
  context.fillStyle = ink.fill;
  context.fill();
  context.beginPath();
  for (const [x, y] of line) context.lineTo(x, y);
  context.strokeStyle = ink.line;
  context.lineWidth = ink.width;
  context.stroke();
}
