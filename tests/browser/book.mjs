// SPDX-License-Identifier: MIT
// The book in Chromium:  node tests/browser/book.mjs [folder, default build/site]
// Tests lessons with a fake playground that records its calls, the search, axe, and the layout on a phone. Writes
// pictures of some pages to build/screenshots/book, with PICTURES=1 of all.
import assert from 'node:assert/strict';
import { mkdir, readdir, readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { ROOT, serve, startChromium, stopAll } from './browsers.mjs';

/** @typedef {import('./browsers.mjs').Page} Page */

const SITE = process.argv[2] ?? join(ROOT, 'build/site');
const PICTURES = join(ROOT, 'build/screenshots/book');
const PHONE = [390, 844], SIZES = [[1280, 720], [1920, 1080], PHONE];
const PATIENCE = { timeout: 60000 };

/** A fake playground. */
const FAKE = `<!doctype html><html lang="en"><title>Fake</title><p>The playground stands here.</p><script>
window.asked = [];
addEventListener('message', ({ source, origin, data: { gaitsmith, id, call, args } }) => {
  if (source !== parent || gaitsmith !== 1) return;
  asked.push([call, ...args]);
  source.postMessage(call === 'synthesize' ? { gaitsmith, id, error: 'this figure cannot move' } : { gaitsmith, id, result: { version: 1 } }, origin);
});
window.tell = (event, detail) => parent.postMessage({ gaitsmith: 1, event, detail }, '*');
tell('ready');
</script>`;

const address = await serve(SITE);
const browser = await startChromium();
if (!browser) throw new Error('Chromium is not installed: ./dev setup browsers');
const axe = await readFile(join(ROOT, 'web/node_modules/axe-core/axe.min.js'), 'utf8');
const files = (await readdir(join(SITE, 'book'), { recursive: true })).filter((file) => file.endsWith('.html')).sort();
const lessons = files.filter((file) => file.startsWith('lessons'));
/** In all languages. */
const allLessons = files.filter((file) => /(^|\/)lessons\//.test(file));
const headers = files.filter((file) => file.startsWith('reference'));
/** @type {string[]} */
const complaints = [];
let failed = 0;

/** @param {string} name @param {(page: Page) => Promise<void>} body */
async function check(name, body) {
  const context = await /** @type {import('./browsers.mjs').Browser} */ (browser).createBrowserContext();
  const page = await context.newPage();
  page.on('console', (message) => { if (['error', 'warn'].includes(message.type())) complaints.push(`${name}: ${message.text()}`); });
  page.on('pageerror', (error) => complaints.push(`${name}: ${error}`));
  await page.setRequestInterception(true);
  page.on('request', (request) => {
    const url = new URL(request.url());
    if (url.origin !== new URL(address).origin) complaints.push(`${name}: asks ${url.href}`);
    if (url.pathname === '/index.html' && request.frame() !== page.mainFrame()) void request.respond({ contentType: 'text/html', body: FAKE });
    else void request.continue();
  });
  try {
    await body(page);
    console.log(`ok      ${name}`);
  } catch (error) {
    failed++;
    console.log(`FAILED  ${name}\n        ${error instanceof Error ? error.message.replaceAll('\n', '\n        ') : error}`);
  }
  await context.close();
}

/** The calls of the playground, without 'hello'. @param {Page} page @returns {Promise<any[][]>} */
async function asked(page) {
  const all = await page.frames()[1].evaluate(() => /** @type {any} */ (window).asked);
  return all.filter((/** @type {any[]} */ [call]) => call !== 'hello');
}

/** @param {Page} page @param {string} event @param {object} detail */
const tell = (page, event, detail) => page.frames()[1].evaluate((name, what) => /** @type {any} */ (window).tell(name, what), event, detail);

/** @param {Page} page @param {string} selector @param {string} words */
const waitForText = (page, selector, words) => page.waitForFunction((where, what) => document.querySelector(where)?.textContent?.includes(what), PATIENCE, selector, words);

/** Goes to the first lesson with at least `min` different values of the attribute. @param {Page} page @param {string} selector @param {string} attribute @returns {Promise<string>} its address */
async function goToLessonWith(page, selector, attribute, min = 1) {
  for (const name of lessons) {
    await page.goto(`${address}book/${name}`);
    const there = await page.$$eval(selector, (nodes, what) => new Set(nodes.map((node) => node.getAttribute(what))).size, attribute);
    if (there >= min) return page.url();
  }
  assert.fail(`no lesson has ${min} ${selector}`);
}

if (lessons.length > 0) {
  const lesson = `${address}book/${lessons[0]}`;

  await check('book: a link of a lesson opens beside it, and says that it is open', async (page) => {
    const many = await goToLessonWith(page, 'main a[data-open]', 'data-open', 2);
    await page.$$eval('.wait button', (buttons) => buttons.forEach((button) => button.click())); // the link may be under Notice
    const link = /** @type {NonNullable<Awaited<ReturnType<Page['$']>>>} */ (await page.waitForSelector('main a[data-open]:not([aria-current])', PATIENCE));
    const payload = await link.evaluate((node) => node.getAttribute('data-open'));
    await link.evaluate((node) => /** @type {HTMLElement} */ (node).click()); // the page may still scroll to what a button above has shown
    await page.waitForFunction((open) => [...document.querySelectorAll('[aria-current=true][data-open]')].some((node) => node.getAttribute('data-open') === open), PATIENCE, payload);
    assert.ok((await asked(page)).some(([call, what]) => call === 'open' && what === payload));
    assert.equal(page.url(), many);
    assert.equal(await page.$$eval('a[aria-current=true][data-open]', (nodes) => new Set(nodes.map((node) => node.getAttribute('data-open'))).size), 1);
  });

  await check('book: a goal is set, reached, and kept', async (page) => {
    await page.goto(lesson);
    const goal = await page.$eval('.goal', (node) => node.getAttribute('data-goal') ?? '');
    await page.click('.goal button');
    await waitForText(page, '.goal .state', 'watches');
    assert.ok((await asked(page)).some(([call, what]) => call === 'arrange' && what.goal === goal));
    await tell(page, 'goal', { goal: 'rotations >= 99', met: true });
    await tell(page, 'goal', { goal, met: false, measures: {} });
    assert.equal(await page.$('.goal.met'), null);
    await tell(page, 'goal', { goal, met: true, measures: {} });
    await waitForText(page, '.goal.met .state', 'Reached');
    await page.click('#done');
    await page.reload();
    await page.waitForSelector('.goal.met', PATIENCE);
    assert.ok(await page.$eval('#done', (node) => /** @type {HTMLInputElement} */ (node).checked));
    await page.goto(`${address}book/index.html`);
    await page.waitForSelector('.shelf .done', PATIENCE);
    const first = '.lessons li:first-child';
    assert.match(await page.$eval(`${first} .reached`, (node) => node.textContent ?? ''), /reached/);
    assert.equal(await page.$$eval(`${first} .tick.met`, (nodes) => nodes.length), 1);
    assert.equal(await page.$$eval('.lessons .strip .by-day img', (nodes) => nodes.length), lessons.length, 'each lesson has its strip');
    await page.click('#forget');
    assert.equal(await page.$('.lessons .met'), null);
    assert.equal(await page.$('.shelf .done'), null);
    assert.equal(await page.evaluate(() => localStorage.getItem('gaitsmith-lessons')), null);
  });

  await check('book: an answer is explained at once, by keys too', async (page) => {
    await page.goto(lesson);
    await page.waitForFunction(() => /** @type {HTMLElement | null} */ (document.querySelector('.quiz details'))?.hidden, PATIENCE);
    await page.focus('.quiz input');
    await page.keyboard.press('Space');
    const first = await page.$eval('.quiz .feedback', (node) => node.textContent);
    await page.keyboard.press('ArrowDown');
    assert.match(String(first), /^(Right|No)\. ./);
    assert.notEqual(await page.$eval('.quiz .feedback', (node) => node.textContent), first);
  });

  await check('book: a button asks, and says what the playground said', async (page) => {
    await goToLessonWith(page, 'button[data-call=synthesize]', 'data-call');
    const button = /** @type {NonNullable<Awaited<ReturnType<Page['$']>>>} */ (await page.waitForSelector('button[data-call=synthesize]:not([disabled])', PATIENCE));
    await button.evaluate((node) => /** @type {HTMLElement} */ (node).classList.add('pressed'));
    await button.click();
    await waitForText(page, '.do:has(.pressed) .state', 'this figure cannot move');
  });

  await check('book: without scripts a lesson can be read, and its links lead to the playground', async (page) => {
    await page.setJavaScriptEnabled(false);
    await page.goto(lesson);
    assert.match(await page.$eval('main a[data-open]', (node) => /** @type {HTMLAnchorElement} */ (node).href), /\/index\.html(\?[^#]*)?#\w/);
  });
}

await check('book: a lesson speaks its language, in what its scripts say too, and leads to the other ones', async (page) => {
  for (const name of allLessons.filter((file) => !lessons.includes(file) && file.includes('1-'))) {
    await page.goto(`${address}book/${name}`);
    const code = name.split('/')[0];
    assert.match(await page.$eval('#playground', (node) => /** @type {HTMLIFrameElement} */ (node).src), new RegExp(`[?&]lang=${code}&`));
    await page.click('.goal button');
    await page.waitForFunction(() => document.querySelector('.goal .state')?.textContent, PATIENCE);
    await page.click('#hand-in-make');
    await page.waitForFunction(() => document.querySelector('#hand-in .state')?.textContent, PATIENCE);
    const said = await page.$$eval('.goal .state, #hand-in .state, .wait', (nodes) => nodes.map((node) => node.textContent ?? ''));
    assert.equal(said.length, 3);
    for (const words of said) assert.doesNotMatch(words, /watches|missing|First|^$/);
    assert.match(await page.$eval('#hand-in-link', (node) => /** @type {HTMLTextAreaElement} */ (node).value), new RegExp(`/book/${code}/wall\\.html#H1`));
    await Promise.all([page.waitForNavigation(PATIENCE), page.click('.languages a[lang=en]')]);
    assert.equal(page.url(), `${address}book/${name.slice(3)}`);
    await waitForText(page, '.languages', 'Deutsch');
    await page.goto(`${address}book/${code}/index.html`);
    await page.waitForFunction(() => !/goal/i.test(document.querySelector('.lessons .reached')?.textContent ?? 'goal'), PATIENCE);
  }
});

await check('book: the search is found in by keys', async (page) => {
  await page.goto(`${address}book/physics.html`);
  await page.type('.finder input', 'timer senses');
  await page.keyboard.press('Enter');
  await page.waitForSelector('#found a', PATIENCE);
  await page.focus('#find-words');
  await page.keyboard.press('ArrowDown');
  assert.ok(await page.evaluate(() => document.activeElement?.closest('#found')));
  await Promise.all([page.waitForNavigation(PATIENCE), page.keyboard.press('Enter')]);
  assert.doesNotMatch(page.url(), /index\.html/);
});

await check('book: the theme is the one that was chosen in the playground', async (page) => {
  await page.goto(`${address}book/physics.html`);
  await page.evaluate(() => localStorage.setItem('gaitsmith-theme', 'dark'));
  await page.reload();
  assert.equal(await page.evaluate(() => getComputedStyle(document.body).backgroundColor), 'rgb(20, 24, 29)');
});

await mkdir(PICTURES, { recursive: true });
await check('book: a printed lesson is a worksheet of at most two pages, without answers', async (page) => {
  for (const name of allLessons) {
    await page.goto(`${address}book/${name}`);
    // Translations are as long as the lesson, within a few lines.
    for (const format of /** @type {('A4' | 'Letter')[]} */ (lessons.includes(name) ? ['A4', 'Letter'] : ['A4'])) {
      const pages = Buffer.from(await page.pdf({ format })).toString('latin1').match(/\/Type\s*\/Page\b/g)?.length ?? 0;
      assert.ok(pages >= 1 && pages <= 2, `${name} has ${pages} pages of ${format}`);
    }
  }
  await page.goto(`${address}book/${lessons[0]}`);
  await page.click('.quiz input'); // its explanation is not printed either
  await page.emulateMediaType('print');
  const { text, hidden, lines, box } = await page.evaluate(() => ({
    text: document.body.innerText,
    hidden: [...document.querySelectorAll('iframe, .quiz details, .feedback, .goal button, .goal .state, p.done, .around, header nav')].filter((node) => node.checkVisibility()).length,
    lines: [null, '::after'].map((part) => getComputedStyle(/** @type {Element} */ (document.querySelector('#explain + p')), part).borderBottomStyle),
    box: getComputedStyle(/** @type {Element} */ (document.querySelector('.goal')), '::before').borderTopStyle,
  }));
  assert.match(text, /^Name\s+Date/);
  assert.doesNotMatch(text, /Right[.:]|The playground stands here/);
  assert.deepEqual([hidden, lines, box], [0, ['solid', 'solid'], 'solid']);
  const split = await page.$$eval('.quiz, .goal', (nodes) => nodes.filter((node) => getComputedStyle(node).breakInside !== 'avoid').length);
  assert.equal(split, 0, 'no question is on two pages');
  await page.setViewport({ width: 794, height: 1123 });
  await page.screenshot({ path: join(PICTURES, 'printed.png'), fullPage: true });
  await page.emulateMediaType();
  assert.equal(await page.$eval('.worksheet', (node) => node.checkVisibility()), false);
});

for (const theme of ['light', 'dark', 'projector', 'contrast']) {
  await check(`book: axe finds nothing, and no page is wider than its screen (${theme})`, async (page) => {
    /** @type {string[]} */
    const found = [];
    await page.goto(`${address}book/index.html`);
    await page.evaluate((name) => localStorage.setItem('gaitsmith-theme', name), theme);
    // Only colours differ between themes, so one page of each kind is enough for the others, and all pages in one language
    // for the dark one. The headers' pages look alike: axe looks at the first one, the width of the others is measured.
    const ofEach = [lessons[0], headers[0], 'index.html', 'gallery.html', 'formats.html'];
    const looked = { light: files, dark: files.filter((name) => !/^(de|es|reference)\//.test(name) || ofEach.includes(name)) };
    for (const file of looked[/** @type {'light' | 'dark'} */ (theme)] ?? files.filter((name) => ofEach.includes(name))) {
      const alike = headers.includes(file) && !ofEach.includes(file), every = theme === 'light' && !alike;
      await page.goto(`${address}book/${file}`);
      if (!alike) await page.evaluate(axe);
      for (const [width, height] of alike ? [PHONE] : SIZES) {
        await page.setViewport({ width, height });
        const wide = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
        if (wide > 0) found.push(`${file} is ${wide} px too wide for ${width}`);
        if (!alike && (width === PHONE[0] || (width === 1280 && ofEach.includes(file)))) {
          const rules = every ? {} : { runOnly: ['color-contrast'] };
          found.push(...await page.evaluate((where, only) => /** @type {any} */ (window).axe.run({ resultTypes: ['violations'], iframes: false, ...only })
            .then((/** @type {any} */ { violations }) => violations.map((/** @type {any} */ { id, nodes }) => `${where}: ${id}: ${nodes.slice(0, 3).map((/** @type {any} */ { html }) => html.slice(0, 140)).join(' | ')}`)), `${file} ${width}`, rules));
        }
        if (process.env.PICTURES || ofEach.includes(file)) await page.screenshot({ path: join(PICTURES, `${file.replace(/\W/g, '-')}-${width}-${theme}.png`) });
      }
    }
    assert.deepEqual(found, []);
  });
}

await check('book: nothing is asked of other hosts, and no page complains', async () => assert.deepEqual(complaints, []));
await browser.close();
stopAll();
process.exitCode = failed > 0 ? 1 : 0;
