// SPDX-License-Identifier: MIT
// Joins the scripts that the page loads first into page/page.js: one file compresses better than many and is one
// request. Scripts that are loaded later keep their files.
//
//   node web/build/join.mjs <folder of the site>
import { execFile } from 'node:child_process';
import { readFile, rm, writeFile } from 'node:fs/promises';
import { join, relative, resolve, sep } from 'node:path';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { rollup } from 'rollup';

const PAGE = 'page/page.js';
const APPLICATION = 'app/app_module.js';
/** Workers, embedding pages, the book and tests also load these. They must not start the page. */
const SHARED = ['engine.js', 'catalogue/catalogue.js', 'classroom/before_after.js', 'classroom/packages.js', 'classroom/wall.js', 'explorable/explorable.js', 'share/copying.js', 'share/scorm.js', 'share/scorm_maker.js', 'share/stamp.js', 'share/work.js', 'search/compiled_engine.js', 'search/engine.js', 'search/search_client.js', 'search/worker.js'];

const folder = resolve(process.argv[2] ?? 'build/site');
/** @param {string} id  an absolute path */
const nameOf = (id) => relative(folder, id).split(sep).join('/');
/** Emscripten's scripts stay as they are. @param {string} id */
const generated = (id) => id.endsWith('_module.js');

/** The scripts that each script imports before it runs. @type {Map<string, string[]>} */
const imports = new Map();
const graph = await rollup({
  input: [PAGE, ...SHARED].map((name) => join(folder, name)),
  external: generated,
  plugins: [{
    name: 'imports',
    moduleParsed({ id, importedIds }) { imports.set(nameOf(id), importedIds.filter((each) => !generated(each)).map(nameOf)); },
  }],
});
await graph.close();

/** @param {string[]} names @returns {Set<string>} */
function loadedWith(names) {
  const loaded = new Set(names);
  for (const name of loaded) for (const imported of imports.get(name) ?? []) loaded.add(imported);
  return loaded;
}

const shared = loadedWith(SHARED);
const first = loadedWith([PAGE]);
const joined = [...first].filter((name) => !shared.has(name));

const site = await rollup({
  input: Object.fromEntries([PAGE, ...shared].map((name) => [name.replace(/\.js$/, ''), join(folder, name)])),
  external: generated,
  preserveEntrySignatures: 'allow-extension', // the page's script also exports what later ones need
});
const { output } = await site.generate({
  entryFileNames: '[name].js',
  chunkFileNames: '[name].js',
  hoistTransitiveImports: false,
  minifyInternalExports: false, // a later script of another version must not find another function under the same letter
  manualChunks: (id) => (joined.includes(nameOf(id)) ? PAGE : nameOf(id)).replace(/\.js$/, ''),
});
await site.close();
await Promise.all(joined.filter((name) => name !== PAGE).map((name) => rm(join(folder, name))));
for (const part of output) {
  if (part.type !== 'chunk') throw new Error(`join: ${part.fileName} is no script`);
  await writeFile(join(folder, part.fileName), part.code);
}
const minify = fileURLToPath(new URL('minify.mjs', import.meta.url));
await promisify(execFile)(process.execPath, [minify, folder, folder, ...output.map(({ fileName }) => join(folder, fileName))]);

// The browser asks for all first files at once, before it has read one.
const index = join(folder, 'index.html');
const preloads = [APPLICATION, PAGE, ...[...first].filter((name) => shared.has(name))]
  .map((name) => `<link rel="modulepreload" href="${name}">\n`).join('');
await writeFile(index, (await readFile(index, 'utf8')).replace(/(?:<link rel="modulepreload"[^>]*>\n)+/, preloads));
console.log(`== ${joined.length} of ${joined.length + output.length - 1} scripts joined into ${PAGE}`);
