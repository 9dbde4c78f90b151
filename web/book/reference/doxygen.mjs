// SPDX-License-Identifier: MIT
// Runs Doxygen on core's headers and reads its XML.
import { spawn } from 'node:child_process';
import { mkdir, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { forDoxygen } from './comments.mjs';
import { parsed } from './xml.mjs';

/** @typedef {import('./xml.mjs').Element} Element */

const SETTINGS = `
INPUT = core
FILE_PATTERNS = *.h
RECURSIVE = YES
OUTPUT_DIRECTORY = .
GENERATE_XML = YES
GENERATE_HTML = NO
GENERATE_LATEX = NO
XML_PROGRAMLISTING = NO
EXTRACT_ALL = YES
BUILTIN_STL_SUPPORT = YES
AUTOLINK_SUPPORT = NO
EXCLUDE_SYMBOLS = GAITSMITH_*
QUIET = YES
WARNINGS = NO
WARN_IF_DOC_ERROR = NO
WARN_IF_INCOMPLETE_DOC = NO
`;

/** Runs Doxygen. @param {string} folder @returns {Promise<boolean>} false: it is not installed */
function run(folder) {
  return new Promise((resolve, reject) => {
    const child = spawn('doxygen', ['-'], { cwd: folder, stdio: ['pipe', 'ignore', 'inherit'] });
    child.once('error', (/** @type {NodeJS.ErrnoException} */ error) => (error.code === 'ENOENT' ? resolve(false) : reject(error)));
    child.once('close', (code) => (code === 0 ? resolve(true) : reject(new Error(`doxygen ended with ${code}`))));
    child.stdin.on('error', () => {}); // if Doxygen is not installed
    child.stdin.end(SETTINGS);
  });
}

/**
 * @param {Map<string, string>} headers  by path in the repository
 * @param {string} folder  for temporary files
 * @returns {Promise<Element[] | undefined>} the `compounddef` elements; undefined: Doxygen is not installed
 */
export async function askDoxygen(headers, folder) {
  await rm(folder, { recursive: true, force: true });
  for (const [path, text] of headers) {
    await mkdir(dirname(join(folder, path)), { recursive: true });
    await writeFile(join(folder, path), forDoxygen(text));
  }
  if (!await run(folder)) return undefined;
  const files = (await readdir(join(folder, 'xml'))).filter((name) => /^(class|struct|namespace).*\.xml$/.test(name)).sort();
  const roots = await Promise.all(files.map(async (name) => parsed(await readFile(join(folder, 'xml', name), 'utf8'))));
  return roots.flatMap((root) => root.one('doxygen')?.all('compounddef') ?? []);
}
