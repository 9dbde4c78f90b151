// SPDX-License-Identifier: MIT
// The API reference of core: a page for each header, made from its comments.
import { readdir, readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { attributes, escaped } from './html.mjs';
import { askDoxygen } from './reference/doxygen.mjs';
import { headerPage, sentenceOf } from './reference/header_page.mjs';
import { addressOf, Names } from './reference/names.mjs';
import { symbolsOf } from './reference/symbols.mjs';

/** @typedef {import('./reference/header_page.mjs').Searched} Searched */
/** @typedef {import('./template.mjs').Sheet} Sheet */
/**
 * @typedef {object} Reference
 * @property {Sheet[]} sheets       the first is the overview
 * @property {Searched[]} searched
 * @property {Map<string, string>} addresses  in the book, of folders and headers, by path
 */

export const REFERENCE = { address: 'reference/index.html', title: 'API reference', sentence: 'The headers of core: every type, function and constant, with its comment.' };

/** Folders of core, in the order for readers. */
const FOLDERS = [
  { name: 'document', title: 'Documents', sentence: 'What a file or a link holds, read, checked, edited and written.' },
  { name: 'rollout', title: 'Rollouts', sentence: 'Controllers drive figures: scored, recorded, handed over.' },
  { name: 'physics', title: 'Physics', sentence: 'Figures and the ground they move on.' },
  { name: 'control', title: 'Control', sentence: 'Senses, and the controllers that answer them: rules and networks.' },
  { name: 'signal', title: 'Signals', sentence: 'What passes between controllers and plants: targets and readings.' },
  { name: 'spacetime', title: 'Spacetime', sentence: 'Motions planned between keyframes, and what of a plan cannot be met.' },
  { name: 'planning', title: 'Planning', sentence: 'Plans of documents: drafted, carried out, and played by the simulator.' },
  { name: 'kinematics', title: 'Kinematics', sentence: 'Figures and motions as they look, whatever moves them.' },
  { name: 'gait', title: 'Gaits', sentence: 'The cycle of a motion: found, cut, and closed into a loop.' },
  { name: 'search', title: 'Searches', sentence: 'How controllers are found.' },
  { name: 'numeric', title: 'Numbers', sentence: 'Arithmetic, random numbers and errors that are the same everywhere.' },
];

/** @param {string} root  of the repository */
async function headersOf(root) {
  // Without the header for games: it is C, and docs/runtime.md explains it.
  const names = (await readdir(join(root, 'core'), { recursive: true })).filter((name) => name.endsWith('.h') && !name.startsWith('runtime/')).sort();
  return new Map(await Promise.all(names.map(async (name) => /** @type {[string, string]} */ ([`core/${name}`, await readFile(join(root, 'core', name), 'utf8')]))));
}

/** Folders with their headers. @param {Map<string, string>} headers */
function shelves(headers) {
  const folderOf = (/** @type {string} */ path) => path.split('/')[1];
  const unnamed = [...new Set([...headers.keys()].map(folderOf))].filter((name) => !FOLDERS.some((folder) => folder.name === name));
  return [...FOLDERS, ...unnamed.map((name) => ({ name, title: name, sentence: '' }))]
    .map((folder) => ({ ...folder, paths: [...headers.keys()].filter((path) => folderOf(path) === folder.name) }));
}

/** @param {Map<string, string>} headers @returns {Sheet} */
function firstPage(headers) {
  return {
    title: REFERENCE.title, address: REFERENCE.address, kind: 'page wide reference', styles: ['reference.css'], description: REFERENCE.sentence,
    body: `<div class="spread">
<main id="main" tabindex="-1">
<p class="group">For engineers</p>
<h1>${REFERENCE.title}</h1>
<p>Core is a library in C++23 that needs nothing but the standard library: no threads, clocks, files or printing, and no exceptions. Everything is in the
namespace <code>gaitsmith</code> and in the CMake target <code>gaitsmith::core</code>. <a href="../engineers.html">For engineers</a> says how to build it and has
programs to begin with; most begin with ${['core/document/document.h', 'core/rollout/evaluator.h', 'core/search/search.h'].map((path) => `<a href="../${addressOf(path)}"><code>${path.split('/').pop()}</code></a>`).join(', ')}.</p>
${shelves(headers).map(({ name, title, sentence, paths }) => `<h2 id="${name}">${escaped(title)} <small>core/${name}</small></h2>
${sentence && `<p>${escaped(sentence)}</p>\n`}<ul class="shelf">
${paths.map((path) => `<li><a${attributes({ href: `../${addressOf(path)}` })}>${escaped(path.split('/').pop() ?? path)}</a>\n<p>${escaped(sentenceOf(headers.get(path) ?? ''))}</p></li>`).join('\n')}
</ul>`).join('\n')}
</main>
</div>`,
  };
}

/**
 * @param {string} root  of the repository @param {{source: string, address: string}[]} pages  of the book, for links
 * @returns {Promise<Reference | undefined>} undefined: Doxygen is not installed
 */
export async function readReference(root, pages) {
  const headers = await headersOf(root);
  const compounds = await askDoxygen(headers, join(root, 'build/reference'));
  if (!compounds) return undefined;
  const symbols = symbolsOf(compounds);
  const names = new Names(symbols, headers.keys(), pages);
  const made = [...headers].map(([path, text]) => headerPage(path, text, symbols.get(path) ?? [], names));
  const folders = shelves(headers).map(({ name }) => /** @type {[string, string]} */ ([`core/${name}`, `${REFERENCE.address}#${name}`]));
  return {
    sheets: [firstPage(headers), ...made.map(({ sheet }) => sheet)],
    searched: made.map(({ searched }) => searched),
    addresses: new Map([['core', REFERENCE.address], ...folders, ...[...headers.keys()].map((path) => /** @type {[string, string]} */ ([path, addressOf(path)]))]),
  };
}
