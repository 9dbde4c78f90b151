// SPDX-License-Identifier: MIT
// Stores the playground and the book for use without a network, also if the reader opens only the book. The book's first
// page says when everything is stored.
import { mayStoreBook, storeBook, untilIdle } from '../storage/store_book.js';

const note = document.getElementById('stored');

/** In a lesson the playground beside it starts first. */
async function untilStarted() {
  const frame = /** @type {HTMLIFrameElement | null} */ (document.getElementById('playground'));
  if (!frame) return;
  await new Promise((resolve) => addEventListener('message', ({ source, data }) => {
    if (source === frame.contentWindow && data?.gaitsmith === 1) resolve(null);
  }));
}

async function start() {
  if (window.top !== window || !navigator.serviceWorker || !mayStoreBook()) return;
  await untilStarted();
  await untilIdle();
  await navigator.serviceWorker.register(new URL('../service_worker.js', import.meta.url), { updateViaCache: 'none' });
  const { complete } = await storeBook(document.documentElement.lang);
  if (complete && note) note.hidden = false;
}

start().catch(() => {}); // no secure connection or no storage: the book still works, but only online
