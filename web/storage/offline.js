// SPDX-License-Identifier: MIT
// The page without a network. A service worker stores one complete version of it, and later the book. A new version is first downloaded
// completely, beside the old one. It takes over when no page uses the old one, or on request if this is the only page.
// So a page never mixes two versions.
import { element, onClick, setText } from '../browser/dom.js';
import { language, tr } from '../languages/language.js';
import { scriptAddress } from '../browser/trusted.js';
import { mayStoreBook, storeBook, untilIdle } from './store_book.js';

const CHECK_EVERY_MS = 3600e3; // the page may stay open for weeks

/** The version that waits to take over. @type {ServiceWorker | null} */
let waiting = null;

/**
 * leave: called before the page reloads itself; firstMotion: resolved when there is one; busy: whether a search runs;
 * say: shows a sentence.
 * @typedef {{leave: () => void, firstMotion: Promise<unknown>, busy: () => boolean, say: (sentence: string) => void}} Hooks
 */

/** @param {Hooks} hooks */
export async function startOffline(hooks) {
  try {
    // Pages inside other pages store nothing.
    if (window.top !== window || !navigator.serviceWorker) return;
    const registration = await navigator.serviceWorker.register(scriptAddress('service_worker.js'), { updateViaCache: 'none' });
    follow(registration, hooks.leave);
    if (mayStoreBook()) await storeLater(hooks);
  } catch {
    return; // no secure connection, no storage, or no such file: the page still works, but only online
  }
}

/** Stores the book when nothing else needs the processor or the network. @param {Hooks} hooks */
async function storeLater({ firstMotion, busy, say }) {
  await firstMotion;
  do await untilIdle(); while (busy());
  const { complete, fetched } = await storeBook(language());
  if (complete && fetched) say(tr('Everything is stored now. Gaitsmith works without a network, with its lessons and its gallery.'));
}

/** @param {ServiceWorkerRegistration} registration @param {() => void} leave */
function follow(registration, leave) {
  const offer = () => {
    waiting = registration.waiting;
    // The first version does not wait, because no other version is active.
    if (!waiting || !registration.active) return;
    element('update').hidden = false;
    setText(element('update-text'), tr('A new version of Gaitsmith is ready.'));
  };
  // An installation may have started before this script.
  const watch = () => registration.installing?.addEventListener('statechange', offer);
  offer();
  watch();
  registration.addEventListener('updatefound', watch);
  setInterval(() => { if (navigator.onLine) registration.update().catch(() => {}); }, CHECK_EVERY_MS);

  let asked = false;
  onClick('update-close', () => { element('update').hidden = true; });
  onClick('update-go', () => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = ({ data }) => {
      asked = data.alone;
      if (!asked) setText(element('update-text'), tr('Gaitsmith is open in other tabs. Close them, then press Update again. Otherwise your next visit brings the new version.'));
    };
    // When the new version is active, reload the page to use it.
    const next = waiting;
    next?.addEventListener('statechange', () => {
      if (!asked || next.state !== 'activated') return;
      asked = false;
      leave();
      location.reload();
    });
    next?.postMessage({ type: 'take-over' }, [port2]);
  });
}
