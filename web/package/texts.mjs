// SPDX-License-Identifier: MIT
// The texts that come with a package: licence, notices, changes, manual page. Written where the package is installed.
//
//   node web/package/texts.mjs program|library <folder where it is installed>
//   node web/package/texts.mjs header|python|site <folder>
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { commit, project, textOf } from './release.mjs';
import { noticesOf } from './third_party.mjs';

const LICENSE = textOf('LICENSE');

/** gaitsmith.h is one file that people copy, so its licence is inside. */
function header() {
  const name = 'core/runtime/gaitsmith.h';
  const [first, ...rest] = textOf(name).split('\n');
  if (!/SPDX-License-Identifier: MIT/.test(first)) throw new Error(`${name} does not begin with its licence`);
  return [first, `/* gaitsmith.h of Gaitsmith ${project().version}\n\n${LICENSE.trim().replace(/^(?=.)/gm, '   ')} */`, ...rest].join('\n');
}

/** The same bytes on every machine. @param {string} text */
function zipped(text) {
  const bytes = gzipSync(text, { level: 9 });
  bytes[9] = 3; // the system in the header of gzip: Unix
  return bytes;
}

/** @type {Record<string, () => Record<string, string | Uint8Array> | Promise<Record<string, string | Uint8Array>>>} */
const TEXTS = {
  program: async () => ({
    'share/doc/gaitsmith/copyright': `${LICENSE}\n${noticesOf('program')}`,
    'share/doc/gaitsmith/changelog.gz': zipped(textOf('CHANGELOG.md')),
    'share/man/man1/gaitsmith.1.gz': zipped((await import('./manual_page.mjs')).manualPage(textOf('docs/command-line.md'), { ...project(), date: commit().time.slice(0, 10) })),
  }),
  library: () => ({ 'share/doc/gaitsmith/THIRD-PARTY.txt': noticesOf('library') }),
  python: () => ({ LICENSE, 'THIRD-PARTY.txt': noticesOf('python') }),
  site: () => ({ 'compiled.LICENSE.txt': noticesOf('site') }),
  header: () => ({ [`gaitsmith-${project().version}.h`]: header() }),
};

const [name, folder] = process.argv.slice(2);
if (!folder || !(name in TEXTS)) throw new Error('texts: of which package, and where to?');
for (const [file, text] of Object.entries(await TEXTS[name]())) {
  const path = join(folder, file);
  mkdirSync(join(path, '..'), { recursive: true });
  writeFileSync(path, text);
}
