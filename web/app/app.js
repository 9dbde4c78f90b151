// SPDX-License-Identifier: MIT
// The application in the canvas, for the page: text and numbers in and out of its memory.
import { NO_REPORT } from './no_report.js';
import { trLater } from '../languages/language.js';

/** @typedef {import('./app_module.js').AppModule} AppModule */
/** @typedef {import('../search/messages.js').SearchReport} SearchReport */

/**
 * What is on the canvas: a widget that a person can see and use now.
 * @typedef {object} Widget
 * @property {string} id     stable, e.g. "search/start"
 * @property {string} label
 * @property {string} role   an ARIA role
 * @property {string} value  as shown
 * @property {Record<string, boolean>} state
 * @property {{x: number, y: number, width: number, height: number}} rect  CSS pixels
 */

/**
 * Options of a search; what is left out stays as the document has it.
 * @typedef {object} SynthesizeOptions
 * @property {string} [algorithm]   rgt, sphc, gga, ssga, shc, mpga, nelder-mead, powell, cma-es, map-elites or two-stage
 * @property {'timer' | 'physical' | 'network'} [sense]
 * @property {number} [period]       of the timer, seconds
 * @property {number} [evaluations]
 * @property {number} [seed]
 * @property {number} [workers]
 */

/**
 * Options of the lab; what is left out stays as the Lab panel has it.
 * @typedef {object} LabOptions
 * @property {string[]} [algorithms]  as of SynthesizeOptions
 * @property {number} [trials]        of each algorithm, 2 to 50
 * @property {number} [evaluations]   of each trial, up to 1,000,000
 * @property {number} [firstSeed]
 */

/** A search that waits. @typedef {{title: string, algorithm: string, seed: number, evaluations: number}} QueuedSearch */
/**
 * A result of a search, or what a person has kept.
 * @typedef {object} FoundMotion
 * @property {string} id
 * @property {string} title
 * @property {'done' | 'stopped' | 'failed' | 'by-hand'} origin  how its search ended; or kept as it was shown
 * @property {number | null} score   null: nothing moves, or physics broke
 * @property {string} algorithm
 * @property {number} seed
 * @property {number} evaluations    that were made
 * @property {boolean} kept          it does not make way for new ones
 * @property {number} when           seconds since 1970
 * @property {string} hash           of its trajectory
 * @property {string} link           payload of its document
 */

/** What a document says about its search, as far as the page shows it. @typedef {{algorithm?: string}} SearchJson */
/**
 * A document as JSON (docs/formats.md), as far as the page itself reads it.
 * @typedef {{title?: string, figure: {name?: string, rods?: object[]}, kind?: string, senses?: {kind?: string}, search?: SearchJson,
 *   environment?: {slope_rad?: number}, pushes?: {endpoint: number, impulse_x_ns: number, impulse_y_ns: number}[],
 *   task?: {kind?: string, weights?: Record<string, number>}}} DocumentJson
 */

/**
 * The numbers that a slider or a field can stand at. step 0: of no fixed size.
 * @typedef {{low: number, high: number, step: number, now: number}} WidgetRange
 */
/** A widget for the mirror, which has those out of sight and texts ("heading", "paragraph"), too. @typedef {Widget & {range?: WidgetRange, part: number}} MirrorWidget */
/** A named part of the canvas; parent: index of the one it is in, or -1. @typedef {{id: string, label: string, role: string, parent: number}} MirrorPart */
/** keyboard: what has it shows it; waiting: something asked for is still to be done. @typedef {{keyboard: boolean, waiting: boolean, parts: MirrorPart[], widgets: MirrorWidget[]}} MirrorState */

/** One number of a motion. @typedef {{name: string, label: string, unit: string, decimals: number, value: number | null}} Measure */
/** The whole motion in numbers; sense: of the controller shown, or empty; broke: physics did. @typedef {{terms: Measure[], sense: string, rules: number, broke: boolean}} Measures */

/** Of shell/session/commands.h. @typedef {{id: string, group: string, title: string, whyNot: string, keys: string[]}} CanvasCommand */

// PaletteName in shell/widgets/theme.h.
const PALETTES = ['light', 'dark', 'strong-light', 'strong-dark'];

// LabState in shell/session/lab.h.
const LAB_STATES = /** @type {const} */ (['idle', 'running', 'done', 'stopped', 'failed']);

export class App {
  /** @param {AppModule} module */
  constructor(module) {
    this.module = module;
  }

  /** Whether it found WebGL. If not, nothing else may be called. */
  running() { return this.module._gs_running() !== 0; }

  /**
   * @param {string} text  JSON, a link, or the payload of one
   * @returns {string} empty, or core's sentence about what is wrong and where; then nothing has changed
   */
  open(text) {
    return this.#with(text, (at, bytes) => this.#text(this.module._gs_open(at, bytes)));
  }

