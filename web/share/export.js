// SPDX-License-Identifier: MIT
// The dialog that exports the motion as files for other programs. Loaded on first use.
import { element, offerFile, onClick, toast } from '../browser/dom.js';
import { exporters } from '../catalogue/catalogue.js';
import { Engine } from '../search/engine.js';
import { fixed, followLanguage, tr, trSentence } from '../languages/language.js';
import { fileName } from './sharing.js';

/** @typedef {import('../app/app.js').App} App */
/** @typedef {import('../search/engine.js').RecordedMotion} RecordedMotion */
/**
 * The input of an export.
 * @typedef {object} ExportJob
 * @property {RecordedMotion} motion
 * @property {string} title
 * @property {number} poses
 * @property {AbortSignal} signal                  aborted when the export is cancelled
 * @property {(share: number) => void} onProgress  share: the finished part, from 0 to 1
 */
/** @typedef {{ending: string, type: string, make: (job: ExportJob) => Promise<BlobPart>}} Format */

const PNG_SCALE = 2;

/** The formats of the engine's exporters, and those that are made here. @type {Record<string, Format>} */
export const FORMATS = {
  ...Object.fromEntries(exporters.map(({ name, ending, type }) => [name, { ending, type, make: async (job) => (name === 'svg' ? strip(job) : job.motion.file(name)) }])),
  png: { ending: 'png', type: 'image/png', make: (job) => painted(strip(job)) },
  gif: { ending: 'gif', type: 'image/gif', make: async (job) => (await import('./export_film.js')).gif(job) },
  webm: { ending: 'webm', type: 'video/webm', make: async (job) => (await import('./export_film.js')).webm(job) },
};

/** @param {ExportJob} job */
function strip({ motion, poses }) {
  return motion.filmStrip(poses, [
    tr('{1} poses of {2} from {3} s to {4} s, lettered {5} to {6}.'),
    tr('ground tilted by {1}°, drawn level'),
    fixed(0.5, 1).charAt(1),
  ]);
}

/** An SVG as a PNG. @param {string} svg @returns {Promise<Blob>} */
async function painted(svg) {
  const url = URL.createObjectURL(new Blob([svg], { type: FORMATS.svg.type }));
  try {
    const image = new Image();
    image.src = url;
    await image.decode();
    const canvas = document.createElement('canvas');
    canvas.width = PNG_SCALE * image.naturalWidth;
    canvas.height = PNG_SCALE * image.naturalHeight;
    canvas.getContext('2d')?.drawImage(image, 0, 0, canvas.width, canvas.height);
    const png = await new Promise((resolve) => canvas.toBlob(resolve, 'image/png'));
    if (!(png instanceof Blob)) throw new Error('no picture');
    return png;
  } finally {
    URL.revokeObjectURL(url);
  }
}

/** The choice of an exporter, whose words follow the language. @param {typeof exporters[number]} exporter */
function choice({ name, label, note }) {
  const title = document.createTextNode('');
  const small = document.createElement('small');
  followLanguage(() => {
    title.data = `${tr(label)} `;
    small.textContent = tr(note);
  });
  const words = document.createElement('span');
  words.append(title, small);
  const box = document.createElement('label');
  box.append(Object.assign(document.createElement('input'), { type: 'radio', name: 'export-format', value: name, defaultChecked: name === exporters[0]?.name }), ' ', words);
  return box;
}

class ExportDialog {
  #dialog = element('export-dialog', HTMLDialogElement);
  #formats = element('export-formats', HTMLFieldSetElement);
  #poses = element('export-poses', HTMLInputElement);
  #plan = element('export-plan');
  #planned = element('export-planned', HTMLInputElement);
  #progress = element('export-progress', HTMLProgressElement);
  #go = element('export-go', HTMLButtonElement);
  #cancel = element('export-cancel', HTMLButtonElement);
  #error = element('export-error');
  /** Of the running export. @type {AbortController | null} */
  #making = null;
  /** @type {Promise<Engine> | null} */
  #engine = null;

  /** @param {App} app @param {import('../access/status_line.js').StatusLine} statusLine */
  constructor(app, statusLine) {
    this.app = app;
    this.statusLine = statusLine;
    // index.html has the formats that are made here. They follow the first exporter, the film strip.
    const [first, ...others] = exporters.map(choice);
    this.#formats.querySelector('legend')?.after(first);
    this.#formats.append(...others);
    this.#dialog.addEventListener('submit', (event) => {
      event.preventDefault();
      void this.#export();
    });
    this.#formats.addEventListener('change', () => this.#chosen());
    this.#dialog.addEventListener('close', () => this.#making?.abort());
    onClick('export-cancel', () => (this.#making ? this.#making.abort() : this.#dialog.close()));
  }

  open() {
    this.#error.textContent = '';
    this.#chosen();
    this.#plan.hidden = !this.app.document().plan?.solved?.unknowns?.length;
    if (typeof MediaRecorder !== 'function' || !MediaRecorder.isTypeSupported('video/webm')) {
      this.#radio('webm').disabled = true;
      element('export-webm').textContent = tr('This browser cannot record videos');
    }
    this.#dialog.showModal();
    this.#radio(this.#format()).focus();
  }

  /** @param {string} format */
  #radio(format) { return /** @type {HTMLInputElement} */ (this.#formats.querySelector(`[value=${format}]`)); }
  #format() { return /** @type {HTMLInputElement} */ (this.#formats.querySelector(':checked')).value; }

  /** Shows the number of poses only for film strips. */
  #chosen() {
    const strip = ['svg', 'png'].includes(this.#format());
    element('export-strip').hidden = !strip;
    this.#poses.disabled = !strip;
  }

  async #export() {
    if (this.#making) return;
    const { ending, type, make } = FORMATS[this.#format()];
    const making = new AbortController();
    this.#show(making);
    /** @type {RecordedMotion | null} */
    let motion = null;
    try {
      const engine = await this.#load();
      const bytes = engine.documentFromText(this.app.documentText());
      motion = !this.#plan.hidden && this.#planned.checked ? engine.plannedMotion(bytes) : engine.motion(bytes);
      const contents = await make({
        motion,
        title: this.app.title(),
        poses: Number(this.#poses.value),
        signal: making.signal,
        onProgress: (share) => { this.#progress.value = share; },
      });
      making.signal.throwIfAborted();
      const name = `${fileName(this.app.title())}.${ending}`;
      offerFile(name, contents, type);
      this.statusLine.say('');
      toast(tr('Exported: {1}', name));
      this.#show(null);
      this.#dialog.close();
    } catch (error) {
      this.#show(null);
      if (making.signal.aborted) toast(tr('Export cancelled'));
      else this.#error.textContent = tr('The file could not be made: {1}.', trSentence(error instanceof Error ? error.message : String(error)));
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
    this.#planned.disabled = making !== null;
    this.#go.disabled = making !== null;
    this.#error.textContent = '';
    this.#progress.hidden = making === null;
    this.#progress.value = 0;
    if (making) this.#cancel.focus(); // the focused control may be disabled now
    else if (this.#dialog.open) this.#go.focus();
  }
}

/** @type {ExportDialog | undefined} */
let dialog;

/** @param {App} app @param {import('../access/status_line.js').StatusLine} statusLine */
export function openExport(app, statusLine) {
  dialog ??= new ExportDialog(app, statusLine);
  dialog.open();
}
