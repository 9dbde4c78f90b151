// SPDX-License-Identifier: MIT
// What a language still lacks (docs/languages.md).
//
//   node web/languages/missing.mjs es                      the missing words, as JSON to fill in, by file; missing pages are named on stderr
//   node web/languages/missing.mjs es lessons/1-a-rule.md  the English page, prepared for translation
import { readdir, readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { prepared } from './prepared.mjs';
import { BOOK, CANVAS, HINTS, bookWords, canvasTexts, pagesOf, tableOf } from './tables.mjs';

const ROOT = fileURLToPath(new URL('../../', import.meta.url));
const [code = '', page] = process.argv.slice(2);

/** @param {Iterable<string>} texts @param {Record<string, string>} known @param {Record<string, string>} [english]  by key; else the key is the text */
const lacking = (texts, known, english) => Object.fromEntries([...texts].filter((text) => text && !known[text]).map((text) => [text, english?.[text] ?? text]));

async function words() {
  const [canvas, book, hints, english, { shell, page: ofPage }] = await Promise.all([tableOf(ROOT, CANVAS, code), tableOf(ROOT, BOOK, code), tableOf(ROOT, HINTS, code), tableOf(ROOT, HINTS, 'en'), canvasTexts(ROOT)]);
  // Markup, core's sentences and titles are known from the other languages.
  const others = await Promise.all((await readdir(join(ROOT, CANVAS))).filter((file) => file !== `${code}.json`).map((file) => tableOf(ROOT, CANVAS, file.replace(/\.json$/, ''))));
  const keys = (/** @type {string} */ part) => new Set(others.flatMap((table) => Object.keys(table[part])));
  const { words: canvasWords = {}, errors = {}, titles = {} } = canvas;
  const all = {
    [`${CANVAS}/${code}.json`]: { words: lacking(new Set([...shell, ...ofPage, ...keys('words')]), canvasWords), errors: lacking(keys('errors'), errors), titles: lacking(keys('titles'), titles) },
    [`${HINTS}/${code}.json`]: lacking(Object.keys(english), hints, english),
    [`${BOOK}/${code}.json`]: lacking(await bookWords(ROOT), { ...Object.fromEntries([...shell, ...ofPage, ...keys('words'), ...Object.keys(canvasWords)].map((text) => [text, text])), ...book }),
  };
  console.log(JSON.stringify(all, null, 2));
  const there = (await readdir(join(ROOT, 'docs', code), { recursive: true }).catch(() => /** @type {string[]} */ ([]))).map((name) => name.replaceAll('\\', '/'));
  for (const name of (await pagesOf(ROOT)).filter((each) => !there.includes(each))) console.error(`docs/${code}/${name} is missing: node web/languages/missing.mjs ${code} ${name}`);
}

if (!/^[a-z]{2}$/.test(code) || code === 'en') {
  console.error('missing: which language? For example: node web/languages/missing.mjs es');
  process.exitCode = 1;
} else if (page === undefined) await words();
else if (!(await pagesOf(ROOT)).includes(page)) {
  console.error(`missing: "${page}" is none of the pages ${(await pagesOf(ROOT)).join(', ')}`);
  process.exitCode = 1;
} else process.stdout.write(prepared(await readFile(join(ROOT, 'docs', page), 'utf8'), await pagesOf(ROOT)));
