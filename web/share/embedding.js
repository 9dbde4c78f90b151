// SPDX-License-Identifier: MIT
// The page inside another page: messages in both directions, version 1 (docs/embedding.md). Only the page around this one
// is answered, at the origin it speaks from; what it can ask for is this page's document and searches, never what the
// browser keeps.

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
  /** Where the page around is from, once it has said hello; a page from a file has no origin to send to. @type {string | null} */
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
  // Any page around this one may learn that it is ready. Everything else is sent only as an answer.
  gaitsmith.ready.then(() => post({ event: 'ready' }, '*'), () => {});
}

/** What a message can carry: of an error its sentence. @param {any} detail */
const cloneable = (detail) => (detail instanceof Error ? { message: detail.message } : detail);