  /** @returns {string} indented JSON */
  documentText() { return this.#text(this.module._gs_document_json()); }
  /** @returns {DocumentJson} */
  document() { return JSON.parse(this.documentText()); }
  /** The payload of a link: what stands after '#'. */
  link() { return this.#text(this.module._gs_link()); }
  /** Of the shown motion's trajectory: 16 hexadecimal digits. */
  hash() { return this.#text(this.module._gs_hash()); }
  title() { return this.#text(this.module._gs_title()); }

  /** Visible widgets, their rectangles relative to the canvas. @returns {Widget[]} */
  widgets() { return JSON.parse(this.#text(this.module._gs_widgets())); }

  /** Everything on the canvas, in the order of drawing. @returns {MirrorState | null} null: as at the last call */
  mirror() {
    const text = this.#text(this.module._gs_mirror());
    return text ? JSON.parse(text) : null;
  }

  // What is asked of a widget it does in the next frame. False: it is not on the canvas, or cannot be used now.
  // `again`: more of what was asked before, as a key that is held; no step of its own for Undo.

  /** As by a click. @param {string} id */
  activate(id) { return this.#with(id, (at) => this.module._gs_activate(at)) !== 0; }
  /** As by arrow keys. @param {string} id @param {number} steps @param {boolean} again */
  step(id, steps, again) { return this.#with(id, (at) => this.module._gs_step(at, steps, again ? 1 : 0)) !== 0; }
  /** @param {string} id @param {number} value  as of WidgetRange @param {boolean} again */
  setValue(id, value, again) { return this.#with(id, (at) => this.module._gs_set_value(at, value, again ? 1 : 0)) !== 0; }
  /** @param {string} id @param {boolean} ring  it shows that it has the keyboard */
  focus(id, ring) { return this.#with(id, (at) => this.module._gs_focus(at, ring ? 1 : 0)) !== 0; }
  /** The keyboard is elsewhere on the page. */
  unfocus() { this.module._gs_unfocus(); }
  /** Closes an open list. */
  dismiss() { return this.module._gs_dismiss() !== 0; }

  /** The moment on the stage, for instance "Paused at 2.31 s, 1.84 m to the right. Rule 3 acts." */
  moment() { return this.#text(this.module._gs_moment()); }
  /** The same in full: what touches the ground, why the rule acts, what it is worth. */
  description() { return this.#text(this.module._gs_description()); }
  playing() { return this.module._gs_playing() !== 0; }

  /** The canvas's typeface for the rest of the page: loaded once, drawn twice. */
  lendTypeface() {
    for (const [semibold, weight] of [[0, '400'], [1, '600']]) {
      const at = this.module._gs_typeface(Number(semibold));
      const bytes = this.module.HEAPU8.slice(at, at + this.module._gs_typeface_size(Number(semibold)));
      document.fonts.add(new FontFace('Inter', bytes, { weight: String(weight) }));
    }
  }

  /** @param {import('../page/theme.js').Look} look */
  setTheme({ palette, scale }) { this.module._gs_set_theme(PALETTES.indexOf(palette), scale); }
  /** @param {string} table  JSON of languages/*.json; empty: English @returns {boolean} false: it is none, and nothing has changed */
  setLanguage(table) { return this.#with(table, (at) => this.module._gs_set_language(at)) !== 0; }
  /** @param {number} perSecond  at most so many frames are drawn; 0: as many as the display shows */
  setFrameRate(perSecond) { this.module._gs_set_frame_rate(perSecond); }
  /** @param {boolean} playing */
  play(playing) { this.module._gs_play(playing ? 1 : 0); }
  canUndo() { return this.module._gs_can_undo() !== 0; }
  canRedo() { return this.module._gs_can_redo() !== 0; }
  undo() { this.module._gs_undo(); }
  redo() { this.module._gs_redo(); }
  /** What is open now is where Undo ends. */
  forgetPast() { this.module._gs_forget_past(); }

  /** What can be done without a control. @returns {CanvasCommand[]} */
  commands() { return JSON.parse(this.#text(this.module._gs_commands())); }
  /** @param {string} id @returns {boolean} false: there is no such command, or it is not possible now */
  run(id) { return this.#with(id, (at) => this.module._gs_run(at)) !== 0; }
  /**
   * A key went down.
   * @param {string} name  as of keyName @param {boolean} onCanvas  its controls come first @param {boolean} repeated
   * @returns {boolean} whether a command took it
   */
  key(name, onCanvas, repeated) {
    return this.#with(name, (at) => this.module._gs_key(at, onCanvas ? 1 : 0, repeated ? 1 : 0)) !== 0;
  }
  /** What is shown and locked. @param {{panels?: string, lock?: string}} options @returns {string} empty, or a sentence; then nothing has changed */
  arrange(options) { return this.#with(JSON.stringify(options), (at) => this.#text(this.module._gs_arrange(at))); }
  /** The motion shown in numbers. @returns {Measures} */
  measures() { return JSON.parse(this.#text(this.module._gs_measures())); }
  /** Whether a text field on the canvas is open. */
  typing() { return this.widgets().some(({ role }) => role === 'textbox'); }

  /** @param {SynthesizeOptions} options @returns {string} empty, or a sentence; then nothing has started */
  synthesize(options) {
    return this.#with(JSON.stringify(options), (at) => this.#text(this.module._gs_synthesize(at)));
  }

  /** @param {SynthesizeOptions} options @returns {string} empty, or a sentence; then nothing waits more than before */
  enqueue(options) {
    return this.#with(JSON.stringify(options), (at) => this.#text(this.module._gs_enqueue(at)));
  }
  /** What waits, the next one first. @returns {QueuedSearch[]} */
  queue() { return JSON.parse(this.#text(this.module._gs_queue())); }
  /** What was found and kept, the newest first. @returns {FoundMotion[]} */
  found() { return JSON.parse(this.#text(this.module._gs_found())); }
  /** @param {string} id @returns {boolean} false: there is no such result */
  showFound(id) { return this.#with(id, (at) => this.module._gs_show_found(at)) !== 0; }
  /** @param {string} id @param {string} name  empty: none @returns {string} empty, or why not */
  renameFound(id, name) {
    return this.#with(JSON.stringify({ id, name }), (at) => this.#text(this.module._gs_rename_found(at)));
  }
  /** A found motion of an earlier visit. @param {string} text @returns {string} its id; empty: it is none */
  restoreFound(text) { return this.#with(text, (at) => this.#text(this.module._gs_restore_found(at))); }

  /** @param {LabOptions} options @returns {string} empty, or a sentence; then nothing has changed */
  lab(options) {
    return this.#with(JSON.stringify(options), (at) => this.#text(this.module._gs_lab(at)));
  }
  labState() { return LAB_STATES[this.module._gs_lab_state()]; }
  /** The curves of the trials that are finished, as a file. */
  labCsv() { return this.#text(this.module._gs_lab_csv()); }

  pause() { this.module._gs_pause(); }
  resume() { this.module._gs_resume(); }
  stop() { this.module._gs_stop(); }

  /** Nothing came of the search. */
  searchFailed() {
    this.searchProgress({ ...NO_REPORT, state: 'failed' });
  }

  /** @param {Omit<SearchReport, 'state'> & {state: SearchReport['state'] | 'failed'}} report  with the whole curve */
  searchProgress({ bestGenome, curve, saved, ...record }) {
    const parts = [curve, bestGenome, saved].map((part) => (part ? new Uint8Array(part.buffer, part.byteOffset, part.byteLength) : new Uint8Array(0)));
    const [curveBytes, genomeBytes, savedBytes] = parts.map(({ length }) => length);
    const count = curveBytes + genomeBytes + savedBytes;
    const at = this.#room(Math.max(count, 1));
    try {
      let next = at;
      for (const part of parts) {
        this.module.HEAPU8.set(part, next); // after malloc, which may grow it
        next += part.length;
      }
      const fault = this.#with(JSON.stringify({ ...record, curveBytes, genomeBytes, savedBytes }),
        (text) => this.#text(this.module._gs_search_progress(text, at, count)));
      if (fault) throw new Error(fault);
    } finally {
      this.module._free(at);
    }
  }

  /** A part of a transition map. @param {import('../search/messages.js').Mapped} part */
  transitionsMapped({ generation, first, scores, usual }) {
    const at = this.#room(scores.byteLength);
    this.module.HEAPU8.set(new Uint8Array(scores.buffer, scores.byteOffset, scores.byteLength), at);
    this.module._gs_transitions_mapped(generation, first, at, scores.length, usual);
    this.module._free(at);
  }

  /** Nothing more comes of the map. @param {number} generation */
  transitionsFailed(generation) { this.module._gs_transitions_failed(generation); }

  /** Throws where there is no memory left: then nothing has changed. @param {number} bytes */
  #room(bytes) { return roomAt(this.module._malloc(bytes)); }

  /** @param {number} at */
  #text(at) { return this.module.UTF8ToString(at); }

  /**
   * Lends the module a text.
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

/** @param {number} at  of memory that was asked for */
function roomAt(at) {
  if (at === 0) throw new RangeError(trLater('there is not enough memory left in this page'));
  return at;
}
