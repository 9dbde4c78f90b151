// SPDX-License-Identifier: MIT
// Everything without a network: the book is stored when the page is idle, and the whole site is one file to take along.
import assert from 'node:assert/strict';
import { mkdir, mkdtemp, readFile, rm, utimes, writeFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { execFile } from 'node:child_process';
import { promisify } from 'node:util';
import { ROOT } from '../browsers.mjs';
import { PATIENCE_MS, PageDriver, sleep } from '../page_driver.mjs';
import { PlainServer } from '../plain_server.mjs';
import { onHost, searches, untilStored } from './offline.mjs';

/** @typedef {import('./all.mjs').Visit} Visit */
/** @typedef {import('../browsers.mjs').Page} Page */

const run = promisify(execFile);
const PATIENCE = { timeout: PATIENCE_MS };
const IDLE_MS = 6000; // twice what the page waits
/** Part of the playground's own storage. */
const AT_ONCE = /\/book\/(missing\.html|tokens\.css|book\.css|look\.js)$/;
/** The pages of the book that were fetched. @param {PlainServer} server */
const fetchedBook = (server) => server.requested.filter((path) => path.includes('/book/') && !AT_ONCE.test(path));
/** @param {PageDriver} page */
const untilComplete = (page) => page.until('the stored book', () => /Everything is stored now/.test(document.querySelector('#status')?.textContent ?? ''), 180000);
/** @param {Page} page */
const textOf = (page) => page.evaluate(() => document.querySelector('main')?.textContent?.replace(/\s+/g, ' ') ?? '');
/** Waits for the playground beside a lesson. @param {Page} page */
const untilPlayground = (page) => page.waitForFunction(() => /** @type {any} */ (document.querySelector('iframe')?.contentWindow)?.gaitsmith, PATIENCE);

/** @param {Visit} visit */
async function afterTheFirstMotion(visit) {
  await onHost(visit, async (server) => {
    const page = await PageDriver.open(visit.browser, server.address(), { newcomer: true });
    await untilStored(page);
    await sleep(IDLE_MS);
    assert.deepEqual(fetchedBook(server), [], 'nothing is fetched before the first motion');
    await page.click('stage/teach');
    await untilComplete(page);
    assert.ok(fetchedBook(server).length > 100);
    assert.ok(!server.requested.some((path) => /book\/(reference\/|pictures[./])|\/package\/|\.zip$/.test(path)), 'what is too large is left out');
    assert.ok(!server.requested.some((path) => /\/book\/(words\/)?(de|es)[/.]/.test(path)), 'so is the book in other languages');
    assert.deepEqual(page.complaints, []);

    server.away = true;
    const other = await page.page.browserContext().newPage();
    await other.goto(`${server.address()}book/lessons/3-timer-or-senses.html`);
    await untilPlayground(other);
    const pictures = await other.$$eval('.strip img, .strip source', (nodes) => Promise.all(nodes.map((node) => fetch(node.getAttribute('src') ?? node.getAttribute('srcset') ?? '').then(({ ok }) => ok, () => false))));
    assert.ok(pictures.length >= 4 && pictures.every(Boolean), 'with its film strips'); // the host does not know what an .svg file is
    await other.goto(`${server.address()}book/gallery.html`);
    assert.match(await other.title(), /Gallery/);
    await other.goto(`${server.address()}book/index.html?q=stimulus`);
    await other.waitForSelector('#found a', PATIENCE);
    await other.goto(`${server.address()}book/index.html`);
    await other.waitForSelector('#stored:not([hidden])', PATIENCE);

    // A page of our own instead of the browser's error, with links to what is stored.
    for (const [path, says] of /** @type {[string, RegExp][]} */ ([
      ['book/reference/index.html', /API reference/], ['book/pictures.html', /pictures of the playground/], ['book/design.html', /design decisions/], ['book/none/at/all.html', /no page at this address/],
    ])) {
      await other.goto(server.address() + path);
      assert.equal(await other.$eval('h1', (node) => node.textContent), 'This page was not stored');
      const text = await textOf(other);
      assert.ok(text.includes(path), text);
      assert.match(text, says);
      assert.equal(await other.$$eval('[data-of]', (nodes) => nodes.length), 1);
      assert.equal(await other.$$eval('li.stored', (nodes) => nodes.length), 5);
      assert.equal(await other.evaluate(() => getComputedStyle(document.body).display), 'flex', 'with its style');
    }
    await Promise.all([other.waitForNavigation(PATIENCE), other.click('li.stored:nth-of-type(3) a')]);
    assert.match(await other.title(), /Gallery/);
    await other.close();

    const german = await PageDriver.open(visit.browser, `${server.address()}?lang=de`, { beside: page });
    assert.equal(await german.text('#share'), 'Teilen');
    await german.page.goto(`${server.address()}examples`); // a folder is not a page
    assert.match(await textOf(german.page), /This page was not stored/);
    await german.page.close();
    await page.close();
  });
}

/** @param {Visit} visit */
async function halfStored(visit) {
  await onHost(visit, async (server) => {
    // With Save-Data the book is not fetched.
    const page = await PageDriver.open(visit.browser, server.address(), { before: () => {
      Object.defineProperty(navigator, 'connection', { value: { saveData: true } });
    } });
    assert.equal((await searches(page)).state, 'done');
    await untilStored(page);
    await sleep(IDLE_MS);
    assert.deepEqual(fetchedBook(server), []);
    server.away = true;
    const other = await page.page.browserContext().newPage();
    await other.goto(`${server.address()}book/lessons/1-a-rule.html?a=<b>`);
    assert.match(await textOf(other), /book\/lessons\/1-a-rule\.html .*not complete yet/);
    assert.deepEqual(await other.$$eval('li.stored a', (links) => links.map((link) => link.textContent)), ['The playground'], 'only what is stored is linked');
    server.away = false;
    await Promise.all([other.waitForNavigation(PATIENCE), other.click('main a')]);
    assert.match(await other.title(), /stimulus/, 'with a network the same address works again');
    await page.close();
  });
}

/** @param {Visit} visit */
async function fromTheBook(visit) {
  await onHost(visit, async (server) => {
    const context = await visit.browser.createBrowserContext();
    const page = await context.newPage();
    await page.goto(`${server.address()}book/index.html`);
    await page.waitForSelector('#stored:not([hidden])', PATIENCE);
    server.away = true;
    await page.goto(`${server.address()}book/lessons/1-a-rule.html`);
    await untilPlayground(page);
    server.away = false;

    // A new version fetches only what has changed.
    const lesson = join(server.folder, 'book/lessons/1-a-rule.html');
    await writeFile(lesson, (await readFile(lesson, 'utf8')).replace('<h1>', '<h1>New: '));
    await run(process.execPath, [join(ROOT, 'web/build/seal.mjs'), server.folder]);
    server.requested = [];
    await page.goto(`${server.address()}book/teachers.html`);
    await page.evaluate(async () => {
      const registration = await navigator.serviceWorker.ready;
      await registration.update();
      const pause = () => new Promise((resolve) => setTimeout(resolve, 50));
      while (!registration.waiting) await pause();
      const next = registration.waiting;
      const { port1, port2 } = new MessageChannel();
      const answer = new Promise((resolve) => { port1.onmessage = resolve; });
      next.postMessage({ type: 'take-over' }, [port2]);
      await answer;
      while (next.state !== 'activated') await pause();
    });
    await page.goto(`${server.address()}book/index.html`);
    await page.waitForSelector('#stored:not([hidden])', PATIENCE);
    assert.deepEqual(fetchedBook(server).map((path) => path.slice(server.path.length)), ['book/lessons/1-a-rule.html']);
    server.away = true;
    await page.goto(`${server.address()}book/lessons/1-a-rule.html`);
    assert.match(await page.$eval('h1', (node) => node.textContent ?? ''), /^New: /);
    await context.close();
  });
}

/** @param {Visit} visit */
async function takenAlong(visit) {
  await onHost(visit, async ({ folder }) => {
    const work = await mkdtemp(join(tmpdir(), 'taken-'));
    /** @param {string} name @param {string} zone */
    const pack = (name, zone) => run(process.execPath, [join(ROOT, 'web/build/zip.mjs'), folder, join(work, name)], { env: { ...process.env, TZ: zone } });
    const teachers = join(folder, 'book/teachers.html');
    const unlinked = (await readFile(teachers, 'utf8')).replace(/<a href="[^"]*\.zip" download>(.*?)<\/a> \([^)]*\)/, '<strong>$1</strong>');
    await writeFile(teachers, unlinked);
    await pack('gaitsmith-site.zip', 'UTC');
    assert.match(await readFile(teachers, 'utf8'), /<a href="\.\.\/gaitsmith-site\.zip" download>Take the whole site with you<\/a> \(\d\.\d MB\)/);
    await writeFile(teachers, unlinked);
    await utimes(join(folder, 'index.html'), 1, 1);
    await pack('again.zip', 'Asia/Tokyo');
    const bytes = await readFile(join(work, 'gaitsmith-site.zip'));
    assert.ok(bytes.equals(await readFile(join(work, 'again.zip'))), 'the same site gives the same bytes');

    const { unzipSync } = createRequire(join(ROOT, 'web/package.json'))('fflate');
    for (const [name, contents] of Object.entries(unzipSync(bytes))) {
      assert.match(name, /^gaitsmith\/(?!.*\.zip$)/);
      await mkdir(join(work, dirname(name)), { recursive: true });
      await writeFile(join(work, name), contents);
    }
    const server = new PlainServer(join(work, 'gaitsmith'), '/a/b/');
    await server.start();
    try {
      const page = await PageDriver.open(visit.browser, server.address());
      assert.equal((await searches(page)).state, 'done');
      await page.page.goto(`${server.address()}book/lessons/1-a-rule.html`);
      await untilPlayground(page.page);
      assert.ok(server.requested.every((path) => path.startsWith('/a/b/')));
      assert.deepEqual(page.complaints, []);
      await page.close();
    } finally {
      server.close();
      await rm(work, { recursive: true });
    }
  });
}

/** @param {Visit} visit */
async function inAnotherLanguage(visit) {
  await onHost(visit, async (server) => {
    const page = await (await visit.browser.createBrowserContext()).newPage();
    await page.goto(`${server.address()}book/de/index.html`);
    await page.waitForSelector('#stored:not([hidden])', PATIENCE);
    assert.ok(!server.requested.some((path) => /\/book\/(words\/)?es[/.]/.test(path)), 'but no other one');
    server.away = true;
    await page.goto(`${server.address()}book/de/lessons/8-the-judge.html`);
    await untilPlayground(page);
    assert.match(await textOf(page), /Selbst das Urteil fällen.*Abgeben/);
    await page.goto(`${server.address()}book/es/index.html`);
    assert.match(await textOf(page), /book\/es\/index\.html is not stored/);
    await page.browserContext().close();
  });
}

/** @type {typeof import('./all.mjs').SCENARIOS} */
export const STORED_SCENARIOS = [
  ['after the first motion everything is stored, and what is not has a page that says so', afterTheFirstMotion],
  ['with Save-Data the book is not stored, and its pages say so without a network', halfStored],
  ['the book alone stores everything, too, and a new version fetches only what has changed', fromTheBook],
  ['a page of the book in another language stores the book in that language, too', inAnotherLanguage],
  ['the whole site in one file is the same each time, and runs from any folder', takenAlong],
];
