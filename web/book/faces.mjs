// SPDX-License-Identifier: MIT
// The Inter typeface, reduced to the characters of the book's pages.
import { copyFile, mkdir, readFile, writeFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';

const FACES = ['Regular', 'Italic', 'SemiBold'];
const FEATURES = ['kern', 'tnum', 'calt', 'ccmp', 'locl'];

/** @param {string} folder  to write to @param {string} text  all text of the book */
export async function cutFaces(folder, text) {
  const require = createRequire(import.meta.url);
  /** @type {(font: Buffer, text: string, options: object) => Promise<Buffer>} */
  const subsetFont = require('subset-font');
  const inter = dirname(require.resolve('inter-ui/package.json'));
  const characters = [...new Set(text)].filter((character) => character >= ' ').sort().join('');
  await mkdir(folder, { recursive: true });
  for (const face of FACES) {
    const whole = await readFile(join(inter, 'web', `Inter-${face}.woff2`));
    const cut = await subsetFont(whole, characters, { targetFormat: 'woff2', noHinting: true, keepFeatures: FEATURES });
    await writeFile(join(folder, `inter-${face.toLowerCase()}.woff2`), cut);
  }
  await copyFile(join(inter, 'LICENSE.txt'), join(folder, 'inter.LICENSE.txt'));
}
