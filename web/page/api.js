// SPDX-License-Identifier: MIT
// window.gaitsmith: the API for scripts, embedding pages and tests. docs/embedding.md documents it.

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

/** The parts of the page. @typedef {{app: App, searches: import('../search/searches.js').Searches, lab: import('./lab.js').Lab, arrangement: import('./arrangement.js').Arrangement, address: import('../share/address.js').Address, commands: import('./commands.js').Commands, canvas: HTMLCanvasElement}} Parts */
/** The result of a search. @typedef {{report: SearchReport, hash: string, link: string}} SearchResult */

// The document changes at every frame of a drag. The 'changed' event waits until it rests.
const REST_MS = 250;

/**
 * Events: 'progress' (detail: SearchReport), 'done' (detail: SearchResult), 'error' (detail: Error), 'changed' (detail:
 * {title}), 'goal' (detail: {goal, met, measures}).
 * @typedef {'progress' | 'done' | 'error' | 'changed' | 'goal'} EventName
 */

export class Gaitsmith extends EventTarget {
  /** @type {Parts | null} */
  #parts = null;
  #fps = 0;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #changedTimer;
  /** @type {(api: Gaitsmith) => void} */
  #resolve = () => {};
  /** @type {(error: Error) => void} */
  #reject = () => {};

  /** Resolved when the first frame is on the screen. Rejected if the page cannot run here. @type {Promise<Gaitsmith>} */
  ready = new Promise((resolve, reject) => {
    this.#resolve = resolve;
    this.#reject = reject;
  });

  constructor() {
    super();
    this.ready.catch(() => {}); // the page itself shows the error
  }

  /**
   * Opens a link, a link's payload, JSON text or a document object. If it is invalid, throws core's sentence and
   * changes nothing.
   * @param {string | object} linkOrDocument
   */
  open(linkOrDocument) {
    const text = typeof linkOrDocument === 'string' ? linkOrDocument : JSON.stringify(linkOrDocument);
    const fault = this.#loadedParts().app.show(text);
    if (fault) throw new Error(fault);
  }

