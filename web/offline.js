// SPDX-License-Identifier: MIT
// The page without a network: a service worker keeps one whole version of it. A new version is fetched whole beside it
// and takes over when no page shows the old one any more, or when the reader asks for it and this is the only page. So
// nobody ever runs half of each.
import { element, onClick, setText } from './dom.js';
import { tr } from './language.js';
import { scriptAddress } from './trusted.js';

/** @param {{leave: () => void}} hooks  leave: called before the page reloads itself */
export async function startOffline({ leave }) {
  // A page inside another page keeps nothing.
  if (window.top !== window || !navigator.serviceWorker) return;
  try {
    const registration = await navigator.serviceWorker.register(scriptAddress('service_worker.js'), { updateViaCache: 'none' });
    follow(registration);
    // Somebody may leave the page open for weeks.
    setInterval(() => { if (navigator.onLine) registration.update().catch(() => {}); }, 3600e3);
  } catch {
    return; // not served securely, storage forbidden, or no such file: the page works all the same
  }

  /** @param {ServiceWorkerRegistration} registration */
  function follow(registration) {
    const offer = () => {
      // Without one before it, it is the first, and what runs is its own version.
      if (registration.waiting && navigator.serviceWorker.controller) show(registration.waiting);
    };
    offer();
    registration.addEventListener('updatefound', () => {
      registration.installing?.addEventListener('statechange', offer);
    });
  }

  /** @param {ServiceWorker} waiting */
  function show(waiting) {
    element('update').hidden = false;
    setText(element('update-text'), tr('A new version of Gaitsmith is here.'));
    onClick('update-close', () => { element('update').hidden = true; });
    onClick('update-go', () => {
      const { port1, port2 } = new MessageChannel();
      port1.onmessage = ({ data }) => {
        if (data.alone) return; // controllerchange follows
        setText(element('update-text'), tr('Other tabs show Gaitsmith, too: close them, and press Update again. Without that the new version comes with the next visit.'));
      };
      navigator.serviceWorker.addEventListener('controllerchange', () => {
        leave();
        location.reload();
      }, { once: true });
      waiting.postMessage({ type: 'take-over' }, [port2]);
    });
  }
}
