// SPDX-License-Identifier: MIT
// The ground of a motion for pictures: a line through corners, level before the first and after the last one.

export class DrawnGround {
  /** @param {Float32Array} corners  x and y of each, from left to right [m]; none: level at 0 */
  constructor(corners) {
    this.corners = corners;
  }

  get level() { return this.corners.length === 0; }

  /** The height at a place; at a vertical face that of its upper end [m]. @param {number} x */
  heightAt(x) {
    const { corners } = this;
    const last = corners.length - 2;
    if (last < 0) return 0;
    let height = x < corners[0] ? corners[1] : x > corners[last] ? corners[last + 1] : -Infinity;
    for (let i = 0; i <= last && corners[i] <= x; i += 2) {
      if (corners[i] === x) height = Math.max(height, corners[i + 1]);
      else if (i < last && corners[i + 2] >= x) {
        const [x0, y0, x1, y1] = corners.subarray(i, i + 4);
        height = Math.max(height, x1 === x0 ? y1 : y0 + ((x - x0) / (x1 - x0)) * (y1 - y0));
      }
    }
    return height;
  }

  /** The line between two places, ends included [m]. @param {number} left @param {number} right @returns {[number, number][]} */
  between(left, right) {
    /** @type {[number, number][]} */
    const line = [[left, this.heightAt(left)]];
    for (let i = 0; i < this.corners.length; i += 2) {
      if (this.corners[i] > left && this.corners[i] < right) line.push([this.corners[i], this.corners[i + 1]]);
    }
    line.push([right, this.heightAt(right)]);
    return line;
  }
}
