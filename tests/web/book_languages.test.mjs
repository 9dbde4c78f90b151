// SPDX-License-Identifier: MIT
// The languages of the book: whole tables, texts that fit their places, and pages that have the structure of the English
// ones. What a language lacks: node web/languages/missing.mjs <code>
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { existsSync } from 'node:fs';
import { mkdir, mkdtemp, readFile, readdir, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { Faults } from '../../web/book/faults.mjs';
import { liveTexts, liveWords } from '../../web/book/languages/live_words.mjs';
import { laidOver } from '../../web/book/languages/overlay.mjs';
import { prepared } from '../../web/languages/prepared.mjs';
import { compareWithOriginal } from '../../web/book/languages/same_structure.mjs';
import { ENGLISH, readLanguages } from '../../web/book/languages/words.mjs';
import { Links } from '../../web/book/links.mjs';
import { readPages } from '../../web/book/pages.mjs';
import { BOOK, CANVAS, HINTS, bookWords, filesIn, pagesOf, tableOf } from '../../web/languages/tables.mjs';

/** @typedef {import('../../web/book/languages/words.mjs').Language} Language */
/** @typedef {import('../../web/book/pages.mjs').Page} Page */

const ROOT = fileURLToPath(new URL('../../', import.meta.url));
const SITE = process.env.GAITSMITH_SITE && resolve(process.env.GAITSMITH_SITE);

/** @type {Language[]} without English */
let languages = [];
/** @type {Set<string>} */
let needed = new Set();
before(async () => {
  [, ...languages] = await readLanguages(ROOT);
  needed = await bookWords(ROOT);
});

test('languages: the playground, its tooltips and the book have the same ones', async () => {
  const of = async (/** @type {string} */ folder) => (await readdir(join(ROOT, folder))).filter((file) => file !== 'en.json').sort();
  const names = await of(CANVAS);
  assert.deepEqual([await of(HINTS), await of(BOOK)], [names, names]);
  assert.deepEqual(languages.map(({ code }) => `${code}.json`), names);
});

test('languages: every text of the book is translated, no text stands in two tables, and none is left over', async () => {
  assert.ok(needed.size > 150, `only ${needed.size} texts were found`);
  const sources = await filesIn(ROOT, 'web', /^(book\/.*\.m?js|(classroom|explorable)\/.*\.js|share\/work\.js)$/);
  // A call with anything but a literal would hide a text from this test.
  const hidden = sources.flatMap((source) => source.match(/(?<![\w$.])trLater\((?!')[^)]*\)/g) ?? []);
  assert.deepEqual(hidden, []);
  for (const { code, words, canvas } of languages) {
    const twice = (await readFile(join(ROOT, BOOK, `${code}.json`), 'utf8')).match(/^ {2}"(?:[^"\\]|\\.)*":/gm) ?? [];
    assert.equal(new Set(twice).size, twice.length, `${BOOK}/${code}.json has a text twice`);
    assert.deepEqual([...needed].filter((text) => !words[text] && !canvas.words[text]), [], `${BOOK}/${code}.json lacks texts`);
    assert.deepEqual(Object.keys(words).filter((text) => canvas.words[text]), [], `${CANVAS}/${code}.json has these texts, too`);
    assert.deepEqual(Object.keys(words).filter((text) => !needed.has(text)), [], `${BOOK}/${code}.json has texts that are used nowhere`);
  }
});

test('languages: the book’s translations have the same places to fill in', () => {
  const places = (/** @type {string} */ text) => [...new Set(text.match(/\{\d\}/g))].sort();
  for (const { code, words } of languages) {
    for (const [english, text] of Object.entries(words)) {
      assert.deepEqual(places(text), places(english), `${code}: "${english}"`);
      assert.equal(text, text.trim(), `${code}: "${english}"`);
    }
  }
});

/** Short texts stand on buttons and beside sliders. @param {string} english */
const mostLetters = (english) => Math.round(1.8 * english.length) + 6;

test('languages: no translation is much longer than the English text', async () => {
  assert.ok('Speicherungsvorgang'.length > mostLetters('Save'), 'the bound can fail');
  for (const { code, words, canvas } of languages) {
    const hints = await tableOf(ROOT, HINTS, code), english = await tableOf(ROOT, HINTS, 'en');
    const pairs = [...Object.entries({ ...canvas.words, ...words }), ...Object.keys(english).map((id) => [english[id], hints[id] ?? ''])];
    assert.deepEqual(pairs.filter(([text, translated]) => translated.length > mostLetters(text)).map(([text, translated]) => `${text} → ${translated}`), [], code);
  }
});

test('languages: translated pages have the structure, the links and the numbers of the English ones', async () => {
  const faults = new Faults();
  const pages = await readPages(ROOT, faults);
  assert.deepEqual(faults.sentences, []);
  const lessons = (await pagesOf(ROOT)).filter((name) => name.startsWith('lessons/'));
  for (const { code } of languages) {
    const translated = pages.filter(({ language }) => language.code === code).map(({ source }) => source.slice(`docs/${code}/`.length));
    assert.deepEqual((await pagesOf(ROOT)).filter((name) => !translated.includes(name)), [], `docs/${code} lacks pages`);
    for (const lesson of lessons) {
      const text = await readFile(join(ROOT, 'docs', code, lesson), 'utf8');
      const prose = text.replace(/^---.*?^---/ms, '').replace(/^```.*?^```$/gms, '').replace(/\]\([^)]*\)/g, '').replace(/[#*|[\]-]/g, ' ');
      const words = prose.match(/\S+/g)?.length ?? 0;
      assert.ok(words <= 480, `docs/${code}/${lesson} has ${words} words`);
    }
  }
});

/** @param {string} english @param {string} german @returns {{original: Page, page: Page}} */
function pair(english, german) {
  const language = /** @type {Language} */ ({ ...ENGLISH, code: 'de', folder: 'de/', decimalMark: ',', groupMark: '.' });
  const original = /** @type {Page} */ ({ source: 'docs/lessons/1-x.md', address: 'lessons/1-x.html', name: '1-x', body: english, before: 4, language: ENGLISH, lesson: /** @type {any} */ ({}) });
  return { original, page: { ...original, source: 'docs/de/lessons/1-x.md', address: 'de/lessons/1-x.html', body: german, before: 3, language, original } };
}

/** @param {string} english @param {string} german */
function faultsOf(english, german) {
  const faults = new Faults();
  compareWithOriginal(pair(english, german).page, faults);
  return faults.sentences;
}

test('structure: what differs is reported with both lines', () => {
  const english = '# One\n\nIt gets 4,000.5 m, see [this](../../examples/a.json) and [that](../b.md).\n\n- a\n- b\n';
  assert.deepEqual(faultsOf(english, '# Eins\n\nEs kommt 4.000,5 m weit, siehe [dies](../../../examples/a.json) und [das](../b.md).\n\n- a\n- b\n'), []);
  assert.deepEqual(faultsOf(english, '# Eins\n\nEs kommt 4.000,6 m weit, siehe [dies](../../../examples/a.json) und [das](../b.md).\n\n- a\n- b\n'),
    ['docs/de/lessons/1-x.md:6: docs/lessons/1-x.md:7 has the numbers 4000.5, this page 4000.6']);
  assert.match(faultsOf(english, '# Eins\n\nEs kommt 4.000,5 m weit, siehe [dies](../../../examples/c.json) und [das](../b.md).\n\n- a\n- b\n')[0], /:6: .*:7 links docs\/b\.md, examples\/a\.json, this page docs\/b\.md, examples\/c\.json$/);
  assert.match(faultsOf(english, '# Eins\n\nEs kommt 4.000,5 m weit, siehe [dies](../../../examples/a.json) und [das](../b.md).\n\n- a\n')[0], /:8: .*:10 has an item of a list here, this page has nothing more$/);
  assert.match(faultsOf(english, '## Eins\n\nText.\n')[0], /:4: .*:5 has a heading # here, this page has a heading ##$/);
});

test('blocks: conditions, right answers and calls come from the English file', () => {
  const { page } = pair('', '');
  const over = (/** @type {string} */ kind, /** @type {string} */ english, /** @type {string} */ german) => {
    const faults = new Faults();
    return { text: laidOver(kind, english, page, 9, german, faults), faults: faults.sentences };
  };
  assert.deepEqual(over('goal', 'travel >= 8\nReach 8 m.\n', 'Erreiche 8 m.\n'), { text: 'travel >= 8\nErreiche 8 m.\n', faults: [] });
  assert.match(over('goal', 'travel >= 8\nReach 8 m.\n', 'travel >= 7\nErreiche 8 m.\n').faults[0], /^docs\/de\/lessons\/1-x\.md:9: the conditions/);
  assert.deepEqual(over('quiz', 'Why?\n(x) a | b\n( ) c | d\n', 'Warum?\n( ) e | f\n( ) g | h\n'), { text: 'Warum?\n(x) e | f\n( ) g | h', faults: [] });
  assert.match(over('quiz', 'Why?\n(x) a | b\n( ) c | d\n', 'Warum?\n( ) e | f\n(x) g | h\n').faults[0], /right stands only in the English file/);
  assert.match(over('quiz', 'Why?\n(x) a | b\n( ) c | d\n', 'Warum?\n( ) e | f\n').faults[0], /2 lines, the English one has 3/);
  assert.match(over('predict', 'How?\n0 to 40 by 1 m\n', 'Wie?\n0 to 30 by 1 m\n').faults[0], /numbers/);
  assert.deepEqual(JSON.parse(over('do', '{"call": "run", "args": ["a"], "label": "Go"}', '{"label": "Los"}').text), { call: 'run', args: ['a'], label: 'Los' });
  assert.match(over('do', '{"call": "run", "label": "Go"}', '{"call": "stop", "label": "Los"}').faults[0], /"call" stands only in the English file/);
  assert.match(over('stage', '{"kind": "pay", "label": "A", "says": "b"}', '{"label": "C"}').faults[0], /"says" is missing/);
  assert.match(over('stage', '{"kind": "pay", "label": "A"}', '{"label": C}').faults[0], /JSON/);
});

test('a prepared page has only words, and passes as a translation of itself', async () => {
  const names = await pagesOf(ROOT);
  for (const name of names) {
    const english = await readFile(join(ROOT, 'docs', name), 'utf8'), text = prepared(english, names);
    assert.doesNotMatch(text, /^(open|goal|minutes):|^\(x\)|"call"|"kind"/m, name);
    for (const [, path] of text.matchAll(/\]\((?!https?:|#)([^)\s?#]+)/g)) {
      const there = join(ROOT, 'docs/xx', name, '..', path);
      assert.ok(existsSync(there) || existsSync(there.replace('docs/xx/', 'docs/')), `${name}: ${path}`);
    }
  }
});

test('a link to a page without a translation leads to the English page', async () => {
  const root = await mkdtemp(join(tmpdir(), 'languages-'));
  const files = { 'docs/a.md': '# A\n\n[x](lessons/1-x.md)\n', 'docs/de/a.md': '# A\n\n[x](lessons/1-x.md) [a](a.md)\n', 'docs/lessons/1-x.md': '---\ntitle: X\nminutes: 5\nopen: a.json\n---\nX\n',
    'web/book/words/de.json': '{}', 'shell/words/languages/de.json': '{"name": "Deutsch", "decimal_mark": ",", "group_mark": ".", "words": {}, "errors": {}, "titles": {}}' };
  for (const [file, text] of Object.entries(files)) {
    await mkdir(join(root, file, '..'), { recursive: true });
    await writeFile(join(root, file), text);
  }
  const faults = new Faults();
  const pages = await readPages(root, faults);
  const german = /** @type {Page} */ (pages.find(({ source }) => source === 'docs/de/a.md'));
  const links = new Links((file) => existsSync(join(root, file)), pages, /** @type {any} */ ({}), faults);
  assert.deepEqual([await links.resolve(german, 3, 'lessons/1-x.md'), await links.resolve(german, 3, 'a.md')], [{ href: '../lessons/1-x.html' }, { href: '../de/a.html' }]);
  assert.deepEqual(faults.sentences, []);
  await rm(root, { recursive: true });
});

test('the command that lists what is missing finds everything for a new language, and nothing for the others', async () => {
  const run = async (/** @type {string[]} */ ...args) => promisify(execFile)(process.execPath, [join(ROOT, 'web/languages/missing.mjs'), ...args]);
  const { stdout, stderr } = await run('xx');
  const all = JSON.parse(stdout);
  assert.ok(Object.keys(all[`${CANVAS}/xx.json`].words).length > 1000 && Object.keys(all[`${HINTS}/xx.json`]).length > 200 && Object.keys(all[`${BOOK}/xx.json`]).length > 150);
  assert.match(stderr, /docs\/xx\/lessons\/1-a-rule\.md is missing/);
  for (const { code } of languages) {
    const own = await run(code);
    assert.deepEqual(JSON.parse(own.stdout), { [`${CANVAS}/${code}.json`]: { words: {}, errors: {}, titles: {} }, [`${HINTS}/${code}.json`]: {}, [`${BOOK}/${code}.json`]: {} }, code);
  }
  await assert.rejects(run('en'), /which language/);
  await assert.rejects(run('xx', '../../LICENSE'), /is none of the pages/);
});

test('the scripts of the book get the words that they show, and no others', async () => {
  const texts = await liveTexts(join(ROOT, 'web'));
  assert.ok(texts.has('Reached.') && texts.has('Copied') && texts.has('{1} tries: {2}.') && !texts.has('Make the link'));
  for (const language of languages) assert.match(liveWords(language, texts), new RegExp(`^import .*\\nsetLanguage\\("${language.code}", ".*"\\);\\n$`));
});

if (SITE) {
  test('built pages: each names its language and the other ones, and has no English furniture', async () => {
    for (const { code, name, folder } of languages) {
      for (const page of ['index', 'wall', 'teachers', 'how-things-learn-to-move', 'lesson-answers', 'quiz', 'packages', 'new-lesson', 'lessons/1-a-rule']) {
        const html = await readFile(join(SITE, 'book', folder, `${page}.html`), 'utf8');
        const english = await readFile(join(SITE, 'book', `${page}.html`), 'utf8');
        assert.match(html, new RegExp(`<html lang="${code}">`), page);
        assert.ok(html.includes('hreflang="en"') && english.includes(`hreflang="${code}"`), page);
        assert.ok(html.includes(`<span aria-current="page">${name}</span>`) && english.includes(`>${name}</a>`), page);
        assert.doesNotMatch(html, /Skip to the text|Hand in|Set this goal|Open in the playground|On this page|Save the package|I do not know|Insert<|Your sentences|undefined/, page);
      }
      const lesson = await readFile(join(SITE, 'book', folder, 'lessons/1-a-rule.html'), 'utf8');
      assert.match(lesson, new RegExp(`index\\.html\\?lang=${code}&amp;`));
      assert.match(lesson, /id="explain"/, 'headings have the same names in all languages');
      /** @type {any[][]} */
      const [facts, originals] = await Promise.all(['', folder].map(async (where) => JSON.parse(await readFile(join(SITE, 'book', where, 'lessons.json'), 'utf8'))));
      const shape = (/** @type {any} */ { name: lessonName, goals, worlds, figures, predictions, quizzes }) => ({ lessonName, goals, worlds, figures, right: quizzes.map((/** @type {any} */ { right }) => right),
        counts: [...predictions, ...quizzes].map((/** @type {any} */ { answers }) => answers.length) });
      assert.deepEqual(facts.map(shape), originals.map(shape), 'goals, right answers and what is opened');
    }
  });
}
