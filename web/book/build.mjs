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
import { Links } from './links.mjs';
import { Markdown } from './markdown.mjs';
import { missingPage } from './missing_page.mjs';
import { readPages } from './pages.mjs';
import { Playground } from './playground.mjs';
import { readReference, REFERENCE } from './reference.mjs';
import { searchIndex } from './search_index.mjs';
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
  const pages = await readPages(ROOT, faults);
  const reference = await readReference(ROOT, pages);
  if (!reference) console.log('book: without the API reference, for Doxygen is not installed');
  const links = new Links((file) => existsSync(join(ROOT, file)), pages, await playgroundOf(site), faults, reference?.addresses);
  const markdown = new Markdown(links);
  /** @type {Map<Page, Rendered>} */
  const rendered = new Map();
  for (const page of pages) rendered.set(page, await markdown.render(page));
  links.checkAnchors((page) => rendered.get(page)?.headings.map(({ id }) => id) ?? []);
  const sheets = await compose(pages, rendered, links, reference);
  faults.orThrow();
  const facts = lessonFacts(pages.filter(isLesson), links.playground);
  return { sheets, rendered, links, reference, facts };
}

/** @param {Page[]} pages @param {Map<Page, Rendered>} rendered @param {Links} links @param {Reference | undefined} reference @returns {Promise<Sheet[]>} */
async function compose(pages, rendered, links, reference) {
  const of = (/** @type {Page} */ page) => /** @type {Rendered} */ (rendered.get(page));
  const groups = grouped(pages);
  const lessons = pages.filter(isLesson);
  const entries = groups.map((group) => ({ ...group, pages: /** @type {import('./index_page.mjs').Entry[]} */ (group.pages.filter(({ name }) => !UNLISTED.has(name)).map((page) => ({ ...page, title: of(page).title, sentence: of(page).sentence, strip: of(page).strip, goals: goalsOf(page) }))) }));
  if (reference) entries.find(({ id }) => id === 'for-engineers')?.pages.splice(1, 0, { ...REFERENCE, name: 'reference' });
  const sheets = [indexPage(entries), missingPage(), wallPage(), packagesPage(lessons), newLessonPage(links.playground.tables), quizPage(), ...reference?.sheets ?? []];
  for (const { title, pages: groupPages } of groups) {
    for (const page of groupPages) sheets.push(page.lesson ? await lessonPage(/** @type {LessonPage} */ (page), of(page), lessons, links) : textPage(page, of(page), title));
  }
  return sheets;
}

/** The conditions of a lesson's goals, as the reader's progress has them. @param {Page} page */
const goalsOf = ({ body }) => [...body.matchAll(/^```goal\n(.+)$/gm)].map(([, conditions]) => conditions.trim());

/** The links in a page's header. @param {Sheet} sheet @param {Sheet[]} sheets @returns {import('./template.mjs').HeaderLink[]} */
function headerLinks({ address, kind }, sheets) {
  const has = (/** @type {string} */ one) => sheets.some((sheet) => sheet.address === one);
  const here = (/** @type {string} */ one) => (address === one ? /** @type {const} */ ('page') : undefined);
  return [
    { name: 'Playground', address: '../' },
    ...(sheets.some((sheet) => sheet.kind === 'lesson') ? [{ name: 'Lessons', address: `index.html#${LESSONS.id}`, current: kind === 'lesson' ? /** @type {const} */ ('true') : undefined }] : []),
    ...(has('gallery.html') ? [{ name: 'Gallery', address: 'gallery.html', current: here('gallery.html') }] : []),
    { name: 'Teachers', ...(has('teachers.html') ? { address: 'teachers.html', current: here('teachers.html') } : { address: 'index.html#for-teachers' }) },
    ...(has(REFERENCE.address) ? [{ name: 'API', address: REFERENCE.address, current: here(REFERENCE.address) ?? (kind.includes('reference') ? /** @type {const} */ ('true') : undefined) }] : []),
    { name: 'Docs', address: 'index.html', current: here('index.html') },
  ];
}

/** @param {string} site */
async function build(site) {
  const book = join(site, 'book');
  const { sheets, rendered, links, reference, facts } = await read(site);
  await rm(book, { recursive: true, force: true });
  const texts = await Promise.all(sheets.map(async (sheet) => {
    const html = htmlPage(sheet, headerLinks(sheet, sheets));
    await put(join(book, sheet.address), html);
    return html;
  }));
  await put(join(book, 'sources.json'), JSON.stringify(await sources(ROOT, rendered, links)));
  const { code, licences } = await bundled(join(HERE, 'teaching/new_lesson.js'));
  await put(join(book, 'new_lesson.js'), code);
  await put(join(book, 'new_lesson.LICENSE.txt'), licences);
  await put(join(book, 'lessons.json'), JSON.stringify(facts));
  await put(join(book, 'search.json'), searchIndex([...[...rendered].filter(([{ name }]) => !UNLISTED.has(name)).map(([{ address }, { title, sections }]) => ({ address, title, sections })), ...reference?.searched ?? []]));
  for (const [name, { many, few, manyByNight, fewByNight }] of links.strips) {
    await put(join(book, `strips/${name}.svg`), many.svg);
    await put(join(book, `strips/${name}-few.svg`), few.svg);
    await put(join(book, `strips/${name}-night.svg`), manyByNight.svg);
    await put(join(book, `strips/${name}-few-night.svg`), fewByNight.svg);
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
  await cutFaces(join(book, 'faces'), texts.join(''));
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
