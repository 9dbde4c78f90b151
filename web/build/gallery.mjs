// SPDX-License-Identifier: MIT
// Writes the shipped motions for the page's Open dialog into a site, in the order of docs/gallery.md: title, figure, how
// far or how high it gets, and the payload of the link.
//
//   node web/build/gallery.mjs <folder of the site>
import { mkdir, readFile, writeFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const ROOT = fileURLToPath(new URL('../../', import.meta.url));
const [folder] = process.argv.slice(2);
if (!folder) throw new Error('gallery: which folder?');
const { Engine } = await import(pathToFileURL(join(folder, 'search/engine.js')).href);
const engine = await Engine.load();
const page = await readFile(join(ROOT, 'docs/gallery.md'), 'utf8');

const motions = [];
for (const [, file] of page.matchAll(/^### \[.*\]\((\S+)\)$/gm)) {
  const text = await readFile(join(ROOT, 'docs', file), 'utf8');
  const { title, figure, task } = JSON.parse(text);
  const document = engine.documentFromText(text);
  const motion = engine.motion(document);
  const { frames, stride, numbers } = motion;
  // The centre of mass of each frame follows the active controller.
  const at = (/** @type {number} */ frame, /** @type {number} */ place) => numbers[frame * stride + place];
  const heights = Array.from({ length: frames }, (_, frame) => at(frame, 2));
  const jumps = task?.kind === 'jump';
  const metres = jumps ? Math.max(...heights) - heights[0] : at(frames - 1, 1) - at(0, 1);
  motions.push({ title, figure: figure.name, metres: Number(metres.toFixed(2)), jumps, link: Buffer.from(document).toString('base64url') });
  motion.close();
}
if (motions.length === 0) throw new Error('gallery: docs/gallery.md has no motions');
const path = join(folder, 'gallery/motions.json');
await mkdir(dirname(path), { recursive: true });
await writeFile(path, `${JSON.stringify(motions)}\n`);
console.log(`== ${motions.length} motions for the Open dialog`);
