// SPDX-License-Identifier: MIT
// Asks the service worker to store the book, for the playground and for the book's own pages.

const REST_MS = 3000;

/** Whether the reader's browser does not ask to save data. */
export const mayStoreBook = () => !(/** @type {any} */ (navigator).connection?.saveData);

/** Resolved when the page has been idle. @returns {Promise<void>} */
export async function untilIdle() {
  await new Promise((resolve) => setTimeout(resolve, REST_MS));
  if ('requestIdleCallback' in window) await new Promise((resolve) => requestIdleCallback(resolve));
}

/**
 * Stores what is missing of the book in English and in the page's language, in the service worker that this page has registered.
 * @param {string} language
 * @returns {Promise<{complete: boolean, fetched: boolean}>} complete: all is stored; fetched: something was missing
 */
export async function storeBook(language) {
  const { active } = await navigator.serviceWorker.ready;
  return new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = ({ data }) => resolve(data);
    active?.postMessage({ type: 'store-book', language }, [port2]);
  });
}
