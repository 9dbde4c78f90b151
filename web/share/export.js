// SPDX-License-Identifier: MIT
// The dialog that exports the motion as files for other programs, with a preview of what is exported. Loaded on first use.
import { element, offerFile, onClick, toast } from '../browser/dom.js';
import { exporters } from '../catalogue/catalogue.js';
import { Engine } from '../search/engine.js';
import { fixed, followLanguage, tr, trSentence } from '../languages/language.js';
import { FORMATS } from './export_formats.js';
import { cycleOf, ExportPreview, openPart } from './export_preview.js';
import { fileName } from './sharing.js';

/** @typedef {import('../app/app.js').App} App */
/** @typedef {import('./export_preview.js').Choice} Choice */
/** @typedef {import('./export_preview.js').Cycle} Cycle */

/** The choice of an exporter, whose label follows the language. @param {typeof exporters[number]} exporter */
function choice({ name, label }) {
  const title = document.createTextNode('');
  const small = document.createElement('small');
  followLanguage(() => { title.data = `${tr(label)} `; });
  const words = document.createElement('span');
  words.append(title, small);
  const box = document.createElement('label');
  box.append(Object.assign(document.createElement('input'), { type: 'radio', name: 'export-format', value: name }), ' ', words);
  return box;
}

/** A cycle in words, such as "0.82 s and 1.31 m a cycle, one turn". @param {Cycle} cycle */
function words({ period, distance, turns, later }) {
  const time = fixed(period, 2), way = Math.abs(distance), count = Math.abs(turns);
  const parts = [way < 0.005 ? tr('{1} s a cycle', time) : tr('{1} s and {2} m a cycle', time, fixed(way, 2))];
  if (count === 1) parts.push(tr('one turn'));
  else if (count > 1) parts.push(tr('{1} turns', String(count)));
  const found = tr('It was found by letting the controller run on.');
  return parts.join(', ') + (later ? `. ${found}` : '');
}

class ExportDialog {
  #dialog = element('export-dialog', HTMLDialogElement);
  #formats = element('export-formats', HTMLFieldSetElement);
  #parts = element('export-parts', HTMLFieldSetElement);
  #poses = element('export-poses', HTMLInputElement);
  #frames = element('export-frames', HTMLInputElement);
  #pixels = element('export-pixels', HTMLInputElement);
  #cycle = element('export-cycle');
  #inPlace = element('export-in-place', HTMLInputElement);
  #halves = element('export-halves', HTMLInputElement);
  #progress = element('export-progress', HTMLProgressElement);
  #go = element('export-go', HTMLButtonElement);
  #cancel = element('export-cancel', HTMLButtonElement);
  #error = element('export-error');
  #preview = new ExportPreview(element('export-picture', HTMLCanvasElement));
  /** Of the running export. @type {AbortController | null} */
  #making = null;
  /** @type {Promise<Engine> | null} */
  #engine = null;
  /** The document as it was when the dialog was opened, for the engine. @type {Uint8Array | null} */
  #document = null;

