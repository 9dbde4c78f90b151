// SPDX-License-Identifier: MIT
// What a screen reader says unasked: one polite live region for the whole page, so that sentences come one after the
// other and at a pace that can be listened to.

const PAUSE_MS = 1500;
// Then nobody who reads through the page comes across it any more.
const STAYS_MS = 8000;
// More would still be read when it has long been untrue.
const MOST_WAITING = 3;

/** @type {string[]} */
let waiting = [];
/** @type {ReturnType<typeof setTimeout> | undefined} */
let timer;
let freeMs = 0;

/** @param {string} sentence */
export function announce(sentence) {
  if (!sentence || waiting.includes(sentence)) return;
  waiting = [...waiting, sentence].slice(-MOST_WAITING);
  timer ??= setTimeout(speak, Math.max(50, freeMs - performance.now()));
}

function speak() {
  timer = undefined;
  const region = document.getElementById('spoken');
  if (!region) return;
  const said = document.createElement('span');
  said.textContent = waiting.join(' ');
  waiting = [];
  freeMs = performance.now() + PAUSE_MS;
  // A new element is said even when it has the words of the last one.
  region.replaceChildren(said);
  setTimeout(() => said.remove(), STAYS_MS);
}
