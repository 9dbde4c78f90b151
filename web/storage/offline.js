// SPDX-License-Identifier: MIT
// The page without a network: a service worker keeps one whole version of it. A new version is fetched whole beside it
// and takes over when no page shows the old one any more, or when the reader asks for it and this is the only page. So
// nobody ever runs half of each.
import { element, onClick, setText } from '../browser/dom.js';
import { tr } from '../languages/language.js';
import { scriptAddress } from '../browser/trusted.js';

const LOOK_EVERY_MS = 3600e3; // the page may stay open for weeks

/** The version that waits to take over. @type {ServiceWorker | null} */
let waiting = null;

/** @param {{leave: () => void}} hooks  leave: called before the page reloads itself */
export async function startOffline({ leave }) {
  try {
    // A page inside another page keeps nothing.
    if (window.top !== window || !navigator.serviceWorker) return;
    const registration = await navigator.serviceWorker.register(scriptAddress('service_worker.js'), { updateViaCache: 'none' });
    follow(registration, leave);
  } catch {
    return; // not served securely, storage forbidden, or no such file: the page works all the same
  }
}

/** @param {ServiceWorkerRegistration} registration @param {() => void} leave */
function follow(registration, leave) {
  const offer = () => {
    waiting = registration.waiting;
    // Without an active worker it is the first version, and does not wait.
    if (!waiting || !registration.active) return;
    element('update').hidden = false;
    setText(element('update-text'), tr('A new version of Gaitsmith is here.'));
  };
  // One may be on its way since before this script ran.
  const watch = () => registration.installing?.addEventListener('statechange', offer);
  offer();
  watch();
  registration.addEventListener('updatefound', watch);
  setInterval(() => { if (navigator.onLine) registration.update().catch(() => {}); }, LOOK_EVERY_MS);

  let asked = false;
  onClick('update-close', () => { element('update').hidden = true; });
  onClick('update-go', () => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = ({ data }) => {
      asked = data.alone;
      if (!asked) setText(element('update-text'), tr('Other tabs show Gaitsmith, too: close them, and press Update again. Without that the new version comes with the next visit.'));
    };
    // It has taken over once it is active; then a reload is the new version.
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
