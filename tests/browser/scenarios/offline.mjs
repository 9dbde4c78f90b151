// SPDX-License-Identifier: MIT
// The built site on a simple static host: in a subfolder, without a network, with a new version, in frames with few
// permissions, without storage.
import assert from 'node:assert/strict';
import { cp, mkdtemp, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { execFile } from 'node:child_process';
import { promisify } from 'node:util';
import { ROOT } from '../browsers.mjs';
import { ONCE, PageDriver, RARELY } from '../page_driver.mjs';
import { PlainServer } from '../plain_server.mjs';

/** @typedef {import('./all.mjs').Visit} Visit */

const run = promisify(execFile);

/** Runs a test on a host with a copy of the site. @param {Visit} visit @param {(server: PlainServer) => Promise<void>} body */
export async function onHost(visit, body) {
  const folder = await mkdtemp(join(tmpdir(), 'site-'));
  await cp(visit.site, folder, { recursive: true });
  const server = new PlainServer(folder, '/some/where/');
  await server.start();
  try {
    await body(server);
  } finally {
    server.close();
    await rm(folder, { recursive: true });
  }
}

/** Waits until the page's own service worker, not one of a parent folder, has stored the whole page. @param {PageDriver} page */
export const untilStored = (page) => page.until('the service worker', `(async () => {
  const registration = await navigator.serviceWorker.getRegistration();
  return registration?.scope === new URL('.', location.href).href && registration.active?.state === 'activated';
})()`);

/** Runs a search, which must find a motion. @param {PageDriver} page */
export const searches = (page) => page.call('search', async () => {
  const { hash, report } = await window.gaitsmith.synthesize({ seed: 3, evaluations: 2000, algorithm: 'sphc' });
  return { hash, state: report.state };
});

/** @param {Visit} visit */
async function subPathAndOffline(visit) {
  const { browser } = visit;
  await onHost(visit, async (server) => {
    const page = await PageDriver.open(browser, server.address());
    const { hash, state } = await searches(page);
    assert.equal(state, 'done');
    await untilStored(page);
    assert.ok(server.requested.every((path) => path.startsWith(server.path)), `asked outside: ${server.requested.find((path) => !path.startsWith(server.path))}`);
    assert.deepEqual(page.complaints, []);
    const link = await page.link();

    server.away = true;
    server.requested = [];
    await page.reload();
    assert.equal((await searches(page)).hash, hash, 'the same search finds the same without a network');
    const lesson = await page.page.browserContext().newPage();
    server.away = false;
    await lesson.goto(`${server.address()}book/lessons/1-a-rule.html`);
    server.away = true;
    await lesson.reload();
    await lesson.waitForFunction(() => /** @type {any} */ (document.querySelector('iframe')?.contentWindow)?.gaitsmith, { timeout: 30000 });
    await lesson.close();
    // Parts that are loaded on first use are stored, too.
    await page.page.evaluate(() => void window.gaitsmith.run('document/export'));
    await page.until('the export dialog', () => document.querySelector('#export-dialog')?.hasAttribute('open') ?? false);
    const other = await PageDriver.open(browser, link, { beside: page });
    assert.equal(await other.hash(), hash, 'a link opens without a network');
    await page.close();
  });
}

/** @param {Visit} visit */
async function prettyHost(visit) {
  const { browser } = visit;
  await onHost(visit, async (server) => {
    server.pretty = true;
    const page = await PageDriver.open(browser, server.address());
    const hash = await page.hash();
    await untilStored(page);
    await page.reload(); // now through the service worker
    assert.equal(await page.hash(), hash);
    await page.page.goto(`${server.address()}book/gallery.html`);
    await page.page.reload();
    assert.match(await page.page.title(), /Gallery/);
    await page.close();
  });
}

/** @param {Visit} visit */
async function twoCopies(visit) {
  const { browser } = visit;
  await onHost(visit, async (server) => {
    await cp(visit.site, join(server.folder, 'older'), { recursive: true });
    const page = await PageDriver.open(browser, server.address());
    await untilStored(page);
    const other = await PageDriver.open(browser, `${server.address()}older/`, { beside: page });
    await untilStored(other);
    server.away = true;
    for (const driver of [page, other]) {
      await driver.page.bringToFront();
      await driver.reload();
    }
    await page.close();
  });
}

/** @param {Visit} visit */
async function update(visit) {
  const { browser } = visit;
  await onHost(visit, async (server) => {
    const page = await PageDriver.open(browser, server.address());
    await untilStored(page);
    await page.reload(); // now through the service worker
    const hash = await page.hash();

    // A new version: one script and one page differ.
    const script = join(server.folder, 'page/page.js');
    await writeFile(script, `${await readFile(script, 'utf8')}\nwindow.testNew = 'script';\n`);
    const index = join(server.folder, 'index.html');
    await writeFile(index, (await readFile(index, 'utf8')).replace('<html lang="en">', '<html lang="en" data-new>'));
    await run(process.execPath, [join(ROOT, 'web/build/seal.mjs'), server.folder]);

    const second = await PageDriver.open(browser, server.address(), { beside: page });
    const versionOf = (/** @type {PageDriver} */ driver) => driver.call('version', () =>
      `${'new' in document.documentElement.dataset} ${/** @type {any} */ (window).testNew ?? 'old'}`);
    assert.equal(await versionOf(second), 'false old', 'a page that opens beside an old one is an old one');
    await page.page.bringToFront();
    await page.call('update', async () => { await (await navigator.serviceWorker.ready).update(); return true; });
    await page.until('the offer', () => document.querySelector('#update')?.hasAttribute('hidden') === false);

    await page.clickElement('#update-go');
    await page.until('the refusal', () => /other tabs/.test(document.querySelector('#update-text')?.textContent ?? ''));
    assert.equal(await versionOf(page), 'false old', 'while two pages are open none changes');
    await second.page.close();
    await page.arrive(() => page.clickElement('#update-go'));
    assert.equal(await versionOf(page), 'true script', 'the new version is there as a whole');
    assert.equal(await page.hash(), hash, 'and the work');
    await page.close();
  });
}

/** @param {Visit} visit */
async function halfAVersion(visit) {
  const { browser } = visit;
  await onHost(visit, async (server) => {
    const page = await PageDriver.open(browser, server.address());
    await untilStored(page);
    await page.reload();
    const before = server.requested.filter((path) => path.endsWith('/naming.js')).length;
    // An incomplete upload: the service worker is new, but a file does not match its hash.
    await writeFile(join(server.folder, 'page/page.js'), 'window.testNew = "whole";\n');
    await run(process.execPath, [join(ROOT, 'web/build/seal.mjs'), server.folder]);
    await writeFile(join(server.folder, 'page/page.js'), 'window.testNew = "half";\n');
    const state = await page.call('update', async () => {
      const registration = await navigator.serviceWorker.ready;
      await registration.update().catch(() => {});
      const coming = registration.installing;
      if (coming) await new Promise((resolve) => coming.addEventListener('statechange', resolve, { once: true }));
      return `${registration.waiting?.state ?? 'none waits'}, ${coming?.state ?? 'none came'}`;
    });
    assert.match(state, /none waits, (redundant|none came)/);
    assert.ok(server.requested.filter((path) => path.endsWith('/naming.js')).length > before, 'the new version was looked at');
    page.complaints.length = 0; // the browser reports the mismatch
    await page.reload();
    assert.equal(await page.call('old', () => /** @type {any} */ (window).testNew), undefined);
    assert.deepEqual(page.complaints, []);
    await page.close();
  });
}

/** A page of another origin that embeds the site and sends messages to it. */
const ASKS = `<!doctype html><title>Around</title><body><script>
  const waiting = new Map(); let last = 0; window.events = []; window.answered = [];
  addEventListener('message', ({ data, origin }) => {
    if (data?.gaitsmith !== 1) return;
    if (data.event) events.push(data.event); else { answered.push(data.id); waiting.get(data.id)?.(data); }
  });
  window.ask = (call, ...args) => new Promise((resolve) => {
    waiting.set(++last, resolve);
    document.querySelector('iframe').contentWindow.postMessage({ gaitsmith: 1, id: last, call, args }, '*');
  });
  window.put = (source, sandbox) => {
    const frame = document.createElement('iframe');
    if (sandbox) frame.sandbox = sandbox;
    frame.width = 800; frame.height = 500; frame.src = source;
    document.body.append(frame);
  };
</script>`;

/** @param {Visit['browser']} browser @param {PlainServer} server @param {string} sandbox @param {string} [query] */
async function around(browser, server, sandbox, query = '') {
  server.pages['/around.html'] = ASKS;
  const context = await browser.createBrowserContext();
  const page = await context.newPage();
  await page.setViewport({ width: 1000, height: 700 });
  await page.goto(new URL('/around.html', server.address('127.0.0.1')).href); // another origin than the frame's
  await page.evaluate((source, box) => /** @type {any} */ (window).put(source, box), server.address() + query, sandbox);
  /** @param {string} call @param {any[]} args @returns {Promise<any>} */
  const ask = (call, ...args) => page.evaluate((name, values) => /** @type {any} */ (window).ask(name, ...values), call, args);
  const until = async (/** @type {string} */ what, /** @type {string} */ condition) => {
    for (let i = 0; i < 600; i++, await new Promise((resolve) => setTimeout(resolve, 100))) if (await page.evaluate(condition)) return;
    assert.fail(`waited in vain for ${what}`);
  };
  return { page, ask, until, close: () => context.close() };
}

/** @param {Visit} visit */
async function foreignFrame(visit) {
  const { browser } = visit;
  await onHost(visit, async (server) => {
    const { page, ask, until, close } = await around(browser, server, 'allow-scripts allow-same-origin', '?panels=style&lock=figure&goal=distance>=1');
    await until('the frame', `events.includes('ready')`);
    const hello = (await ask('hello')).result;
    assert.equal(hello.version, 1);
    const { result } = await ask('synthesize', { seed: 3, evaluations: 2000, algorithm: 'sphc' });
    assert.equal(result.report.state, 'done');
    assert.notEqual(result.hash, hello.hash);
    await until('its events', `events.includes('progress') && events.includes('done') && events.includes('changed') && events.includes('goal')`);
    assert.match((await ask('open', 'no link')).error, /./, 'a bad link is an error');
    assert.equal((await ask('hash')).result, result.hash, 'and changes nothing');
    assert.match((await ask('constructor')).error, /there is no call constructor/);
    assert.match((await ask('arrange', { panels: 'kitchen' })).error, /kitchen/);
    assert.match((await ask('arrange', { goal: 'distance >= far' })).error, /distance >= far/);
    assert.ok(Object.keys((await ask('measures')).result).includes('rotations'));
    // Copy link copies the link, or shows it to be copied by hand.
    const inside = page.frames().find((frame) => frame.url().startsWith(server.address()));
    assert.ok(inside);
    await (await inside.$('#copy-link'))?.click();
    await inside.waitForFunction(() => document.querySelector('#toast')?.classList.contains('shown') || document.querySelector('#link-dialog')?.hasAttribute('open'), { timeout: 10000 });
    // Messages from other pages than the embedding one are ignored.
    const received = await page.evaluate(async () => {
      const stranger = document.createElement('iframe');
      document.body.append(stranger);
      const target = document.querySelector('iframe')?.contentWindow;
      /** @type {any} */ (stranger.contentWindow).eval(`parent.frames[0].postMessage({ gaitsmith: 1, id: 99999, call: 'undo', args: [] }, '*')`);
      await new Promise((resolve) => setTimeout(resolve, 500));
      return [Boolean(target), /** @type {any} */ (window).answered.includes(99999)];
    });
    assert.deepEqual(received, [true, false]);
    await ask('hello'); // after the stranger's message
    assert.equal(await page.evaluate(() => /** @type {any} */ (window).answered.includes(99999)), false);
    assert.equal((await ask('hash')).result, result.hash);
    await close();
  });
}

/** @param {Visit} visit */
async function narrowFrame(visit) {
  const { browser } = visit;
  await onHost(visit, async (server) => {
    const refused = await around(browser, server, 'allow-scripts');
    const inFrame = async () => {
      const frame = refused.page.frames().find((each) => each.url().startsWith(server.address()));
      return frame ? frame.evaluate(() => document.querySelector('#loading p')?.textContent ?? '').catch(() => '') : '';
    };
    for (let i = 0; i < 100 && !/allow-same-origin/.test(await inFrame()); i++) await new Promise((resolve) => setTimeout(resolve, 100));
    assert.match(await inFrame(), /allow-same-origin/, 'where a host lets no frame without an origin load scripts, the page says so');
    await refused.close();

    server.headers['access-control-allow-origin'] = '*'; // most hosts send it
    const { page, ask, until, close } = await around(browser, server, 'allow-scripts');
    await until('the frame', `events.includes('ready')`);
    await ask('hello');
    const { result, error } = await ask('synthesize', { seed: 3, evaluations: 400, algorithm: 'sphc' });
    assert.equal(error, undefined);
    assert.equal(result.report.state, 'done', 'without workers it searches in the page');
    for (let round = 0; round < 5; round++) { // interference would depend on timing
      await page.evaluate('events = []');
      void ask('synthesize', { seed: 4, evaluations: 1e6, algorithm: 'sphc' }).catch(() => {});
      await until('its progress', `events.includes('progress')`);
      const again = await ask('synthesize', { seed: 3, evaluations: 400, algorithm: 'sphc' });
      assert.equal(again.error, undefined, 'a search that takes the place of another');
      assert.equal(again.result.hash, result.hash);
    }
    const other = await PageDriver.open(browser, server.address());
    const same = await other.call('search', () => window.gaitsmith.synthesize({ seed: 3, evaluations: 400, algorithm: 'sphc' }).then(({ hash }) => hash));
    assert.equal(result.hash, same, 'and finds what workers find');
    await other.close();
    await close();
  });
}

/** @param {Visit} visit */
async function noStorage({ browser, address }) {
  const page = await PageDriver.open(browser, address, { before: () => {
    for (const name of ['localStorage', 'sessionStorage', 'indexedDB', 'caches']) {
      Object.defineProperty(window, name, { get() { throw new DOMException('forbidden', 'SecurityError'); } });
    }
    Object.defineProperty(navigator.serviceWorker, 'register', { value: () => Promise.reject(new DOMException('forbidden', 'SecurityError')) });
  } });
  const { state } = await searches(page);
  assert.equal(state, 'done');
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function secondProfile({ browser, address }) {
  const first = await PageDriver.open(browser, address);
  const { hash } = await searches(first);
  const link = await first.link();
  const cookies = await first.page.browserContext().cookies();
  assert.deepEqual(cookies, [], 'no cookies');
  await first.close();
  const second = await PageDriver.open(browser, link);
  assert.equal(await second.hash(), hash);
  assert.equal((await searches(second)).hash, hash, 'and searching there finds the same');
  assert.deepEqual(second.complaints, []);
  await second.close();
}

/** @param {Visit} visit */
async function packagedEngine(visit) {
  const { browser } = visit;
  const folder = await mkdtemp(join(tmpdir(), 'package-'));
  const archive = (await readdir(join(visit.site, 'package'))).find((name) => /^gaitsmith-engine-.*\.tgz$/.test(name));
  await run('tar', ['-xzf', join(visit.site, 'package', archive ?? ''), '-C', folder]);
  const server = new PlainServer(join(folder, 'package'), '/');
  await server.start();
  const context = await browser.createBrowserContext();
  try {
    const page = await context.newPage();
    await page.goto(`${server.address()}example.html`);
    await page.waitForFunction(() => /moved/.test(document.body.textContent ?? ''), { timeout: 30000 });
    const text = await page.evaluate(() => document.body.textContent?.trim());
    const { stdout } = await run(process.execPath, [join(folder, 'package/example.js')]);
    assert.equal(text, stdout.trim(), 'a page finds what Node finds');
  } finally {
    await context.close();
    server.close();
    await rm(folder, { recursive: true });
  }
}

/** @type {typeof import('./all.mjs').SCENARIOS} */
export const OFFLINE_SCENARIOS = [
  ['on a plain host under a path it works, and goes on without a network', subPathAndOffline],
  ['a host that sends pages on to prettier addresses is as good', prettyHost, ONCE, RARELY],
  ['two copies on one host keep out of each other’s way', twoCopies, ONCE, RARELY],
  ['a new version comes as a whole, when one page is left and its reader asks for it', update, ONCE, RARELY],
  ['an incomplete update is not activated', halfAVersion, ONCE, RARELY],
  ['in a frame of another origin it is played by messages', foreignFrame],
  ['in a frame without an origin it searches in the page, or says what is missing', narrowFrame, ONCE, RARELY],
  ['without storage everything else works', noStorage, ONCE, RARELY],
  ['the package of the engine runs in a page as it does in Node', packagedEngine, ONCE, RARELY],
  ['a link opens in another profile, where the same search finds the same', secondProfile],
];
