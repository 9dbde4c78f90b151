// SPDX-License-Identifier: MIT
// Sharing: the dialog's link, its QR code and its HTML for embedding, links that cannot be opened, and a lesson's
// options in the address.
import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import { readdir, readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { ROOT } from '../browsers.mjs';
import { ONE_BROWSER, PageDriver } from '../page_driver.mjs';

/** @typedef {import('./all.mjs').Visit} Visit */
/** @type {(data: Uint8ClampedArray, width: number, height: number) => {data: string} | null} */
const jsQR = createRequire(join(ROOT, 'web/package.json'))('jsqr');

/** @param {PageDriver} page @param {string} selector @returns {Promise<string>} */
const valueOf = (page, selector) => page.page.evaluate((where) => /** @type {HTMLTextAreaElement} */ (document.querySelector(where)).value, selector);

/** Reads the QR code like a camera. @param {PageDriver} page */
async function read(page) {
  const { pixels, size } = await page.call('code', async () => {
    const svg = /** @type {SVGElement} */ (document.querySelector('#share-code svg')).cloneNode(true);
    const modules = Number(/** @type {SVGElement} */ (svg).getAttribute('viewBox')?.split(' ')[2]);
    const side = 4 * modules;
    /** @type {SVGElement} */ (svg).setAttribute('width', String(side));
    /** @type {SVGElement} */ (svg).setAttribute('height', String(side));
    const image = new Image();
    image.src = `data:image/svg+xml,${encodeURIComponent(new XMLSerializer().serializeToString(svg))}`;
    await image.decode();
    const context = /** @type {CanvasRenderingContext2D} */ (Object.assign(document.createElement('canvas'), { width: side, height: side }).getContext('2d'));
    context.fillStyle = '#fff';
    context.fillRect(0, 0, side, side);
    context.drawImage(image, 0, 0);
    const { data } = context.getImageData(0, 0, side, side);
    return { size: side, pixels: Array.from({ length: side * side }, (_, i) => data[4 * i]) };
  });
  return jsQR(Uint8ClampedArray.from(pixels.flatMap((grey) => [grey, grey, grey, 255])), size, size)?.data;
}

/** @param {Visit} visit */
async function shareDialog({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  await page.clickElement('#share');
  await page.until('the code', () => document.querySelector('#share-code svg') !== null);
  const link = await page.link();
  assert.equal(await valueOf(page, '#share-link'), link);
  assert.equal(await read(page), link, 'a camera reads the link');

  await page.clickElement('#share-embed summary');
  await page.clickElement('#share-panels [value=lab]');
  await page.clickElement('#share-locks input[value=figure]');
  const lines = await valueOf(page, '#share-snippet');
  await page.press('Escape');
  const embeddingPage = await page.page.browserContext().newPage();
  await embeddingPage.goto(new URL('page/no_start.js', address).href); // a page of the same host, and nothing on it
  await embeddingPage.setContent(lines);
  await embeddingPage.waitForFunction(() => /** @type {any} */ (document.querySelector('iframe')?.contentWindow)?.gaitsmith, { timeout: 30000 });
  const inside = await embeddingPage.evaluate(async () => {
    const { gaitsmith } = /** @type {HTMLIFrameElement & {contentWindow: Window}} */ (document.querySelector('iframe')).contentWindow;
    await gaitsmith.ready;
    const before = gaitsmith.hash();
    gaitsmith.run('panel/Figure');
    const figures = gaitsmith.commands().filter(({ id }) => id.startsWith('figure/') && !id.includes('mr-star-man'));
    for (const { id } of figures.slice(0, 3)) gaitsmith.run(id);
    return { tried: figures.slice(0, 3).length, before, after: gaitsmith.hash(), lab: gaitsmith.commands().some(({ id }) => id === 'panel/Lab'), style: gaitsmith.commands().some(({ id }) => id === 'panel/Style'), title: document.querySelector('iframe')?.title };
  });
  const hash = await page.hash();
  assert.equal(inside.tried, 3);
  assert.deepEqual([inside.before, inside.after, inside.lab, inside.style], [hash, hash, false, true]);
  assert.equal(inside.title, await page.text('#title'));

  // A link that is too long has no code, and the dialog says why.
  const long = await readFile(join(ROOT, 'examples/figure-12.json'), 'utf8');
  await page.page.evaluate((text) => window.gaitsmith.open(text), long);
  await page.page.evaluate(() => window.gaitsmith.run('document/share'));
  await page.until('the dialog', () => document.querySelector('#share-dialog')?.hasAttribute('open') ?? false);
  assert.equal(await page.call('hidden', () => document.querySelector('#share-code')?.hasAttribute('hidden')), true);
  assert.match(await page.text('#share-words'), /too long for a QR code/);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** A phone sends the link to another app. @param {Visit} visit */
async function send({ browser, address }) {
  const page = await PageDriver.open(browser, address, { before: () => {
    const sent = /** @type {object[]} */ ([]);
    Object.assign(window, { testSent: sent, testFault: '' });
    Object.defineProperty(navigator, 'share', { configurable: true, value: async (/** @type {object} */ data) => {
      sent.push(data);
      const fault = /** @type {any} */ (window).testFault;
      if (fault) throw new DOMException('no', fault);
    } });
  } });
  await page.clickElement('#share');
  await page.until('the dialog', () => document.querySelector('#share-dialog')?.hasAttribute('open') ?? false);
  /** @param {string} fault @param {number} times */
  const press = async (fault, times) => {
    await page.page.evaluate((name) => Object.assign(window, { testFault: name }), fault);
    await page.clickElement('#share-send');
    await page.until('the call', `window.testSent.length === ${times}`);
    await page.frames();
    return page.text('#share-said');
  };
  assert.equal(await press('', 1), '');
  assert.deepEqual(await page.call('sent', () => /** @type {any} */ (window).testSent[0]), { title: await page.text('#title'), url: await page.link() });
  assert.equal(await press('AbortError', 2), '', 'a changed mind is no error');
  assert.match(await press('NotAllowedError', 3), /Copy it instead/);
  assert.deepEqual(page.complaints, []);
  await page.close();

  const without = await PageDriver.open(browser, address, { before: () => { delete (/** @type {any} */ (Navigator.prototype).share); } });
  await without.clickElement('#share');
  await without.until('the dialog', () => document.querySelector('#share-dialog')?.hasAttribute('open') ?? false);
  assert.equal(await without.call('hidden', () => document.querySelector('#share-send')?.hasAttribute('hidden')), true);
  await without.close();
}

/** @param {Visit} visit */
async function firstMotion({ browser, address }) {
  const page = await PageDriver.open(browser, address, { newcomer: true });
  await page.click('stage/teach');
  await page.until('the motion', () => window.gaitsmith.results().length === 1);
  await page.clickElement('#share');
  await page.until('the code', () => document.querySelector('#share-code svg') !== null);
  assert.equal(await read(page), await page.link());
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function linksThatCannotBeOpened({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  const hash = await page.hash();
  const payload = (await page.link()).split('#')[1];
  const cases = /** @type {[RegExp, string][]} */ ([
    [/cut or damaged|was damaged/, `${payload.slice(0, 40)}${payload[40] === 'A' ? 'B' : 'A'}${payload.slice(41)}`],
    [/was cut/, payload.slice(0, 120)],
    [/made by a newer one/, `Pw${payload.slice(2)}`],
    [/link/, 'A'.repeat(200000)],
    [/link/, 'not a link at all'],
  ]);
  for (const [says, bad] of cases) {
    await page.page.evaluate((text) => { location.hash = text; }, bad);
    await page.until('the banner', () => document.querySelector('#banner')?.hasAttribute('hidden') === false);
    const text = await page.text('#banner-text');
    assert.match(text, says);
    assert.match(text, /Copy the whole link again\. /, 'what to do');
    assert.equal(await page.hash(), hash, 'the work is as it was');
    await page.clickElement('#banner-close');
  }
  await page.close();
}

/** @param {Visit} visit */
async function lessonInTheAddress({ browser, address }) {
  const page = await PageDriver.open(browser, `${address}?panels=style,search&lock=style,world&goal=distance>=1,rotations>=500`);
  const ids = await page.call('commands', () => window.gaitsmith.commands().map(({ id }) => id));
  assert.deepEqual(ids.filter((id) => id.startsWith('panel/')), ['panel/Style', 'panel/Search']);
  await page.until('the goal', () => document.querySelector('#goal li.met') !== null);
  assert.equal(await page.text('#goal li.met'), ' Distance ≥ 1 m (now 18.33 m)');
  await page.call('events', () => {
    const seen = /** @type {object[]} */ ([]);
    Object.assign(window, { testGoals: seen });
    window.gaitsmith.on('goal', ({ detail }) => seen.push(detail));
    return true;
  });
  await page.call('goal', () => window.gaitsmith.arrange({ goal: 'distance >= 1, sense = physical' }).then(() => true));
  await page.until('the goal reached', () => document.querySelector('#goal')?.classList.contains('met') === true);
  await page.until('its event', () => /** @type {any} */ (window).testGoals.at(-1)?.met === true);

  // Also while the motion is paused.
  await page.page.evaluate(() => { if (document.body) window.gaitsmith.run('motion/end'); });
  await page.frames();
  await page.call('all panels', () => window.gaitsmith.arrange({ panels: 'all' }).then(() => true));
  await page.until('the other panels', () => window.gaitsmith.widgets().some(({ label }) => label === 'Lab'));
  await page.call('fewer', () => window.gaitsmith.arrange({ panels: 'style,search' }).then(() => true));

  // A locked slider is disabled, and a key changes nothing either.
  await page.page.evaluate(() => window.gaitsmith.run('panel/Style'));
  await page.until('the locked slider', () => window.gaitsmith.widgets().some(({ id, state }) => id === 'style/slip' && state.disabled === true));
  const start = (await page.widgets()).find(({ id }) => id === 'stage');
  assert.ok(start && !start.state.disabled);
  const hash = await page.hash();
  await page.call('still plays', () => window.gaitsmith.synthesize({ evaluations: 400, seed: 2 }).then(() => true));
  assert.notEqual(await page.hash(), hash, 'and searching goes on');
  assert.deepEqual(page.complaints, []);
  await page.close();

  const wrong = await PageDriver.open(browser, `${address}?panels=kitchen`);
  await wrong.until('the banner', () => /kitchen/.test(document.querySelector('#banner-text')?.textContent ?? ''));
  await wrong.close();
}

/** Shipped links with every other character at every seventh place, and cut there. Native tests try every place. @param {Visit} visit */
async function damagedLinks({ name, browser, address, figures }) {
  const page = await PageDriver.open(browser, address);
  const links = (await Promise.all([1, 2, 3].map((version) => readFile(join(ROOT, `tests/golden/links/version-${version}.txt`), 'utf8'))))
    .flatMap((text) => text.split('\n')).filter((line) => /^[0-9a-f]{16} /.test(line)).map((line) => line.slice(17));
  assert.ok(links.length >= 47);
  let tried = 0;
  for (const link of links) {
    const { count, opened } = await page.page.evaluate(async (payload) => {
      const { Engine } = await import(new URL('search/engine.js', location.href).href);
      const { module } = await Engine.load();
      const opens = (/** @type {Uint8Array} */ text) => {
        const at = module._gs_input(text.length);
        module.HEAPU8.set(text, at);
        return module._gs_document_from_text(text.length) !== 0;
      };
      const bytes = new TextEncoder().encode('ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_ #%+/=.\0\n');
      const text = new TextEncoder().encode(payload);
      /** @type {string[]} */
      const bad = opens(text) ? [] : ['the link itself is refused'];
      let count = 0;
      for (let at = 0; at < text.length; at += 7) {
        const right = text[at] ?? 0;
        for (const byte of bytes) {
          text[at] = byte;
          if (byte !== right && opens(text)) bad.push(`byte ${byte} at ${at}`);
        }
        text[at] = right;
        if (opens(text.subarray(0, at))) bad.push(`cut at ${at}`);
        count += bytes.length;
      }
      return { count, opened: bad };
    }, link);
    assert.deepEqual(opened, [], link.slice(0, 40));
    tried += count;
  }
  figures[`damaged links refused in ${name}`] = tried;
  await page.close();
}

/** Each goal of a lesson is valid, uses only existing measures, and is not already met by the lesson's document. @param {Visit} visit */
async function goalsOfLessons({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  const folder = join(ROOT, 'docs/lessons');
  let goals = 0;
  for (const file of (await readdir(folder)).filter((name) => /^\d.*\.md$/.test(name))) {
    const text = await readFile(join(folder, file), 'utf8');
    const opened = await readFile(join(folder, /^open: (.+)$/m.exec(text)?.[1] ?? ''), 'utf8');
    const inText = [...text.matchAll(/^```goal\n(.+)$/gm), ...text.matchAll(/^goal: (.+)$/gm)].map(([, goal]) => goal);
    assert.notEqual(inText.length, 0, file);
    for (const goal of inText) {
      const { met, waits } = await page.page.evaluate(async (json, wanted) => {
        window.gaitsmith.open(json);
        await window.gaitsmith.arrange({ goal: wanted });
        return { met: document.querySelector('#goal')?.classList.contains('met'), waits: document.querySelector('#goal-list')?.textContent ?? '' };
      }, opened, goal);
      assert.equal(met, false, `${file}: ${goal}`);
      // Joints without a limit have no strength.
      assert.ok(waits.length > 10 && !waits.replace('M g L (now –)', '').includes('–'), `${file}: ${waits}`);
      goals++;
    }
  }
  assert.ok(goals >= 7);
  const measured = await page.page.evaluate(() => window.gaitsmith.measures());
  /** @type {typeof import('../../../web/catalogue/catalogue.js')} */
  const { terms } = await page.page.evaluate(async (path) => ({ ...await import(path) }), new URL('catalogue/catalogue.js', address).href);
  for (const term of ['distance', 'travel', ...terms.map(({ name }) => name)]) assert.ok(term in measured, term);
  await page.close();
}

/**
 * What a lesson's link opens and what its button finds does not count as the reader's own, and what the reader's search
 * finds does. tests/examples/lesson_goals.json has the goals of all lessons.
 * @param {Visit} visit
 */
async function ownMotions({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  const goal = 'max_cm_height >= 4, controller = new, world = usual, pushes = 0, seed != 3';
  const hopper = (/** @type {string} */ name) => readFile(join(ROOT, `examples/lessons/5-${name}-hopper.json`), 'utf8');
  const open = async (/** @type {string} */ name) => page.page.evaluate((json) => window.gaitsmith.open(json), await hopper(name));
  /** @param {string} what */
  const unmet = async (what) => {
    await page.frames();
    await page.page.evaluate((wanted) => window.gaitsmith.arrange({ goal: wanted }), goal);
    const waits = await page.page.evaluate(() => [...document.querySelectorAll('#goal li:not(.met)')].map(({ textContent }) => textContent));
    assert.deepEqual(waits, [' found here by your own search'], what);
  };
  await open('population');
  await unmet('a link');
  await open('stuck');
  await page.call('a script', () => window.gaitsmith.synthesize({ algorithm: 'sphc', seed: 4, evaluations: 5000 }).then(() => true));
  await unmet('a script');
  await page.page.evaluate(() => window.gaitsmith.run('search/synthesize'));
  await page.until('the goal reached', () => document.querySelector('#goal')?.classList.contains('met') === true);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** Every wrong option of an address is named, and the right ones are applied. @param {Visit} visit */
async function wrongAddress({ browser, address }) {
  const page = await PageDriver.open(browser, `${address}?panels=kitchen&lock=garage&goal=distance>=1`);
  await page.until('the faults', () => document.querySelector('#banner')?.getAttribute('hidden') === null);
  const text = await page.text('#banner-text');
  assert.match(text, /kitchen/);
  assert.match(text, /garage/);
  await page.until('the goal', () => document.querySelector('#goal li') !== null);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** Part of the main visit. @param {Visit} visit */
export async function damagedLink(visit) {
  const { page } = visit;
  const before = await page.hash();
  const link = await page.link();
  // The page may write its own address before it hears of the person's.
  await page.page.evaluate((damaged, own) => {
    location.hash = damaged;
    history.replaceState(null, '', own);
  }, link.slice(link.indexOf('#'), -7), link);
  await page.until('a banner', () => !document.querySelector('#banner')?.hasAttribute('hidden'));
  const text = await page.call('banner', () => document.querySelector('#banner-text')?.textContent ?? '');
  assert.match(text, /link/);
  assert.match(text, /cut|damaged|truncated|ends|short/);
  assert.equal(await page.hash(), before);
  const covered = await page.call('cover', () => {
    const banner = document.querySelector('#banner')?.getBoundingClientRect();
    const canvas = document.querySelector('canvas')?.getBoundingClientRect();
    return !banner || !canvas || banner.bottom > canvas.top + 1;
  });
  assert.ok(!covered, 'the banner covers the canvas');
  await page.clickElement('#banner-close');
  visit.figures['damaged link'] = text;
}

/** @type {typeof import('./all.mjs').SCENARIOS} */
export const SHARE_SCENARIOS = [
  ['Share has the link, a code that a camera reads, and lines that put it into another page', shareDialog],
  ['where the device can send links to other apps, Share has a button for it', send],
  ['the code of a first motion can be read too', firstMotion, ONE_BROWSER],
  ['links that are damaged, cut, newer, too long or none say so and what to do', linksThatCannotBeOpened],
  ['golden links with one byte changed, or cut, are refused', damagedLinks, ONE_BROWSER],
  ['an address shows panels, locks parts and sets a goal that is ticked', lessonInTheAddress],
  ['every wrong option of an address is named, and the right ones count', wrongAddress, ONE_BROWSER],
  ['a goal asks for a motion of one’s own: not that of a link, nor that of a script', ownMotions, ONE_BROWSER],
  ['the goals of all lessons can be read, are measured, and are still to be reached', goalsOfLessons, ONE_BROWSER],
];
