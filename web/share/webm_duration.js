// SPDX-License-Identifier: MIT
// The duration of a WebM film. Recorders write the head of a film before they know its length, so some leave the duration
// out or write 0, and players show none and cannot seek. https://www.matroska.org/technical/elements.html

const SEGMENT = 0x18538067, INFO = 0x1549A966, SCALE = 0x2AD7B1, DURATION = 0x4489, SEEK_HEAD = 0x114D9B74;
const USUAL_SCALE_NS = 1e6;
const DURATION_BYTES = 11; // id, length, 64-bit number

/** An element: where it begins, where its data begins and ends. @typedef {{id: number, at: number, data: number, end: number}} Part */

/** @param {Uint8Array} bytes @param {number} at  of an element's id */
const widthAt = (bytes, at) => Math.clz32(bytes[at]) - 23; // as many leading zeros as further bytes

/** @param {Uint8Array} bytes @param {number} from @param {number} to */
const numberAt = (bytes, from, to) => bytes.subarray(from, to).reduce((value, byte) => value * 256 + byte, 0);

/** The elements in a part of the film. @param {Uint8Array} bytes @param {number} at @param {number} end @returns {Generator<Part>} */
function* partsOf(bytes, at, end) {
  while (at + 2 <= end) {
    const size = at + widthAt(bytes, at);
    const data = size + widthAt(bytes, size);
    if (!(data <= end)) return;
    const width = data - size;
    const marked = bytes[size] - 2 ** (8 - width); // without the mark of the width
    const length = marked * 256 ** (width - 1) + numberAt(bytes, size + 1, data);
    // All ones: unknown, to the end.
    const last = length === 2 ** (7 * width) - 1 ? end : Math.min(end, data + length);
    yield { id: numberAt(bytes, at, size), at, data, end: last };
    at = last;
  }
}

/** A length in as many bytes as before, or in eight. @param {number} length @param {number} width */
function lengthBytes(length, width) {
  const wide = length < 2 ** (7 * width) - 1 ? width : 8;
  const bytes = new Uint8Array(wide);
  for (let i = wide - 1, rest = length; i >= 0; i--, rest = Math.floor(rest / 256)) bytes[i] = rest % 256;
  bytes[0] |= 2 ** (8 - wide);
  return bytes;
}

/**
 * The film with its duration, unless it has one. A film in another form than recorders write is returned unchanged.
 * @param {Uint8Array<ArrayBuffer>} film @param {number} durationMs @returns {Uint8Array<ArrayBuffer>}
 */
export function withDuration(film, durationMs) {
  const find = (/** @type {Part | undefined} */ inside, /** @type {number} */ id) =>
    [...inside ? partsOf(film, inside.data, inside.end) : []].find((part) => part.id === id);
  const segment = find({ id: 0, at: 0, data: 0, end: film.length }, SEGMENT);
  const info = find(segment, INFO);
  if (!segment || !info) return film;
  const scale = find(info, SCALE);
  const duration = durationMs * USUAL_SCALE_NS / (scale ? numberAt(film, scale.data, scale.end) : USUAL_SCALE_NS);

  const known = find(info, DURATION);
  if (known) {
    const view = new DataView(film.buffer, film.byteOffset + known.data, known.end - known.data);
    if (view.byteLength === 8 && !(view.getFloat64(0) > 0)) view.setFloat64(0, duration);
    else if (view.byteLength === 4 && !(view.getFloat32(0) > 0)) view.setFloat32(0, duration);
    return film;
  }
  // More bytes here would make the places in a table of contents wrong.
  const sized = segment.end !== film.length;
  if (sized || find(segment, SEEK_HEAD)) return film;
  const element = new Uint8Array(DURATION_BYTES);
  element.set([DURATION >> 8, DURATION & 255, 0x88]);
  new DataView(element.buffer).setFloat64(3, duration);
  const size = info.at + widthAt(film, info.at);
  return joined([film.subarray(0, size), lengthBytes(info.end - info.data + DURATION_BYTES, info.data - size),
    film.subarray(info.data, info.end), element, film.subarray(info.end)]);
}

/** @param {Uint8Array[]} parts */
function joined(parts) {
  const whole = new Uint8Array(parts.reduce((length, part) => length + part.length, 0));
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}
