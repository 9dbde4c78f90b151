// SPDX-License-Identifier: MIT
// Makes one script of what the page for new lessons needs of the book's build and of markdown-it. Scripts of other rooms
// stay where the site has them, which has none that end in .mjs.
import { readFile } from 'node:fs/promises';
import { dirname, join, relative, resolve, sep } from 'node:path';
import { fileURLToPath } from 'node:url';
import { rollup } from 'rollup';
import { minify } from 'terser';

const WEB = fileURLToPath(new URL('../../', import.meta.url));
const MODULES = join(WEB, 'node_modules');

/** The file of a module that a package exports to import. @param {string} name  such as 'mdurl' or 'markdown-it/lib/token.mjs' */
async function packaged(name) {
  const [module, ...path] = name.split('/');
  if (path.length > 0) return join(MODULES, name);
  const { exports: ways = {}, module: main } = JSON.parse(await readFile(join(MODULES, module, 'package.json'), 'utf8'));
  return join(MODULES, module, ways['.']?.import ?? main);
}

/** @param {string} entry  a script in web/book @returns {Promise<{code: string, licences: string}>} code: for the folder of the book */
export async function bundled(entry) {
  const bundle = await rollup({
    input: entry,
    plugins: [{
      name: 'rooms',
      async resolveId(source, importer) {
        if (!importer) return source;
        const file = source.startsWith('.') ? resolve(dirname(importer), source) : await packaged(source);
        const place = relative(WEB, file).split(sep).join('/');
        return /^(book|node_modules)\/|\.mjs$/.test(place) ? file : { id: `../${place}`, external: 'absolute' };
      },
    }],
  });
  const { output: [{ code, moduleIds }] } = await bundle.generate({ format: 'es' });
  const names = [...new Set(moduleIds.map((id) => relative(MODULES, id)).filter((path) => !path.startsWith('..')).map((path) => path.split(sep)[0]))].sort();
  const licences = await Promise.all(names.map(async (name) => `${name}\n\n${await licenceOf(name)}`));
  const { code: small = '' } = await minify(code, { module: true, compress: { passes: 2 } });
  return { code: small, licences: licences.join('\n\n') };
}

/** @param {string} name  of a package */
async function licenceOf(name) {
  for (const file of ['LICENSE', 'LICENSE.txt', 'LICENSE-MIT.txt']) {
    const text = await readFile(join(MODULES, name, file), 'utf8').catch(() => null);
    if (text !== null) return text;
  }
  throw new Error(`bundle: ${name} has no licence`);
}
