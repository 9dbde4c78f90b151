// SPDX-License-Identifier: MIT
// The duration that is written into a recorder's film.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { withDuration } from '../../web/share/webm_duration.js';

/** @param {string} hex */
const bytesOf = (hex) => new Uint8Array(Buffer.from(hex.replaceAll(/\s/g, ''), 'hex'));
/** @param {Uint8Array} film */
const hexOf = (film) => Buffer.from(film).toString('hex');

const EBML = '1a45dfa3 84 42868101';
const UNKNOWN = '01ffffffffffffff';
const CLUSTER = '1f43b675 84 e7820064';
const SCALE = '2ad7b1 83 0f4240'; // milliseconds
const SECOND_AND_HALF = '4489 88 4097700000000000';

test('webm: a film without a duration gets one, and the rest stays', () => {
  const film = bytesOf(`${EBML} 18538067 ${UNKNOWN} 1549a966 87 ${SCALE} ${CLUSTER}`);
  assert.equal(hexOf(withDuration(film, 1500)), hexOf(bytesOf(`${EBML} 18538067 ${UNKNOWN} 1549a966 92 ${SCALE} ${SECOND_AND_HALF} ${CLUSTER}`)));
});

test('webm: a length of many bytes keeps its width, one that is too narrow gets eight', () => {
  const wide = bytesOf(`${EBML} 18538067 ${UNKNOWN} 1549a966 0100000000000007 ${SCALE}`);
  assert.equal(hexOf(withDuration(wide, 1500)), hexOf(bytesOf(`${EBML} 18538067 ${UNKNOWN} 1549a966 0100000000000012 ${SCALE} ${SECOND_AND_HALF}`)));
  const name = `4d80 f2 ${'41'.repeat(0x72)}`; // the recorder's name, as long as one byte allows
  const narrow = bytesOf(`${EBML} 18538067 ${UNKNOWN} 1549a966 fc ${SCALE} ${name}`.replace('fc', (0x80 + 7 + 3 + 0x72).toString(16)));
  assert.equal(hexOf(withDuration(narrow, 1500)).length, hexOf(narrow).length + 2 * (11 + 7));
});

test('webm: a duration of 0 is replaced, in the scale of the film; another one stays', () => {
  const film = bytesOf(`${EBML} 18538067 ${UNKNOWN} 1549a966 8e 2ad7b1 83 07a120 4489 84 00000000 ${CLUSTER}`);
  assert.equal(hexOf(withDuration(film, 1500)), hexOf(bytesOf(`${EBML} 18538067 ${UNKNOWN} 1549a966 8e 2ad7b1 83 07a120 4489 84 453b8000 ${CLUSTER}`)));
  const known = hexOf(film);
  assert.equal(hexOf(withDuration(film, 9000)), known);
});

test('webm: what is no such film is returned as it is', () => {
  for (const hex of ['', '00', '1a45dfa3', `${EBML} 18538067 ${UNKNOWN}`, `${EBML} 18538067 ${UNKNOWN} 1549a966`, `${EBML} 18538067 ${UNKNOWN} 1549a966 00 ff`,
    // with a table of contents, whose places would be wrong, and with a length
    `${EBML} 18538067 ${UNKNOWN} 114d9b74 80 1549a966 87 ${SCALE}`, `${EBML} 18538067 8c 1549a966 87 ${SCALE} ${CLUSTER}`]) {
    assert.equal(hexOf(withDuration(bytesOf(hex), 1500)), hexOf(bytesOf(hex)), hex);
  }
});
