// SPDX-License-Identifier: MIT
// window.gaitsmith: the page for scripts, for pages that embed it and for tests. docs/embedding.md documents it.

/** @typedef {import('../app/app.js').App} App */
/** @typedef {import('../app/app.js').DocumentJson} DocumentJson */
/** @typedef {import('../app/app.js').FoundMotion} FoundMotion */
/** @typedef {import('../app/app.js').LabOptions} LabOptions */
/** @typedef {import('../app/app.js').QueuedSearch} QueuedSearch */
/** @typedef {import('../app/app.js').SynthesizeOptions} SynthesizeOptions */
/** @typedef {import('../app/app.js').Widget} Widget */
/** @typedef {import('./arrangement.js').ArrangementOptions} ArrangementOptions */
/** @typedef {import('./lab.js').LabResult} LabResult */
/** @typedef {import('../search/messages.js').SearchReport} SearchReport */

/** What the page is made of. @typedef {{app: App, searches: import('../search/searches.js').Searches, lab: import('./lab.js').Lab, arrangement: import('./arrangement.js').Arrangement, address: import('../share/address.js').Address, commands: import('./commands.js').Commands, canvas: HTMLCanvasElement}} Parts */
/** What a search came to. @typedef {{report: SearchReport, hash: string, link: string}} SearchResult */

// The document changes at every frame of a drag.
const REST_MS = 250;

/**
 * Events: 'progress' (detail: SearchReport), 'done' (detail: SearchResult), 'error' (detail: Error), 'changed' (detail: {title}), 'goal'
 * (detail: {goal, met, measures}).
 * @typedef {'progress' | 'done' | 'error' | 'changed' | 'goal'} EventName
 */

export class Gaitsmith extends EventTarget {
  /** @type {Parts | null} */
  #parts = null;
  #fps = 0;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #changed;
  /** @type {(api: Gaitsmith) => void} */
  #resolve = () => {};
  /** @type {(error: Error) => void} */
  #reject = () => {};

  /** Resolved when the first frame is on the screen; rejected when the page cannot run here. @type {Promise<Gaitsmith>} */
  ready = new Promise((resolve, reject) => {
    this.#resolve = resolve;
    this.#reject = reject;
  });

  constructor() {
    super();
    this.ready.catch(() => {}); // the page itself shows the error
  }

  /**
   * Opens a link, a link's payload, JSON text or a document object. Throws core's sentence if it is no good; then
   * nothing has changed.
   * @param {string | object} linkOrDocument
   */
  open(linkOrDocument) {
    const text = typeof linkOrDocument === 'string' ? linkOrDocument : JSON.stringify(linkOrDocument);
    const fault = this.#need().app.open(text);
    if (fault) throw new Error(fault);
  }

