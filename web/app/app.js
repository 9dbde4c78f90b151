// SPDX-License-Identifier: MIT
// The page's interface to the application in the canvas. Copies text and numbers to and from its memory.
import { NO_REPORT } from './no_report.js';
import { trLater } from '../languages/language.js';

/** @typedef {import('./app_module.js').AppModule} AppModule */
/** @typedef {import('../search/messages.js').SearchReport} SearchReport */

/**
 * A visible widget of the canvas.
 * @typedef {object} Widget
 * @property {string} id     stable, e.g. "search/start"
 * @property {string} label
 * @property {string} role   an ARIA role
 * @property {string} value  as shown
 * @property {Record<string, boolean>} state
 * @property {{x: number, y: number, width: number, height: number}} rect  CSS pixels
 */

/**
 * Options of a search. Those that are left out come from the document.
 * @typedef {object} SynthesizeOptions
 * @property {string} [algorithm]   a name of the catalogue's algorithms
 * @property {string} [sense]       a name of the catalogue's control_modes
 * @property {number} [period]       of the timer, seconds
 * @property {number} [evaluations]
 * @property {number} [seed]
 * @property {number} [workers]
 */

/**
 * Options of the lab. Those that are left out come from the Lab panel.
 * @typedef {object} LabOptions
 * @property {string[]} [algorithms]  as of SynthesizeOptions
 * @property {number} [trials]        of each algorithm, 2 to 50
 * @property {number} [evaluations]   of each trial, up to 1,000,000
 * @property {number} [firstSeed]
 */

/** A waiting search. @typedef {{title: string, algorithm: string, seed: number, evaluations: number}} QueuedSearch */
/**
 * A result of a search, or a saved motion.
 * @typedef {object} FoundMotion
 * @property {string} id
 * @property {string} title
 * @property {'done' | 'stopped' | 'failed' | 'by-hand'} origin  how its search ended; by-hand: saved by a person
 * @property {number | null} score   null: nothing moves, or the simulation failed
 * @property {string} algorithm
 * @property {number} seed
 * @property {number} evaluations    of its search
 * @property {boolean} kept          whether it is never removed to make room
 * @property {number} when           seconds since 1970
 * @property {string} hash           of its trajectory
 * @property {string} link           payload of its document
 */

/** The part of a document's search that the page reads. @typedef {{algorithm?: string, body?: string}} SearchJson */
/**
 * A document as JSON (docs/formats.md): the parts that the page reads.
 * @typedef {{model?: number, title?: string, figure: {name?: string, rods?: object[], nodes?: object[], springs?: SpringJson[]}, kind?: string, senses?: {kind?: string}, search?: SearchJson,
 *   start?: object, controllers?: object[], timeline?: {controller?: number}[], rules?: number, lineage?: import('../breed/family.js').Lineage,
 *   environment?: {slope_rad?: number, gravity_mps2?: number, ground?: {x_m?: number, y_m?: number}[]}, pushes?: {endpoint: number, impulse_x_ns: number, impulse_y_ns: number}[],
 *   task?: {kind?: string, duration_steps?: number, weights?: Record<string, number>, shown?: ShownJson}, duration_steps?: number, plan?: {solved?: {unknowns?: number[]}}}} DocumentJson
 * @typedef {{from?: number, to?: number, stiffness_npm?: number, rest?: number, min_rest?: number, max_rest?: number}} SpringJson
 * @typedef {{way?: {step?: number, x_m?: number, y_m?: number}[], pose_step?: number, pose?: {angle_rad?: number}[]}} ShownJson
 */

/**
 * The values of a slider or a field. step 0: any value.
 * @typedef {{low: number, high: number, step: number, now: number}} WidgetRange
 */
/** A widget for the mirror, perhaps out of sight, or a text ("heading", "paragraph"). hint: what it does. @typedef {Widget & {range?: WidgetRange, hint?: string, part: number}} MirrorWidget */
/** A named part of the canvas. parent: index of the enclosing part, or -1. @typedef {{id: string, label: string, role: string, parent: number}} MirrorPart */
/** keyboard: whether the focus ring is shown; waiting: a request to a widget is not done yet. @typedef {{keyboard: boolean, waiting: boolean, parts: MirrorPart[], widgets: MirrorWidget[]}} MirrorState */

