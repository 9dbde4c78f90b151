// SPDX-License-Identifier: MIT
// The links that the workbench has had in its address, so that a bookmark of one opens the workbench again. Stored as
// fingerprints, the oldest of them are removed first.
import { remember, remembered } from '../browser/storage.js';

const KEY = 'gaitsmith-own';
const MAX_ADDRESSES = 400;

/** @param {string} payload */
export const isOwnAddress = (payload) => stored().includes(fingerprint(payload));

/** @param {string} payload */
export function addOwnAddress(payload) {
  const mark = fingerprint(payload);
  const others = stored().filter((other) => other !== mark);
  remember(KEY, [...others, mark].slice(-MAX_ADDRESSES).join());
}

const stored = () => (remembered(KEY) ?? '').split(',');

/** Tells long texts apart without keeping them. @param {string} text */
export function fingerprint(text) {
  let sum = 0;
  for (let i = 0; i < text.length; i++) sum = (Math.imul(sum, 31) + text.charCodeAt(i)) | 0;
  return `${text.length} ${sum}`;
}
