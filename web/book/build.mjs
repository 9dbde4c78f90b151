// SPDX-License-Identifier: MIT
// Builds the book: docs/ as pages beside the playground.
//
//   node web/book/build.mjs <folder of the built site>
//
// Needs the site's engine, which opens the documents that pages link to. Prints errors of pages with file and line.
import { execFile } from 'node:child_process';
import { existsSync } from 'node:fs';
import { copyFile, mkdir, readFile, rm, writeFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { basename, dirname, join, resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { promisify } from 'node:util';
import { grouped, LESSONS, UNLISTED } from './contents.mjs';
import { cutFaces } from './faces.mjs';
import { Faults } from './faults.mjs';
import { indexPage } from './index_page.mjs';
import { lessonPage } from './lesson_page.mjs';
import { liveTexts, liveWords, liveWordsOf } from './languages/live_words.mjs';
import { ENGLISH, readLanguages } from './languages/words.mjs';
import { Links } from './links.mjs';
import { Markdown } from './markdown.mjs';
import { missingPage } from './missing_page.mjs';
import { readPages } from './pages.mjs';
import { Playground } from './playground.mjs';
import { readReference, REFERENCE } from './reference.mjs';
import { searchIndex } from './search_index.mjs';
import { dayAndNight } from './strip_colours.mjs';
import { htmlPage } from './template.mjs';
import { textPage } from './text_page.mjs';
import { bundled } from './teaching/bundle.mjs';
import { newLessonPage } from './teaching/new_lesson_page.mjs';
import { packagesPage } from './teaching/packages_page.mjs';
import { quizPage } from './teaching/quiz_page.mjs';
import { sources } from './teaching/sources.mjs';
import { wallPage } from './wall_page.mjs';
import { lessonFacts } from './lesson_facts.mjs';
import { tokens } from './tokens.mjs';

/** @typedef {import('./languages/words.mjs').Language} Language */
/** @typedef {import('./lesson_page.mjs').LessonPage} LessonPage */
/** @typedef {import('./markdown.mjs').Rendered} Rendered */
/** @typedef {import('./pages.mjs').Page} Page */
/** @typedef {import('./reference.mjs').Reference} Reference */
/** @typedef {import('./template.mjs').Sheet} Sheet */

const HERE = dirname(fileURLToPath(import.meta.url));
const ROOT = join(HERE, '../..');
const SCRIPTS = ['find.js', 'lesson.js', 'look.js', 'player.js', 'quiz.js', 'shelf.js', 'stored.js'];
const STYLES = ['book.css', 'lesson.css', 'explorable.css', 'reference.css', 'wall.css', 'teaching/teaching.css'];

/** @param {string} file @param {string | Uint8Array} contents */
async function put(file, contents) {
  await mkdir(dirname(file), { recursive: true });
  await writeFile(file, contents);
}

/** @param {Page} page @returns {page is LessonPage} */
const isLesson = (page) => page.lesson !== undefined;

/** @param {string} site  the built one */
async function playgroundOf(site) {
  const { Engine } = await import(pathToFileURL(join(site, 'search/engine.js')).href);
  const tables = await import(pathToFileURL(join(site, 'catalogue/catalogue.js')).href);
  return new Playground(await Engine.load(), tables, (file) => readFile(join(ROOT, file), 'utf8'));
}

/** Renders all pages. Throws if a page has an error. @param {string} site */
async function read(site) {
  const faults = new Faults();
  const languages = await readLanguages(ROOT);
  const pages = await readPages(ROOT, faults, languages);
  const reference = await readReference(ROOT, pages);
  if (!reference) console.log('book: without the API reference, for Doxygen is not installed');
  const links = new Links((file) => existsSync(join(ROOT, file)), pages, await playgroundOf(site), faults, reference?.addresses);
  const markdown = new Markdown(links);
  /** @type {Map<Page, Rendered>} */
  const rendered = new Map();
  for (const page of pages) rendered.set(page, await markdown.render(page));
  links.checkAnchors((page) => rendered.get(page)?.headings.map(({ id }) => id) ?? []);
  const sheets = await compose(languages, pages, rendered, links, reference);
  faults.orThrow();
  const facts = languages.map((language) => ({ language, lessons: lessonFacts(lessonsIn(language, pages), links.playground) }));
  return { sheets, rendered, links, reference, languages, facts };
}

/** @param {Language[]} languages @param {Page[]} pages @param {Map<Page, Rendered>} rendered @param {Links} links @param {Reference | undefined} reference @returns {Promise<Sheet[]>} */
async function compose(languages, pages, rendered, links, reference) {
  const sheets = [missingPage(), ...reference?.sheets ?? []];
  for (const language of languages) {
    const own = pages.filter((page) => page.language === language);
    const lessons = lessonsIn(language, pages);
    const entries = grouped([...lessons, ...own.filter((page) => !isLesson(page))])
      .map((group) => ({ ...group, pages: group.pages.filter(({ name }) => !UNLISTED.has(name)).map((page) => entryOf(page, of(rendered, page))) }));
    if (reference && language === ENGLISH) entries.find(({ id }) => id === 'for-engineers')?.pages.splice(1, 0, { ...REFERENCE, name: 'reference' });
    sheets.push(indexPage(entries, language), wallPage(language), packagesPage(lessons, language), quizPage(language), newLessonPage(links.playground.tables, language));
    for (const { title, pages: groupPages } of grouped(own)) {
      for (const page of groupPages) sheets.push(isLesson(page) ? await lessonPage(page, of(rendered, page), lessons, links) : textPage(page, of(rendered, page), title));
    }
  }
  return sheets;
}

/** @param {Map<Page, Rendered>} rendered @param {Page} page */
const of = (rendered, page) => /** @type {Rendered} */ (rendered.get(page));

/** @param {Page} page @param {Rendered} rendered @returns {import('./index_page.mjs').Entry} */
const entryOf = (page, { title, sentence, strip }) => ({ ...page, title, sentence, strip, goals: page.lesson?.goals });

/** All lessons, in this language if there is a translation, else in English. @param {Language} language @param {Page[]} pages */
const lessonsIn = (language, pages) => pages.filter(isLesson).filter(({ original }) => !original)
  .map((lesson) => pages.filter(isLesson).find((page) => page.original === lesson && page.language === language) ?? lesson);

/** The links in a page's header. @param {Sheet} sheet @param {Sheet[]} sheets @returns {import('./template.mjs').HeaderLink[]} */
function headerLinks({ address, kind, language = ENGLISH }, sheets) {
  const { code, folder, tr } = language;
  const has = (/** @type {string} */ one) => sheets.some((sheet) => sheet.address === one);
  const here = (/** @type {string} */ one) => (address === one ? /** @type {const} */ ('page') : undefined);
  const english = folder && 'en';
  const teachers = [`${folder}teachers.html`, 'teachers.html'].find(has);
  return [
    { name: tr('Playground'), address: folder ? `../?lang=${code}` : '../' },
    ...(sheets.some((sheet) => sheet.kind === 'lesson') ? [{ name: tr('Lessons'), address: `${folder}index.html#${LESSONS.id}`, current: kind === 'lesson' ? /** @type {const} */ ('true') : undefined }] : []),
    ...(has('gallery.html') ? [{ name: tr('Gallery'), address: 'gallery.html', current: here('gallery.html'), language: english || undefined }] : []),
    { name: tr('Teachers'), ...(teachers ? { address: teachers, current: here(teachers) } : { address: `${folder}index.html#for-teachers` }) },
    ...(has(REFERENCE.address) && !folder ? [{ name: 'API', address: REFERENCE.address, current: here(REFERENCE.address) ?? (kind.includes('reference') ? /** @type {const} */ ('true') : undefined) }] : []),
    { name: tr('Docs'), address: `${folder}index.html`, current: here(`${folder}index.html`) },
  ];
}

/** The same page in all its languages. @param {Sheet} sheet @param {Sheet[]} sheets @returns {import('./languages/switch.mjs').Version[]} */
function versionsOf({ address, language = ENGLISH }, sheets) {
  const name = address.slice(language.folder.length);
  return sheets.filter(({ address: other, language: { folder } = ENGLISH }) => other === folder + name).map(({ address: other, language: its = ENGLISH }) => ({ address: other, language: its }))
    .sort((one, two) => Number(two.language === ENGLISH) - Number(one.language === ENGLISH));
}

/** @param {string} site */
async function build(site) {
  const book = join(site, 'book');
  const { sheets, rendered, links, reference, languages, facts } = await read(site);
  await rm(book, { recursive: true, force: true });
  const texts = await Promise.all(sheets.map(async (sheet) => {
    const html = htmlPage(sheet, headerLinks(sheet, sheets), versionsOf(sheet, sheets));
    await put(join(book, sheet.address), html);
    return html;
  }));
  await put(join(book, 'sources.json'), JSON.stringify(await sources(ROOT, rendered, links)));
  const { code, licences } = await bundled(join(HERE, 'teaching/new_lesson.js'));
  await put(join(book, 'new_lesson.js'), code);
  await put(join(book, 'new_lesson.LICENSE.txt'), licences);
  for (const { language, lessons } of facts) await put(join(book, language.folder, 'lessons.json'), JSON.stringify(lessons));
  for (const language of languages) {
    const own = [...rendered].filter(([page]) => page.language === language && !UNLISTED.has(page.name)).map(([{ address }, { title, sections }]) => ({ address: address.slice(language.folder.length), title, sections }));
    const decisions = (/** @type {{address: string}} */ { address }) => address === 'design.html';
    await put(join(book, language.folder, 'search.json'), searchIndex(own.filter((page) => !decisions(page))));
    if (language === ENGLISH) await put(join(book, 'design_search.json'), searchIndex(own.filter(decisions)));
  }
  // Apart, as is that of the design decisions, because only the other pages are stored for use without a network.
  if (reference) await put(join(book, 'reference/search.json'), searchIndex(reference.searched));
  const live = await liveTexts(join(HERE, '..'));
  for (const language of languages.filter((each) => each !== ENGLISH)) await put(join(book, liveWordsOf(language)), liveWords(language, live));
  for (const [name, { many, few }] of links.strips) {
    await put(join(book, `strips/${name}.svg`), dayAndNight(many));
    await put(join(book, `strips/${name}-few.svg`), dayAndNight(few));
  }
  for (const [file, address] of links.images) await put(join(book, address), await readFile(join(ROOT, file)));
  await put(join(book, 'tokens.css'), await tokens(join(ROOT, 'web/page/style.css')));
  for (const file of STYLES) await copyFile(join(HERE, file), join(book, basename(file)));
  await promisify(execFile)(process.execPath, [join(ROOT, 'web/build/minify.mjs'), book, HERE, ...SCRIPTS.map((file) => join(HERE, file))]);
  // With comments, because others read and copy this file.
  await copyFile(join(HERE, 'player.js'), join(site, 'player.js'));
  const minisearch = join(dirname(createRequire(import.meta.url).resolve('minisearch')), '../..');
  await copyFile(join(minisearch, 'dist/es/index.js'), join(book, 'minisearch.js'));
  await copyFile(join(minisearch, 'LICENSE.txt'), join(book, 'minisearch.LICENSE.txt'));
  await cutFaces(join(book, 'faces'), texts.join('') + JSON.stringify(languages.map(({ words }) => words)));
  console.log(`book: ${sheets.length} pages, ${links.strips.size} film strips`);
}

const [site] = process.argv.slice(2);
try {
  if (!site) throw new Error('the folder of the built site is missing');
  await build(resolve(site));
} catch (error) {
  console.error(error instanceof Error ? error.message : error);
  process.exitCode = 1;
}