/** A measure of a motion. @typedef {{name: string, label: string, unit: string, decimals: number, value: number | null}} Measure */
/** The measures of the shown motion. sense: the controller's, or empty; controller: 'opened', 'changed', 'new', or empty; world: 'usual', 'earth' (usual but for limited joints) or 'other'; broke: the simulation failed; preview: not the document's motion yet. @typedef {{terms: Measure[], sense: string, controller: string, world: string, rules: number, broke: boolean, preview: boolean}} Measures */

/** A command of shell/session/commands.h. @typedef {{id: string, group: string, title: string, whyNot: string, keys: string[]}} CanvasCommand */

export class App {
  /** @param {AppModule} module */
  constructor(module) {
    this.module = module;
  }

  /** Whether the browser has WebGL. If not, no other method may be called. */
  running() { return this.module._gs_running() !== 0; }

  /**
   * Opens a document in the workbench.
   * @param {string} text  JSON, a link, or the payload of one
   * @param {boolean} [bred]  from the open document, so that goals count it as new
   * @returns {string} empty, or core's sentence about the error and its place, with nothing changed
   */
  open(text, bred = false) {
    const fault = this.show(text, bred);
    if (!fault) this.setViewing(false);
    return fault;
  }

  /** Like open, but in the viewer if that is shown. @param {string} text @param {boolean} [bred] @returns {string} */
  show(text, bred = false) { return this.#with(text, (at, bytes) => this.#text(this.module._gs_open(at, bytes, Number(bred)))); }
  /** Shows the open motion in the viewer, or leaves it for the workbench. @param {boolean} viewing */
  setViewing(viewing) { this.module._gs_set_viewing(viewing ? 1 : 0); }
  /** Whether the viewer is shown. */
  viewing() { return this.module._gs_viewing() !== 0; }

  /** @returns {string} indented JSON */
  documentText() { return this.#text(this.module._gs_document_json()); }
  /** @returns {DocumentJson} */
  document() { return JSON.parse(this.documentText()); }
  /** The payload of the document's link: the part after '#'. */
  link() { return this.#text(this.module._gs_link()); }
  /** The hash of the shown motion's trajectory: 16 hexadecimal digits. */
  hash() { return this.#text(this.module._gs_hash()); }
  title() { return this.#text(this.module._gs_title()); }

  /** The visible widgets, with rectangles relative to the canvas. @returns {Widget[]} */
  widgets() { return JSON.parse(this.#text(this.module._gs_widgets())); }

  /** All widgets and parts, in drawing order. @returns {MirrorState | null} null: unchanged since the last call */
  mirror() {
    const text = this.#text(this.module._gs_mirror());
    return text ? JSON.parse(text) : null;
  }

  // Requests to a widget, which happen in the next frame. They return false if the widget is not on the canvas or is
  // disabled. `again`: repeated by a held key, so that it adds no step to Undo.

  /** Like a click. @param {string} id */
  activate(id) { return this.#with(id, (at) => this.module._gs_activate(at)) !== 0; }
  /** Like arrow keys. @param {string} id @param {number} steps @param {boolean} again */
  step(id, steps, again) { return this.#with(id, (at) => this.module._gs_step(at, steps, again ? 1 : 0)) !== 0; }
  /** @param {string} id @param {number} value  in its WidgetRange @param {boolean} again */
  setValue(id, value, again) { return this.#with(id, (at) => this.module._gs_set_value(at, value, again ? 1 : 0)) !== 0; }
  /** @param {string} id @param {boolean} ring  whether to show the focus ring */
  focus(id, ring) { return this.#with(id, (at) => this.module._gs_focus(at, ring ? 1 : 0)) !== 0; }
  /** Call when the focus moves to another part of the page. */
  unfocus() { this.module._gs_unfocus(); }
  /** Closes an open list. Returns false if there is none. */
  dismiss() { return this.module._gs_dismiss() !== 0; }

  /** The shown moment in words, such as "Paused at 2.31 s, 1.84 m to the right. Rule 3 acts." */
  moment() { return this.#text(this.module._gs_moment()); }
  /** The shown moment in full: also ground contacts, why the rule acts, and the score. */
  description() { return this.#text(this.module._gs_description()); }
  playing() { return this.module._gs_playing() !== 0; }

  /** Uses the canvas's typeface for the rest of the page, so that it is downloaded only once. */
  lendTypeface() {
    for (const [semibold, weight] of [[0, '400'], [1, '600']]) {
      const at = this.module._gs_typeface(Number(semibold));
      const bytes = this.module.HEAPU8.slice(at, at + this.module._gs_typeface_size(Number(semibold)));
      document.fonts.add(new FontFace('Inter', bytes, { weight: String(weight) }));
    }
  }

  /** @param {import('../page/theme.js').Look} look */
  setTheme({ palette, scale }) { this.#with(palette, (at) => this.module._gs_set_theme(at, scale)); }
  /** @param {string} table  JSON of languages/*.json; empty: English @returns {boolean} false: it is invalid, and nothing has changed */
  setLanguage(table) { return this.#with(table, (at) => this.module._gs_set_language(at)) !== 0; }
  /** @param {string} table  JSON of hints/*.json @returns {boolean} false: it is invalid, and nothing has changed */
  setHints(table) { return this.#with(table, (at) => this.module._gs_set_hints(at)) !== 0; }
  /** @param {number} perSecond  maximum frame rate; 0: the display's */
  setFrameRate(perSecond) { this.module._gs_set_frame_rate(perSecond); }
  /** @param {boolean} playing */
  play(playing) { this.module._gs_play(playing ? 1 : 0); }
  canUndo() { return this.module._gs_can_undo() !== 0; }
  canRedo() { return this.module._gs_can_redo() !== 0; }
  undo() { this.module._gs_undo(); }
  redo() { this.module._gs_redo(); }
  /**
   * Shows the first document of a visit, with nothing to undo.
   * @param {string} [example]  the name of a shipped motion; without: a figure that cannot move yet
   * @returns {boolean} false: there is no such motion
   */
  begin(example = '') { return this.#with(example, (at) => this.module._gs_begin(at)) !== 0; }
  /** Whether nothing moves unless a person plays it. @param {boolean} calm */
  setCalm(calm) { this.module._gs_set_calm(calm ? 1 : 0); }
  /** Removes all steps of Undo. */
  forgetPast() { this.module._gs_forget_past(); }
  /** Undo, Redo and the queue, for a reload. Only restoreVisit knows the format. */
  storeVisit() { return this.#text(this.module._gs_store_visit()); }
  /** @param {string} text @returns {boolean} false: it is damaged, and nothing has changed */
  restoreVisit(text) { return this.#with(text, (at) => this.module._gs_restore_visit(at)) !== 0; }

  /** @returns {CanvasCommand[]} */
  commands() { return JSON.parse(this.#text(this.module._gs_commands())); }
  /** @param {string} id @returns {boolean} false: there is no such command, or it is unavailable */
  run(id) { return this.#with(id, (at) => this.module._gs_run(at)) !== 0; }
  /**
   * Handles a key that went down.
   * @param {string} name  as from keyName
   * @param {boolean} onCanvas  whether the canvas has the focus, so that its controls come first
   * @param {boolean} repeated
   * @returns {boolean} whether a command handled it
   */
  key(name, onCanvas, repeated) {
    return this.#with(name, (at) => this.module._gs_key(at, onCanvas ? 1 : 0, repeated ? 1 : 0)) !== 0;
  }

  /** Sets the shown panels and the locks. @param {{panels?: string, lock?: string, live?: string}} options @returns {string} empty, or a sentence, with nothing changed */
  arrange(options) { return this.#with(JSON.stringify(options), (at) => this.#text(this.module._gs_arrange(at))); }
  /** @returns {Measures} */
  measures() { return JSON.parse(this.#text(this.module._gs_measures())); }
  /** Whether a text field on the canvas is open. */
  typing() { return this.widgets().some(({ role }) => role === 'textbox'); }

  /** @param {SynthesizeOptions} options @returns {string} empty, or a sentence, with no search started */
  synthesize(options) {
    return this.#with(JSON.stringify(options), (at) => this.#text(this.module._gs_synthesize(at)));
  }

  /** @param {SynthesizeOptions} options @returns {string} empty, or a sentence, with nothing added */
  enqueue(options) {
    return this.#with(JSON.stringify(options), (at) => this.#text(this.module._gs_enqueue(at)));
  }

  /** The waiting searches, next one first. @returns {QueuedSearch[]} */
  queue() { return JSON.parse(this.#text(this.module._gs_queue())); }
  /** The results, newest first. @returns {FoundMotion[]} */
  found() { return JSON.parse(this.#text(this.module._gs_found())); }
  /** @param {string} id @returns {boolean} false: there is no such result */
  showFound(id) { return this.#with(id, (at) => this.module._gs_show_found(at)) !== 0; }
  /** @param {string} id @param {string} name  empty: removes the name @returns {string} empty, or the error */
  renameFound(id, name) {
    return this.#with(JSON.stringify({ id, name }), (at) => this.#text(this.module._gs_rename_found(at)));
  }

  /** Restores a result of an earlier visit. @param {string} text @returns {string} its id; empty: the text is invalid */
  restoreFound(text) { return this.#with(text, (at) => this.#text(this.module._gs_restore_found(at))); }

  /** @param {LabOptions} options @returns {string} empty, or a sentence, with nothing changed */
  lab(options) {
    return this.#with(JSON.stringify(options), (at) => this.#text(this.module._gs_lab(at)));
  }

  /** @returns {string} 'idle', 'running', 'done', 'stopped' or 'failed' */
  labState() { return this.#text(this.module._gs_lab_state()); }
  /** The curves of the finished trials, as CSV. */
  labCsv() { return this.#text(this.module._gs_lab_csv()); }

  pause() { this.module._gs_pause(); }
  resume() { this.module._gs_resume(); }
  stop() { this.module._gs_stop(); }

  /** Reports that the search failed. */
  searchFailed() {
    this.searchProgress({ ...NO_REPORT, state: 'failed' });
  }

  /** @param {Omit<SearchReport, 'state'> & {state: SearchReport['state'] | 'failed'}} report  with the whole curve */
  searchProgress({ bestGenome, curve, saved, attempt, ...record }) {
    const parts = [curve, bestGenome, saved, attempt].map((part) => (part ? new Uint8Array(part.buffer, part.byteOffset, part.byteLength) : new Uint8Array(0)));
    const [curveBytes, genomeBytes, savedBytes, attemptBytes] = parts.map(({ length }) => length);
    const count = curveBytes + genomeBytes + savedBytes + attemptBytes;
    const at = this.#room(Math.max(count, 1));
    try {
      let next = at;
      for (const part of parts) {
        this.module.HEAPU8.set(part, next); // after malloc, which may grow it
        next += part.length;
      }
      const fault = this.#with(JSON.stringify({ ...record, curveBytes, genomeBytes, savedBytes, attemptBytes }),
        (text) => this.#text(this.module._gs_search_progress(text, at, count)));
      if (fault) throw new Error(fault);
    } finally {
      this.module._free(at);
    }
  }

  /** Reports a part of a transition map. @param {import('../search/messages.js').Mapped} part */
  transitionsMapped({ generation, first, scores, usual }) {
    const at = this.#room(scores.byteLength);
    this.module.HEAPU8.set(new Uint8Array(scores.buffer, scores.byteOffset, scores.byteLength), at);
    this.module._gs_transitions_mapped(generation, first, at, scores.length, usual);
    this.module._free(at);
  }

  /** Reports that no more parts of this map will arrive. @param {number} generation */
  transitionsFailed(generation) { this.module._gs_transitions_failed(generation); }

  /** Reports how a plan is getting on. @param {import('../plan/worker.js').PlanReport} report */
  planReported({ generation, stage, document, iterations, cost, playedMiss, firstMiss, corrections, misses }) {
    const at = this.#room(Math.max(misses.byteLength + document.length, 1));
    try {
      this.module.HEAPU8.set(new Uint8Array(misses.buffer, misses.byteOffset, misses.byteLength), at); // first: numbers are aligned
      this.module.HEAPU8.set(document, at + misses.byteLength);
      this.#with(stage, (name) => this.module._gs_plan_reported(generation, name, at + misses.byteLength, document.length, iterations, cost, playedMiss, firstMiss, corrections, at, misses.length / 4));
    } finally {
      this.module._free(at);
    }
  }

  /** Reports that this plan will not be carried out. @param {number} generation */
  planFailed(generation) { this.module._gs_plan_failed(generation); }

  /** Throws if there is no memory left, before anything has changed. @param {number} bytes */
  #room(bytes) { return roomAt(this.module._malloc(bytes)); }

  /** @param {number} at */
  #text(at) { return this.module.UTF8ToString(at); }

  /**
   * Copies a text into the module's memory for one call.
   * @template T
   * @param {string} text
   * @param {(at: number, bytes: number) => T} use
   */
  #with(text, use) {
    const at = roomAt(this.module.stringToNewUTF8(text));
    try {
      return use(at, new TextEncoder().encode(text).length);
    } finally {
      this.module._free(at);
    }
  }
}

/** @param {number} at  address of allocated memory; 0: the allocation failed */
function roomAt(at) {
  if (at === 0) throw new RangeError(trLater('there is not enough memory left in this page'));
  return at;
}
