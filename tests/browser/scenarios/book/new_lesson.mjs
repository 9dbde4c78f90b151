// SPDX-License-Identifier: MIT
// A lesson is written in the page, saved, and taken by the book's build as it is.
import assert from 'node:assert/strict';
import { cp, mkdtemp, readFile, rm, symlink, writeFile } from 'node:fs/promises';
import { execFile } from 'node:child_process';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { promisify } from 'node:util';
import { ROOT } from '../../browsers.mjs';
import { ONE_BROWSER, PATIENCE_MS } from '../../page_driver.mjs';
import { until } from './learning_system.mjs';
import { recordFiles, saved } from './saved_files.mjs';

/** @typedef {import('../all.mjs').Visit} Visit */
/** @typedef {import('../../browsers.mjs').Page} Page */

/** @param {Visit} visit */
async function open({ browser, address }) {
  const page = await (await browser.createBrowserContext()).newPage();
  /** @type {string[]} */
  const complaints = [];
  page.on('pageerror', (error) => complaints.push(/** @type {Error} */ (error).message));
  page.on('console', (message) => { if (message.type() === 'error') complaints.push(message.text()); });
  page.on('response', (response) => { if (response.status() >= 400) complaints.push(`${response.status()} ${response.url()}`); });
  page.on('request', (request) => { if (/^https?:/.test(request.url()) && !request.url().startsWith(address)) complaints.push(`asks ${request.url()}`); });
  await page.evaluateOnNewDocument(recordFiles);
  await page.goto(`${address}book/new-lesson.html`);
  await previewed(page);
  return { page, complaints };
}

/** @param {Page} page @returns {Promise<string>} how often it was made */
const previewed = async (page, before = '') => {
  await page.waitForFunction((last) => ![undefined, last].includes(document.getElementById('lesson-preview')?.dataset.shown), { timeout: PATIENCE_MS }, before);
  return page.evaluate(() => document.getElementById('lesson-preview')?.dataset.shown ?? '');
};
/** @param {Page} page @returns {Promise<string[]>} */
const faults = (page) => page.$$eval('#lesson-faults button', (buttons) => buttons.map((button) => button.textContent ?? ''));
/** @param {Page} page @param {string} kind @param {RegExp} said */
async function insert(page, kind, said) {
  await page.$eval(`#${kind}-insert`, (button) => /** @type {HTMLElement} */ (button).click()); // what was inserted before may move it
  await until(`${said}`, page, ([id, pattern]) => new RegExp(pattern).test(document.getElementById(id)?.textContent ?? ''), [`${kind}-state`, said.source]);
}

/** A copy of the repository and of the site, in which a lesson may be added. @param {string} site @param {(add: (name: string, text: string) => Promise<void>, build: () => Promise<string>, built: string) => Promise<void>} use  build: returns what it complains about */
async function inCopy(site, use) {
  const folder = await mkdtemp(join(tmpdir(), 'gaitsmith-book-'));
  try {
    for (const part of ['docs', 'examples', 'core', 'shell/words', 'LICENSE']) await cp(join(ROOT, part), join(folder, part), { recursive: true });
    await cp(join(ROOT, 'web'), join(folder, 'web'), { recursive: true, filter: (name) => !name.endsWith('node_modules') });
    await symlink(join(ROOT, 'web/node_modules'), join(folder, 'web/node_modules'));
    await cp(site, join(folder, 'site'), { recursive: true });
    const build = () => promisify(execFile)(process.execPath, [join(folder, 'web/book/build.mjs'), join(folder, 'site')]).then(() => '', ({ stderr }) => /** @type {string} */ (stderr));
    await use((name, text) => writeFile(join(folder, 'docs/lessons', name), text), build, join(folder, 'site/book'));
  } finally {
    await rm(folder, { recursive: true });
  }
}

