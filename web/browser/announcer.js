// SPDX-License-Identifier: MIT
// Announcements by screen readers. The whole page has one polite live region, so that sentences do not interrupt each
// other, and come slowly enough to be understood.

const PAUSE_MS = 1500;
// Later a person who reads the page could find the outdated sentence.
const REMOVE_MS = 8000;
// More sentences would be outdated before they are read.
const MAX_WAITING = 3;

/** @type {string[]} */
let waiting = [];
/** @type {ReturnType<typeof setTimeout> | undefined} */
let timer;
let freeMs = 0;

/** @param {string} sentence */
export function announce(sentence) {
  if (!sentence || waiting.includes(sentence)) return;
  waiting = [...waiting, sentence].slice(-MAX_WAITING);
  timer ??= setTimeout(announceWaiting, Math.max(50, freeMs - performance.now()));
}

/** Takes back what is not read yet: after a change of language its words would be read with the wrong voice. */
export function withdrawAnnouncements() {
  waiting = [];
  document.getElementById('spoken')?.replaceChildren();
}

function announceWaiting() {
  timer = undefined;
  const region = document.getElementById('spoken');
  if (!region || waiting.length === 0) return;
  const span = document.createElement('span');
  span.textContent = waiting.join(' ');
  waiting = [];
  freeMs = performance.now() + PAUSE_MS;
  // A new element is announced even if its text is the same.
  region.replaceChildren(span);
  setTimeout(() => span.remove(), REMOVE_MS);
}
