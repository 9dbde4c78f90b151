// SPDX-License-Identifier: MIT
// Writes what the page needs of fflate: the encoder of ZIP files, without the decoders.
//
//   node web/build/zip_encoder.mjs <file.js>
import { readFile, writeFile } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
import { rollup } from 'rollup';
import { minify } from 'terser';

const FFLATE = fileURLToPath(new URL('../node_modules/fflate/esm/browser.js', import.meta.url));
const ENTRY = 'entry';

const [file] = process.argv.slice(2);
if (!file) throw new Error('zip_encoder: which file?');
const bundle = await rollup({
  input: ENTRY,
  plugins: [{
    name: 'entry',
    resolveId: (id) => (id === ENTRY ? id : null),
    load: (id) => (id === ENTRY ? `export { Zip, ZipDeflate } from ${JSON.stringify(FFLATE)};` : readFile(id, 'utf8')),
  }],
});
const { output: [{ code }] } = await bundle.generate({ format: 'es' });
const { code: small = '' } = await minify(code, { module: true, compress: { passes: 2 } });
await writeFile(file, small);
