// SPDX-License-Identifier: MIT
// The files that an export may be: those of the engine's exporters, and those that only a page can make. Loaded with the
// dialog.
import { exporters } from '../catalogue/catalogue.js';
import { fixed, tr } from '../languages/language.js';

/** @typedef {import('../search/engine.js').RecordedMotion} RecordedMotion */
/**
 * The input of an export.
 * @typedef {object} ExportJob
 * @property {RecordedMotion} motion
 * @property {string} title
 * @property {{distance: number} | null} [cycle]  of a loop: how far it comes, 0 in place [m]; null: a whole motion
 * @property {number} poses
 * @property {{frames: number, size: number}} sprites  of a sprite sheet; size: the longer side of a frame [px]
 * @property {AbortSignal} signal                  aborted when the export is cancelled
 * @property {(share: number) => void} onProgress  share: the finished part, from 0 to 1
 */
/** light: made at once. @typedef {{ending: string, type: string, light?: boolean, make: (job: ExportJob) => Promise<BlobPart>}} Format */

const PNG_SCALE = 2;

/** The formats of the engine's exporters, and those that are made here. @type {Record<string, Format>} */
export const FORMATS = {
  ...Object.fromEntries(exporters.map(({ name, ending, type }) => [name, { ending, type, light: !['apng', 'sprites'].includes(name), make: async (job) => file(name, job) }])),
  png: { ending: 'png', type: 'image/png', make: (job) => painted(strip(job)) },
  gif: { ending: 'gif', type: 'image/gif', make: async (job) => (await import('./export_film.js')).gif(job) },
  webm: { ending: 'webm', type: 'video/webm', make: async (job) => (await import('./export_film.js')).webm(job) },
};

/** A file of the engine's. @param {string} name @param {ExportJob} job */
function file(name, job) {
  if (name === 'svg') return strip(job);
  return name === 'sprites' ? job.motion.sprites(job.sprites.frames, job.sprites.size) : job.motion.bytes(name);
}

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