  /** @param {App} app @param {import('../access/status_line.js').StatusLine} statusLine */
  constructor(app, statusLine) {
    this.app = app;
    this.statusLine = statusLine;
    for (const exporter of exporters) element(`export-${exporter.group}`).append(choice(exporter));
    followLanguage(() => this.#offerFormats());
    element('export-pictures').append(element('export-strip'));
    this.#label('sprites').after(element('export-sheet'));
    this.#dialog.addEventListener('submit', (event) => {
      event.preventDefault();
      void this.#export();
    });
    this.#formats.addEventListener('change', () => {
      this.#chosen();
      void this.#weigh();
    });
    this.#parts.addEventListener('change', () => void this.#showPart());
    for (const number of [this.#poses, this.#frames, this.#pixels]) number.addEventListener('change', () => void this.#weigh());
    this.#dialog.addEventListener('close', () => {
      this.#making?.abort();
      this.#preview.close();
    });
    onClick('export-cancel', () => (this.#making ? this.#making.abort() : this.#dialog.close()));
  }

  open() {
    this.#error.textContent = '';
    this.#document = null;
    this.#offerFormats();
    this.#offer('planned', Boolean(this.app.document().plan?.solved?.unknowns?.length));
    if (typeof MediaRecorder !== 'function' || !MediaRecorder.isTypeSupported('video/webm')) {
      this.#radio('webm').disabled = true;
      element('export-webm').textContent = tr('This browser cannot record videos');
    }
    this.#chosen();
    this.#dialog.showModal();
    this.#radio(this.#format()).focus();
    void this.#look();
  }

  /** @param {string} value  of a format or a part */
  #radio(value) { return /** @type {HTMLInputElement} */ (this.#dialog.querySelector(`[type=radio][value=${value}]`)); }
  /** @param {string} value */
  #label(value) { return /** @type {HTMLElement} */ (this.#radio(value).closest('label')); }
  #format() { return /** @type {HTMLInputElement} */ (this.#formats.querySelector('input:checked')).value; }
  /** @returns {Choice} */
  #choice() {
    const part = /** @type {HTMLInputElement} */ (this.#parts.querySelector('[name=export-part]:checked')).value;
    return { part, halves: this.#halves.checked, inPlace: this.#inPlace.checked };
  }

  /** Offers a part, or takes it back. @param {string} part @param {boolean} there */
  #offer(part, there) {
    const radio = this.#radio(part);
    this.#label(part).hidden = !there && part === 'planned';
    radio.disabled = !there;
    if (!there && radio.checked) this.#radio('whole').checked = true;
  }

  /** Offers the exporters that can show the figure. The notes of the others give the reason. */
  #offerFormats() {
    const ofSprings = Boolean(this.app.document().figure.springs?.length);
    for (const { name, note, springs } of exporters) {
      const radio = this.#radio(name), there = springs || !ofSprings;
      radio.disabled = !there;
      /** @type {HTMLElement} */ (this.#label(name).querySelector('small')).textContent = there ? tr(note) : tr('Needs a figure of rods');
      if (!there && radio.checked) this.#radio('gif').checked = true;
    }
  }

  /** Shows the numbers of film strips and sprite sheets only with these. */
  #chosen() {
    const strip = ['svg', 'png'].includes(this.#format()), sheet = this.#format() === 'sprites';
    element('export-strip').hidden = !strip;
    element('export-sheet').hidden = !sheet;
    this.#poses.disabled = !strip;
    this.#frames.disabled = this.#pixels.disabled = !sheet;
  }

  /** Looks for a cycle, says which, and plays what is chosen. */
  async #look() {
    const chosen = this.#choice().part;
    this.#offer('loop', false);
    this.#cycle.textContent = tr('Looking for one…');
    try {
      const engine = await this.#load();
      const document = engine.documentFromText(this.app.documentText());
      this.#document = document;
      try {
        const loop = engine.loop(document);
        this.#cycle.textContent = words(/** @type {Cycle} */ (loop.cycle()));
        loop.close();
        this.#offer('loop', true);
        this.#offerHalves(engine, document);
        this.#radio(chosen).checked = true;
      } catch (error) {
        this.#cycle.textContent = tr('None: {1}', trSentence(reason(error)));
      }
      await this.#showPart();
    } catch (error) {
      this.#cycle.textContent = '';
      this.#error.textContent = tr('The file could not be made: {1}.', trSentence(reason(error)));
    }
  }

  /** Offers even halves where they fit. @param {Engine} engine @param {Uint8Array} document */
  #offerHalves(engine, document) {
    let there = true;
    try {
      engine.loop(document, { halves: true }).close();
    } catch {
      there = false;
      this.#halves.checked = false;
    }
    /** @type {HTMLElement} */ (this.#halves.closest('label')).hidden = !there;
  }

  /** Plays the chosen part. */
  async #showPart() {
    const choice = this.#choice();
    element('export-ways').hidden = choice.part !== 'loop';
    if (!this.#document || !this.#dialog.open) return;
    const motion = openPart(await this.#load(), this.#document, choice);
    if (choice.part === 'loop') this.#cycle.textContent = words(/** @type {Cycle} */ (motion.cycle()));
    this.#preview.show(motion, cycleOf(motion, choice.inPlace));
    await this.#weigh();
  }

  /** Says how large the file will be, of files that are made at once. */
  async #weigh() {
    const format = this.#format();
    const size = element('export-size');
    size.textContent = '';
    const motion = this.#preview.motion;
    if (!motion || this.#making || !FORMATS[format].light) return;
    try {
      const contents = await FORMATS[format].make({ motion, ...this.#numbers(), title: this.app.title(), signal: new AbortController().signal, onProgress: () => {} });
      if (this.#format() === format) size.textContent = weight(new Blob([contents]).size);
    } catch {
      // Export says why.
    }
  }

  #numbers() {
    return { poses: Number(this.#poses.value), sprites: { frames: Number(this.#frames.value), size: Number(this.#pixels.value) } };
  }

  async #export() {
    if (this.#making) return;
    const { ending, type, make } = FORMATS[this.#format()];
    const choice = this.#choice();
    const making = new AbortController();
    this.#show(making);
    /** @type {import('../search/engine.js').RecordedMotion | null} */
    let motion = null;
    try {
      const engine = await this.#load();
      motion = openPart(engine, engine.documentFromText(this.app.documentText()), choice);
      await new Promise((shown) => setTimeout(shown, 50)); // until the progress bar is seen: some files are made at one go
      const contents = await make({
        motion,
        cycle: cycleOf(motion, choice.inPlace),
        title: this.app.title(),
        ...this.#numbers(),
        signal: making.signal,
        onProgress: (share) => { this.#progress.value = share; },
      });
      making.signal.throwIfAborted();
      const name = `${fileName(this.app.title())}${choice.part === 'loop' ? '-loop' : ''}.${ending}`;
      offerFile(name, contents, type);
      this.statusLine.say('');
      toast(tr('Exported: {1}', `${name}, ${weight(new Blob([contents]).size)}`));
      this.#show(null);
      this.#dialog.close();
    } catch (error) {
      this.#show(null);
      if (making.signal.aborted) toast(tr('Export cancelled'));
      else this.#error.textContent = tr('The file could not be made: {1}.', trSentence(reason(error)));
    } finally {
      motion?.close();
    }
  }

  /** The engine, loaded once for all exports. */
  #load() {
    this.#engine ??= Engine.load();
    this.#engine.catch(() => { this.#engine = null; }); // try again next time
    return this.#engine;
  }

  /** @param {AbortController | null} making */
  #show(making) {
    this.#making = making;
    this.#formats.disabled = making !== null;
    this.#parts.disabled = making !== null;
    this.#go.disabled = making !== null;
    this.#error.textContent = '';
    this.#progress.hidden = making === null;
    this.#progress.value = 0;
    if (making) this.#cancel.focus(); // the focused control may be disabled now
    else if (this.#dialog.open) this.#go.focus();
  }
}

/** A file's size. @param {number} bytes */
const weight = (bytes) => (bytes < 999_500 ? tr('{1} kB', fixed(bytes / 1000, bytes < 9950 ? 1 : 0)) : tr('{1} MB', fixed(bytes / 1e6, 1)));

/** @param {unknown} error */
const reason = (error) => (error instanceof Error ? error.message : String(error));

/** @type {ExportDialog | undefined} */
let dialog;

/** @param {App} app @param {import('../access/status_line.js').StatusLine} statusLine */
export function openExport(app, statusLine) {
  dialog ??= new ExportDialog(app, statusLine);
  dialog.open();
}