  /** The whole link of the present document. */
  link() { return this.#need().address.link(); }
  /** The present document. @returns {DocumentJson} */
  document() { return this.#need().app.document(); }
  /** The trajectory hash of the motion shown: 16 hexadecimal digits. */
  hash() { return this.#need().app.hash(); }

  canUndo() { return this.#need().app.canUndo(); }
  canRedo() { return this.#need().app.canRedo(); }
  /** One step back: what one gesture, one search or one opening changed. @returns {boolean} whether there was one */
  undo() {
    const { app } = this.#need();
    const can = app.canUndo();
    app.undo();
    return can;
  }
  /** @returns {boolean} whether there was a step to do again */
  redo() {
    const { app } = this.#need();
    const can = app.canRedo();
    app.redo();
    return can;
  }

  /**
   * Searches a motion for the present document; one that runs is stopped first.
   * @param {SynthesizeOptions} [options]
   * @returns {Promise<SearchResult>} when this search is done or was stopped, be it by the next one
   */
  async synthesize(options = {}) {
    const { app, searches } = this.#need();
    const fault = app.synthesize(options);
    if (fault) throw new Error(fault);
    return this.#result(await searches.ended);
  }

  /**
   * Runs the lab: several algorithms on the present document's problem, each with several seeds. One that runs is
   * stopped first; rejected while a search runs. The shown motion stays.
   * @param {LabOptions} [options]
   * @returns {Promise<LabResult>} when all trials are finished or it was stopped
   */
  async lab(options = {}) { return this.#need().lab.run(options); }

  /**
   * Adds a search to the queue: the present document's with these options, as it is now.
   * @param {SynthesizeOptions} [options]
   */
  enqueue(options = {}) {
    const fault = this.#need().app.enqueue(options);
    if (fault) throw new Error(fault);
  }
  /** What waits in the queue, the next one first. @returns {QueuedSearch[]} */
  queue() { return this.#need().app.queue(); }
  /** Begins with the first that waits; the others follow. @returns {boolean} false: nothing waits, or something runs */
  runQueue() { return this.#need().app.run('queue/run'); }
  /** @returns {boolean} whether anything waited */
  clearQueue() { return this.#need().app.run('queue/clear'); }
  /** What searches have found and a person has kept, the newest first; each with its whole link. @returns {FoundMotion[]} */
  results() {
    const { app, address } = this.#need();
    return app.found().map((found) => ({ ...found, link: address.linkOf(found.link) }));
  }
  /** Shows a result as it was found; Undo brings back what was there. @param {string} id @returns {boolean} false: there is none */
  showResult(id) { return this.#need().app.showFound(id); }
  /** Keeps the present motion among the results. @returns {boolean} false: there is no motion */
  keep() { return this.#need().app.run('found/keep'); }

  /** Most frames drawn per second; 0: as many as the display shows. */
  get fps() { return this.#fps; }
  set fps(perSecond) {
    this.#fps = perSecond > 0 ? perSecond : 0;
    this.#need().app.setFrameRate(this.#fps);
  }

  /**
   * Shows some panels, locks some parts, sets a goal; what is left out stays as it is.
   * @param {ArrangementOptions} options  as in the address
   * @returns {Promise<void>} rejected with a sentence; then nothing has changed
   */
  async arrange(options) { return this.#need().arrangement.set(options); }
  /** The motion shown in numbers: distance, travel, the terms of its style, sense, rules, broke. @returns {Record<string, number | string | boolean>} */
  measures() {
    const { terms, ...others } = this.#need().app.measures();
    return { ...Object.fromEntries(terms.map(({ name, value }) => [name, value])), ...others };
  }

  pause() { this.#need().app.pause(); }
  resume() { this.#need().app.resume(); }
  stop() { this.#need().app.stop(); }

  /**
   * @param {EventName} type
   * @param {(event: CustomEvent) => void} listener
   */
  on(type, listener) { this.addEventListener(type, /** @type {EventListener} */ (listener)); }

  /** @param {EventName} type @param {(event: CustomEvent) => void} listener */
  off(type, listener) { this.removeEventListener(type, /** @type {EventListener} */ (listener)); }

  /** Every widget on the canvas, its rectangle in CSS pixels of the page. @returns {Widget[]} */
  widgets() {
    const { app, canvas } = this.#need();
    const { left, top } = canvas.getBoundingClientRect();
    return app.widgets().map((widget) => ({
      ...widget,
      rect: { ...widget.rect, x: widget.rect.x + left, y: widget.rect.y + top },
    }));
  }

  /** What the palette offers now. @returns {{id: string, group: string, title: string, keys: string[], whyNot: string}[]} */
  commands() {
    return this.#need().commands.all().map(({ id, group, title, keys, whyNot = '' }) => ({ id, group, title, keys, whyNot }));
  }

  /** Does what a command of the palette does. @param {string} id @returns {boolean} false: there is none, or not now */
  run(id) {
    const command = this.#need().commands.all().find((candidate) => candidate.id === id);
    if (!command || command.whyNot) return false;
    command.run();
    return true;
  }

  // For page.js.

  /** @param {Parts} parts */
  begin(parts) {
    this.#parts = parts;
    const forward = (/** @type {string} */ type, /** @type {any} */ detail) => this.dispatchEvent(new CustomEvent(type, { detail }));
    parts.searches.addEventListener('progress', (event) => forward('progress', /** @type {CustomEvent} */ (event).detail));
    parts.searches.addEventListener('done', (event) => {
      const { report, queued } = /** @type {CustomEvent} */ (event).detail;
      forward('done', queued ? this.#newest(report) : this.#result(report));
    });
    parts.searches.addEventListener('error', (event) => forward('error', /** @type {CustomEvent} */ (event).detail));
  }
  firstFrame() { this.#resolve(this); }
  /** The document is another one now. @param {string} title */
  documentChanged(title) {
    clearTimeout(this.#changed);
    this.#changed = setTimeout(() => this.dispatchEvent(new CustomEvent('changed', { detail: { title } })), REST_MS);
  }
  /** @param {Error} error */
  cannotRun(error) { this.#reject(error); }

  /** @param {SearchReport} report @returns {SearchResult} */
  #result(report) { return { report, hash: this.hash(), link: this.link() }; }

  /** Of a search of the queue, which need not be on the stage; nothing where it has found nothing. @param {SearchReport} report @returns {SearchResult} */
  #newest(report) {
    const newest = this.results().find(({ score }) => score !== null && Math.fround(score) === report.bestFitness);
    return { report, hash: newest?.hash ?? '', link: newest?.link ?? '' };
  }

  #need() {
    if (!this.#parts) throw new Error('the page is still loading: await gaitsmith.ready');
    return this.#parts;
  }
}
