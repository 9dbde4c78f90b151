// SPDX-License-Identifier: MIT
// The page inside another page: messages in both directions, version 1 (docs/embedding.md). Replies go only to the
// embedding page, at the origin of its message. Calls can reach this page's document and searches, but not the
// browser's storage.

/** @typedef {import('../page/api.js').Gaitsmith} Gaitsmith */

export const VERSION = 1;
const EVENTS = /** @type {const} */ (['progress', 'done', 'error', 'changed', 'goal']);

/** @type {Record<string, (gaitsmith: Gaitsmith, args: any[]) => unknown>} */
const CALLS = {
  hello: (gaitsmith) => ({ version: VERSION, hash: gaitsmith.hash(), link: gaitsmith.link(), calls: Object.keys(CALLS), events: EVENTS }),
  open: (gaitsmith, [linkOrDocument]) => gaitsmith.open(linkOrDocument),
  link: (gaitsmith) => gaitsmith.link(),
  document: (gaitsmith) => gaitsmith.document(),
  hash: (gaitsmith) => gaitsmith.hash(),
  measures: (gaitsmith) => gaitsmith.measures(),
  arrange: (gaitsmith, [options]) => gaitsmith.arrange(options ?? {}),
  synthesize: async (gaitsmith, [options]) => cloneable(await gaitsmith.synthesize(options ?? {})),
  lab: (gaitsmith, [options]) => gaitsmith.lab(options ?? {}),
  pause: (gaitsmith) => gaitsmith.pause(),
  resume: (gaitsmith) => gaitsmith.resume(),
  stop: (gaitsmith) => gaitsmith.stop(),
  undo: (gaitsmith) => gaitsmith.undo(),
  redo: (gaitsmith) => gaitsmith.redo(),
  enqueue: (gaitsmith, [options]) => gaitsmith.enqueue(options ?? {}),
  queue: (gaitsmith) => gaitsmith.queue(),
  runQueue: (gaitsmith) => gaitsmith.runQueue(),
  clearQueue: (gaitsmith) => gaitsmith.clearQueue(),
  results: (gaitsmith) => gaitsmith.results(),
  showResult: (gaitsmith, [id]) => gaitsmith.showResult(String(id)),
  keep: (gaitsmith) => gaitsmith.keep(),
  commands: (gaitsmith) => gaitsmith.commands(),
  run: (gaitsmith, [id]) => gaitsmith.run(String(id)),
};

/** @param {Gaitsmith} gaitsmith */
export function startEmbedding(gaitsmith) {
  /** Origin of the embedding page, after its 'hello'. 'null' for a page from a file. @type {string | null} */
  let origin = null;
  const post = (/** @type {object} */ message, /** @type {string} */ to) => parent.postMessage({ gaitsmith: VERSION, ...message }, to === 'null' ? '*' : to);

  addEventListener('message', async ({ source, origin: from, data }) => {
    if (source !== parent || data?.gaitsmith === undefined || data.call === undefined) return;
    const { id } = data;
    try {
      if (data.gaitsmith !== VERSION) throw new Error(`this page speaks version ${VERSION} of the messages, not ${String(data.gaitsmith)}`);
      const call = Object.hasOwn(CALLS, data.call) ? CALLS[data.call] : null;
      if (!call) throw new Error(`there is no call ${String(data.call)}; there are ${Object.keys(CALLS).join(', ')}`);
      await gaitsmith.ready;
      if (data.call === 'hello') origin = from;
      post({ id, result: await call(gaitsmith, Array.isArray(data.args) ? data.args : []) }, from);
    } catch (error) {
      post({ id, error: error instanceof Error ? error.message : String(error) }, from);
    }
  });

  for (const event of EVENTS) {
    gaitsmith.addEventListener(event, (/** @type {any} */ { detail }) => {
      if (origin !== null) post({ event, detail: cloneable(detail) }, origin);
    });
  }
  // Any embedding page may receive 'ready'. Other messages are replies, or events after its 'hello'.
  gaitsmith.ready.then(() => post({ event: 'ready' }, '*'), () => {});
}

/** The detail in a form that a message can hold. @param {any} detail */
const cloneable = (detail) => (detail instanceof Error ? { message: detail.message } : detail);
