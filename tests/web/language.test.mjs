// SPDX-License-Identifier: MIT
// Compares the tables of shell/words/languages with the sources. They have every text that is passed to Tr or tr, with
// the same inserts, and no unused text.
import assert from 'node:assert/strict';
import { readdir, readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { fixed } from '../../web/languages/language.js';
import { canvasTexts, filesIn } from '../../web/languages/tables.mjs';
import { bookTexts, textsPassedTo } from '../../web/languages/texts.mjs';

const ROOT = fileURLToPath(new URL('../../', import.meta.url));
const TABLES = join(ROOT, 'shell/words/languages');

/**
 * words: texts of shell and page; errors: core's sentences; titles: of examples and of searches. By English text.
 * @typedef {{name: string, decimal_mark: string, group_mark: string, words: Record<string, string>,
 *   errors: Record<string, string>, titles: Record<string, string>}} Table
 */

/** @type {Map<string, Table>} by file */
const tables = new Map();
/** @type {Set<string>} */
let ofShell;
/** @type {Set<string>} */
let ofPage;
/** Texts and attributes of the page. @type {Set<string>} */
let ofMarkup;

/** @param {string} folder  in the repository @param {RegExp} names @returns {Promise<string[]>} the files' texts */
const texts = (folder, names) => filesIn(ROOT, folder, names);

/** @param {string} html */
function markup(html) {
  const plain = html.replace(/<!--.*?-->/gs, '');
  const found = [...plain.matchAll(/>([^<]+)(?=<)|="([^"]*)"/g)].map(([, text, attribute]) => text ?? attribute ?? '');
  const entities = /** @type {Record<string, string>} */ ({ amp: '&', lt: '<', gt: '>', quot: '"', nbsp: '\u00a0' });
  return found.map((text) => text.replace(/\s+/g, ' ').trim()
    .replace(/&(\w+);/g, (entity, name) => entities[name] ?? entity));
}

before(async () => {
  for (const file of await readdir(TABLES)) {
    const text = await readFile(join(TABLES, file), 'utf8');
    tables.set(file, JSON.parse(text));
    // The application refuses a table that has a text twice; JSON.parse does not.
    const parts = text.split(/^ {2}\}/m).map((part) => [...part.matchAll(/^ {4}("(?:[^"\\]|\\.)*"): /gm)].map(([, name]) => name));
    assert.ok(parts.flat().length > 300, `${file} is not written as it is read here`);
    for (const names of parts) assert.deepEqual(names.filter((name, i) => names.indexOf(name) !== i), [], `${file} has texts twice`);
  }
  ({ shell: ofShell, page: ofPage } = await canvasTexts(ROOT));
  ofMarkup = new Set((await texts('web', /^(index|breed\/breed|dialogs\/dialogs)\.html$/)).flatMap(markup));
});

test('language: literals are found in all the ways they are written', () => {
  const source = `Tr("one"), TrLater("two " // Tr("no")
    "parts"); Tr(a ? "three" : b(c, "within") ? "four" : "five {1}", "insert"); Str("no"); Tr(name); Tr("a \\"b\\"")`;
  assert.deepEqual(textsPassedTo(source, ['Tr', 'TrLater'], '"'),
    ['one', 'two parts', 'three', 'within', 'four', 'five {1}', 'a "b"']);
  assert.deepEqual(textsPassedTo('tr(\'it is\', x) + tr(`so`) + xtr(\'no\') + x.tr(\'yes\')', ['tr'], '\'"`'), ['it is', 'so', 'yes']);
  assert.deepEqual(bookTexts('const a = `<p>${tr(\'it\\\'s\')} ${up ? `${tr(\'two {1}\', 2)}` : trLater(\'three\')}`; str(\'no\'); x.tr(\'yes\')'), ['it\'s', 'two {1}', 'three', 'yes']);
  assert.deepEqual(markup('<p title="A &amp; B">  some\n text <!-- <b>no</b> --></p>'), ['A & B', 'some text']);
});

test('language: every text of the canvas and of the page has its translation', () => {
  assert.ok(ofShell.size > 300, `only ${ofShell.size} texts were found`);
  for (const [file, { words }] of tables) {
    const missing = [...ofShell, ...ofPage].filter((text) => text && !words[text]);
    assert.deepEqual(missing, [], `${file} lacks texts`);
  }
});

test('language: every motion of the gallery and of the lessons has a translated title', async () => {
  for (const document of [...await texts('examples/gallery', /\.json$/), ...await texts('examples/lessons', /\.json$/)]) {
    const { title } = JSON.parse(document);
    for (const [file, { titles }] of tables) assert.ok(titles[title], `${file}: ${title}`);
  }
});

test('language: every translated text is used', async () => {
  const core = (await texts('core', /\.(h|cpp)$/)).join('\n');
  const said = core + (await texts('shell/export', /\.(h|cpp)$/)).join('\n'); // where errors come from
  const named = core + [...await texts('shell', /\.(h|cpp)$/), ...await texts('examples', /\.json$/)].join('\n');
  for (const [file, { words, errors, titles }] of tables) {
    const unused = Object.keys(words).filter((text) => !ofShell.has(text) && !ofPage.has(text) && !ofMarkup.has(text));
    assert.deepEqual(unused, [], `${file} has words that are used nowhere`);
    const strange = Object.keys(errors).filter((text) => !(text.match(/[A-Za-z]{3,}/g) ?? []).every((word) => said.includes(word)));
    assert.deepEqual(strange, [], `${file} has sentences that nothing says`);
    const unnamed = Object.keys(titles).filter((text) => !named.includes(text.replace(/\{\d\}.*/, '')));
    assert.deepEqual(unnamed, [], `${file} has titles of nothing`);
  }
});

test('language: a translation has the same places to fill in', () => {
  const places = (/** @type {string} */ text) => [...new Set(text.match(/\{\d\}/g))].sort();
  for (const [file, { name, decimal_mark: decimal, group_mark: group, words, errors, titles }] of tables) {
    assert.ok(name && decimal && group && decimal !== group, `${file} has no name or marks`);
    for (const [english, text] of [words, errors, titles].flatMap(Object.entries)) {
      assert.deepEqual(places(text), places(english), `${file}: "${english}"`);
      assert.equal(text, text.trim(), `${file}: "${english}"`);
    }
  }
});

test('language: numbers below zero have a minus sign, not a hyphen', () => {
  assert.deepEqual([fixed(-1.25, 1), fixed(-0.001, 2), fixed(3, 0)], ['−1.3', '0.00', '3']);
});