  /** The complete link of the current document. */
  link() { return this.#loadedParts().address.link(); }
  /** The current document. @returns {DocumentJson} */
  document() { return this.#loadedParts().app.document(); }
  /** The trajectory hash of the shown motion: 16 hexadecimal digits. */
  hash() { return this.#loadedParts().app.hash(); }

  canUndo() { return this.#loadedParts().app.canUndo(); }
  canRedo() { return this.#loadedParts().app.canRedo(); }
  /** Undoes one gesture, one search or one opening. @returns {boolean} whether there was a step to undo */
  undo() {
    const { app } = this.#loadedParts();
    const can = app.canUndo();
    app.undo();
    return can;
  }

  /** @returns {boolean} whether there was a step to redo */
  redo() {
    const { app } = this.#loadedParts();
    const can = app.canRedo();
    app.redo();
    return can;
  }

  /**
   * Searches a motion for the current document, after stopping a running search.
   * @param {SynthesizeOptions} [options]
   * @returns {Promise<SearchResult>} resolved when this search is done, stopped, or replaced by the next one
   */
  async synthesize(options = {}) {
    const { app, searches } = this.#loadedParts();
    const fault = app.synthesize(options);
    if (fault) throw new Error(fault);
    return this.#result(await searches.ended);
  }

  /**
   * Runs the lab: several algorithms on the current document's problem, each with several seeds. Stops a running lab
   * first. Rejected while a search runs. Does not change the shown motion.
   * @param {LabOptions} [options]
   * @returns {Promise<LabResult>} resolved when all trials are finished or the lab was stopped
   */
  async lab(options = {}) { return this.#loadedParts().lab.run(options); }

  /**
   * Adds a search of the current document, with these options, to the queue.
   * @param {SynthesizeOptions} [options]
   */
  enqueue(options = {}) {
    const fault = this.#loadedParts().app.enqueue(options);
    if (fault) throw new Error(fault);
  }

  /** The waiting searches, next one first. @returns {QueuedSearch[]} */
  queue() { return this.#loadedParts().app.queue(); }
  /** Runs the searches in the queue. @returns {boolean} false: the queue is empty, or a search or the lab runs */
  runQueue() { return this.#loadedParts().app.run('queue/run'); }
  /** @returns {boolean} false: the queue was empty */
  clearQueue() { return this.#loadedParts().app.run('queue/clear'); }
  /** The results of searches and the saved motions, newest first, with complete links. @returns {FoundMotion[]} */
  results() {
    const { app, address } = this.#loadedParts();
    return app.found().map((found) => ({ ...found, link: address.linkOf(found.link) }));
  }

  /** Shows a result as it was found. @param {string} id @returns {boolean} false: there is no such result */
  showResult(id) { return this.#loadedParts().app.showFound(id); }
  /** Saves the current motion to the results. @returns {boolean} false: there is no motion */
  keep() { return this.#loadedParts().app.run('found/keep'); }

  /** The maximum frame rate. 0: the display's. */
  get fps() { return this.#fps; }
  set fps(perSecond) {
    this.#fps = perSecond > 0 ? perSecond : 0;
    this.#loadedParts().app.setFrameRate(this.#fps);
  }

  /**
   * Sets the shown panels, the locks and the goal. Options that are left out stay as they are.
   * @param {ArrangementOptions} options  as in the address
   * @returns {Promise<void>} rejected with a sentence, and nothing changed, if the options are invalid
   */
  async arrange(options) { return this.#loadedParts().arrangement.set(options); }
  /** The shown motion's measures: distance, travel, style terms, where it comes from, sense, rules, broke. null: it has no such number. @returns {Record<string, number | string | boolean | null>} */
  measures() {
    const { terms, ...others } = this.#loadedParts().app.measures();
    return { ...Object.fromEntries(terms.map(({ name, value }) => [name, value])), ...others };
  }

  pause() { this.#loadedParts().app.pause(); }
  resume() { this.#loadedParts().app.resume(); }
  stop() { this.#loadedParts().app.stop(); }

  /**
   * @param {EventName} type
   * @param {(event: CustomEvent) => void} listener
   */
  on(type, listener) { this.addEventListener(type, /** @type {EventListener} */ (listener)); }

  /** @param {EventName} type @param {(event: CustomEvent) => void} listener */
  off(type, listener) { this.removeEventListener(type, /** @type {EventListener} */ (listener)); }

  /** The widgets on the canvas, with rectangles in CSS pixels of the page. @returns {Widget[]} */
  widgets() {
    const { app, canvas } = this.#loadedParts();
    const { left, top } = canvas.getBoundingClientRect();
    return app.widgets().map((widget) => ({
      ...widget,
      rect: { ...widget.rect, x: widget.rect.x + left, y: widget.rect.y + top },
    }));
  }

  /** The palette's commands. @returns {{id: string, group: string, title: string, keys: string[], whyNot: string}[]} */
  commands() {
    return this.#loadedParts().commands.all().map(({ id, group, title, keys, whyNot = '' }) => ({ id, group, title, keys, whyNot }));
  }

  /** Runs a command of the palette. @param {string} id @returns {boolean} false: there is no such command, or it is unavailable */
  run(id) {
    const command = this.#loadedParts().commands.all().find((candidate) => candidate.id === id);
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
  /** Call after every change of the document. @param {string} title */
  documentChanged(title) {
    clearTimeout(this.#changedTimer);
    this.#changedTimer = setTimeout(() => this.dispatchEvent(new CustomEvent('changed', { detail: { title } })), REST_MS);
  }

  /** @param {Error} error */
  cannotRun(error) { this.#reject(error); }

  /** @param {SearchReport} report @returns {SearchResult} */
  #result(report) { return { report, hash: this.hash(), link: this.link() }; }

  /**
   * The result of a queued search, which is perhaps not on the stage. Hash and link are empty if nothing was found.
   * @param {SearchReport} report @returns {SearchResult}
   */
  #newest(report) {
    const newest = this.results().find(({ score }) => score !== null && Math.fround(score) === report.bestFitness);
    return { report, hash: newest?.hash ?? '', link: newest?.link ?? '' };
  }

  #loadedParts() {
    if (!this.#parts) throw new Error('the page is still loading: await gaitsmith.ready');
    return this.#parts;
  }
}