/** @param {Visit} visit */
async function write(visit) {
  const { page, complaints } = await open(visit);
  const motions = JSON.parse(await readFile(join(visit.site, 'gallery/motions.json'), 'utf8'));
  const [{ link: first }, { link: second }] = motions;
  await page.type('#lesson-title', 'Über "Hopping" & falling');
  await page.type('#lesson-open', `${visit.address}?panels=style#${first}`);
  await page.keyboard.press('Tab');
  assert.equal(await page.$eval('#lesson-open', (field) => /** @type {HTMLInputElement} */ (field).value), `../../web/index.html?panels=style#${first}`, 'a pasted link becomes one of the book');
  await page.evaluate(() => {
    const field = /** @type {HTMLTextAreaElement} */ (document.getElementById('lesson-text'));
    field.setSelectionRange(field.value.indexOf('## Notice'), field.value.indexOf('## Notice'));
  });
  await page.$$eval('#lesson-insert details', (parts) => { for (const part of parts) part.open = true; });
  // A goal with a fault is not inserted, nor is a motion that does not open.
  await page.type('#goal-conditions', 'distence >= 1');
  await page.type('#goal-words', 'Go a metre.');
  await insert(page, 'goal', /“distence >= 1” is not a condition/);
  await page.$eval('#goal-conditions', (field) => { /** @type {HTMLInputElement} */ (field).value = 'distance >= 1'; });
  await insert(page, 'goal', /^Inserted/);
  await page.type('#motion-link', `${visit.address}#AZ4broken`);
  await page.type('#motion-words', 'A figure runs to the right');
  await insert(page, 'motion', /does not open/);
  await page.$eval('#motion-link', (field, link) => { /** @type {HTMLInputElement} */ (field).value = link; }, `${visit.address}?edit#${second}`);
  await insert(page, 'motion', /^Inserted/);
  await page.$eval('#motion-strip', (box) => /** @type {HTMLElement} */ (box).click());
  await insert(page, 'motion', /^Inserted/);
  await page.type('#predict-question', 'How far?');
  await page.type('#predict-answers', '0 to 40 by 1 m');
  await insert(page, 'predict', /^Inserted/);
  await page.type('#quiz-question', 'Why?');
  await page.type('#quiz-answer-1', 'So.');
  await insert(page, 'quiz', /each with an explanation/);
  await page.type('#quiz-why-1', 'Yes.');
  await page.type('#quiz-answer-2', 'No.');
  await page.type('#quiz-why-2', 'It is not.');
  await insert(page, 'quiz', /^Inserted/);
  await until('nothing to correct', page, () => document.getElementById('faults-heading')?.textContent === 'Nothing to correct' && document.querySelectorAll('#lesson-preview .quiz').length === 1);
  assert.deepEqual(await page.evaluate(() => ['.goal', '.quiz', '.predict', 'a[href*="index.html?"]', '.strip img[src^="data:image/svg+xml,"]', '#shown-notice']
    .map((kind) => document.querySelectorAll(`#lesson-preview ${kind}`).length)), [1, 1, 1, 2, 2, 1]);
  // The preview's question answers.
  await page.$eval('#lesson-preview .quiz input', (choice) => /** @type {HTMLElement} */ (choice).click());
  await until('the explanation', page, () => /Right\. Yes\./.test(document.querySelector('#lesson-preview .feedback')?.textContent ?? ''));
  // The draft stays.
  await page.reload();
  await previewed(page);
  assert.deepEqual(await faults(page), []);
  await page.$eval('#lesson-save', (button) => /** @type {HTMLElement} */ (button).click());
  const [{ name, bytes }] = await saved(page);
  assert.equal(name, 'uber-hopping-falling.md');
  const text = bytes.toString('utf8');
  assert.match(text, /^---\ntitle: Über "Hopping" & falling\nminutes: 10\nopen: \.\.\/\.\.\/web\/index\.html\?panels=style#\S+\n---\n/);
  assert.match(text, /^\[motion-1\]: \S+#\S+\n\[motion-2\]: \S+#\S+\n$/m);

  // Errors as the build says them, each with its line.
  const bad = text.replace('distance >= 1', 'distence >= 1').replace('( ) No.', '(x) No.').replace('## Do\n', '## Do\n[gone](../gone.md) [x](javascript:alert(1)) [y](../physics.md#nowhere)\n').replace('minutes: 10', 'minutes: x');
  assert.notEqual(bad, text);
  const header = bad.split('\n').indexOf('---', 1) + 1;
  const file = join(await mkdtemp(join(tmpdir(), 'gaitsmith-lesson-')), name);
  await writeFile(file, bad);
  const shown = await page.evaluate(() => document.getElementById('lesson-preview')?.dataset.shown ?? '');
  const chooser = /** @type {NonNullable<Awaited<ReturnType<Page['$']>>>} */ (await page.$('#lesson-file'));
  await /** @type {any} */ (chooser).uploadFile(file);
  await previewed(page, shown);
  const seen = (await faults(page)).sort();
  assert.equal(await page.$eval('#lesson-minutes', (field) => /** @type {HTMLInputElement} */ (field).value), '', 'a number field takes no letter');

  await inCopy(visit.site, async (add, build, built) => {
    await add(name, text);
    await add('another-new-one.md', text.replace('Über', 'About'));
    assert.equal(await build(), '', 'the saved file is taken as it is');
    const lessons = JSON.parse(await readFile(join(built, 'lessons.json'), 'utf8'));
    assert.deepEqual(lessons.slice(-2).map((/** @type {any} */ { title }) => title), ['12. About "Hopping" & falling', '13. Über "Hopping" & falling'], 'two new lessons have two numbers');
    assert.deepEqual([lessons.at(-1).goals, lessons.at(-1).quizzes.length, lessons.at(-1).predictions.length], [['distance >= 1'], 1, 1]);
    const page_ = await readFile(join(built, 'lessons/uber-hopping-falling.html'), 'utf8');
    assert.match(page_, /<h1>Über &quot;Hopping&quot; &amp; falling<\/h1>/);
    assert.match(page_, /data-goal="distance &gt;= 1"/);
    const [, strip] = /src="\.\.\/(strips\/motion-\w+\.svg)"/.exec(page_) ?? [];
    assert.match(await readFile(join(built, strip), 'utf8'), /<svg/);
    // The same faults, but for the minutes, which the form leaves out.
    await add(name, bad.replace('minutes: x\n', ''));
    const said = (await build()).trim().split('\n').map((line) => {
      const [, number, sentence] = /^docs\/lessons\/[\w-]+\.md:(\d+): (.*)$/.exec(line) ?? [];
      const place = Number(number) - (header - 1);
      return place < 1 ? `Above the text: ${sentence}` : `Line ${place}: ${sentence}`;
    });
    assert.deepEqual(seen, said.sort());
    assert.ok(said.length >= 4, said.join());
  });
  assert.deepEqual(complaints, []);
  await page.browserContext().close();
}

/** A file of a stranger. @param {Visit} visit */
async function strangers(visit) {
  const { page, complaints } = await open(visit);
  const evil = ['---', 'title: <img src=x onerror="evil=1"><script>evil=1</script>', 'minutes: 5', 'open: javascript:evil=1', '---',
    '<script>evil=1</script><img src=x onerror="evil=1"><iframe src="javascript:evil=1"></iframe>', '',
    '[a](javascript:evil=1) [b](JaVaScRiPt:evil=1) [c](data:text/html,<script>evil=1</script>) <javascript:evil=1> [d][e]', '![x](data:image/svg+xml,<svg onload=evil=1>) ![y](https://example.org/x.png) ![z](x.json)',
    '```quiz', '<b onclick=evil=1>Why?</b>', '(x) <svg onload=evil=1> | " onfocus=evil=1 autofocus x="', '( ) b | no', '```',
    '```goal', 'distance >= 1" onmouseover="evil=1', '<script>evil=1</script>', '```', '```do', '{"call": "run", "args": ["\\" onclick=evil=1"], "label": "<script>evil=1</script>"}', '```',
    '```predict', '" autofocus onfocus="evil=1', '0 to 4 by 1 "onfocus=evil=1', '```', '## <img src=x onerror=evil=1>', '## lesson-save', '[%](%) ![%](%E0%A4%A) [l](//example.org/x)', '', '[e]: javascript:evil=1', ''].join('\n');
  const folder = await mkdtemp(join(tmpdir(), 'gaitsmith-lesson-'));
  await writeFile(join(folder, 'evil.md'), evil);
  const chooser = /** @type {NonNullable<Awaited<ReturnType<Page['$']>>>} */ (await page.$('#lesson-file'));
  // What is written here is not lost to a wrong file, nor to a lesson that is opened once.
  await page.type('#lesson-title', 'My own');
  await writeFile(join(folder, 'shopping.md'), 'Milk, bread');
  const says = (/** @type {string} */ words) => until(words, page, (wanted) => document.getElementById('lesson-state')?.textContent?.includes(wanted) ?? false, words);
  await /** @type {any} */ (chooser).uploadFile(join(folder, 'shopping.md'));
  await says('shopping.md is not a lesson');
  await /** @type {any} */ (chooser).uploadFile(join(folder, 'evil.md'));
  await says('The text here is not saved');
  assert.equal(await page.$eval('#lesson-title', (field) => /** @type {HTMLInputElement} */ (field).value), 'My own');
  await /** @type {any} */ (chooser).uploadFile(join(folder, 'evil.md'));
  await until('the preview', page, () => /Why\?/.test(document.getElementById('lesson-preview')?.textContent ?? ''));
  const found = await page.evaluate(() => {
    const preview = /** @type {HTMLElement} */ (document.getElementById('lesson-preview'));
    const all = [...preview.querySelectorAll('*')];
    for (const element of all) for (const type of ['click', 'focus', 'mouseover', 'load', 'error']) if (!(element instanceof HTMLAnchorElement)) element.dispatchEvent(new Event(type));
    return {
      ran: 'evil' in window,
      elements: all.filter(({ localName }) => ['script', 'iframe', 'object', 'embed', 'style', 'form', 'link', 'base', 'meta'].includes(localName)).length,
      attributes: all.flatMap(({ attributes }) => [...attributes]).filter(({ name }) => /^on|^style$|^formaction$/.test(name)).map(({ name }) => name),
      addresses: all.flatMap((element) => ['href', 'src', 'action'].map((name) => element.getAttribute(name) ?? '')).filter((value) => /^\s*(javascript|data:text|vbscript)/i.test(value)),
      save: document.querySelectorAll('#lesson-save').length,
    };
  });
  assert.deepEqual(found, { ran: false, elements: 0, attributes: [], addresses: [], save: 1 });
  assert.ok((await faults(page)).length > 3);
  assert.deepEqual(complaints, []);
  await rm(folder, { recursive: true });
  await page.browserContext().close();
}

/** @type {import('../all.mjs').Scenario[]} */
export const NEW_LESSON_SCENARIOS = [
  ['a lesson is written in the page, and the build takes the saved file', write, ONE_BROWSER],
  ['a new lesson shows a stranger\'s file without running anything of it', strangers, ONE_BROWSER],
];
