// SPDX-License-Identifier: MIT
// Takes pictures of the page, in build/screenshots: each panel in each theme on three screens.
//   node tests/browser/pictures.mjs [words of the pictures to take, default all]
//   node tests/browser/pictures.mjs docs    the pictures of docs/pictures.md, in docs/pictures, of the README, and the link preview
import assert from 'node:assert/strict';
import { copyFile, mkdir, readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { PageDriver } from './page_driver.mjs';
import { ROOT, serve, startChromium, stopAll } from './browsers.mjs';

/** @type {[string, number, number, number][]} */
const SCREENS = [['desk', 1280, 720, 1], ['large', 1920, 1080, 1], ['phone', 390, 844, 2]];
const THEMES = ['light', 'dark', 'projector', 'contrast'];
const PANELS = ['figure', 'controller', 'style', 'search', 'lab', 'timeline', 'world', 'beside'];
const COMMANDS = new Map([['world', 'view/world'], ['beside', 'view/compare']]);
const FOLDER = join(ROOT, 'build/screenshots');

/** @param {import('./browsers.mjs').Browser} browser @param {string} address @returns {Promise<number>} how many */
export async function takePictures(browser, address, wanted = '') {
  await mkdir(FOLDER, { recursive: true });
  const example = await readFile(join(ROOT, 'examples/star-man-shuffle.json'), 'utf8');
  let count = 0;
  for (const [screen, width, height, deviceScaleFactor] of SCREENS) {
    const driver = await PageDriver.open(browser, address);
    const { page } = driver;
    const run = (/** @type {string} */ id) => page.evaluate((name) => window.gaitsmith.run(name), id);
    await page.setViewport({ width, height, deviceScaleFactor });
    await page.evaluate((text) => {
      const document = JSON.parse(text);
      window.gaitsmith.open({ ...document, search: { ...document.search, evaluations: 400 } });
    }, example);
    // Paused in the middle, because moving pictures cannot be compared.
    await page.evaluate(() => {
      window.gaitsmith.run('motion/start');
      for (let frame = 0; frame < 310; frame++) window.gaitsmith.run('motion/forward');
    });
    for (const theme of THEMES) {
      await run(`view/theme/${theme}`);
      for (const panel of PANELS) {
        const name = `${screen}-${theme}-${panel}`;
        if (!name.includes(wanted) || (panel === 'timeline' && screen !== 'phone')) continue;
        await run(COMMANDS.get(panel) ?? `panel/${panel[0].toUpperCase()}${panel.slice(1)}`);
        // At first a short search must find the motion to compare with.
        if (panel === 'beside') await driver.until('another motion beside', () =>
          window.gaitsmith.commands().some(({ title }) => title === 'Stop comparing side by side'));
        await driver.frames(4);
        await page.screenshot({ path: /** @type {`${string}.png`} */ (join(FOLDER, `${name}.png`)) });
        if (COMMANDS.has(panel)) await run(COMMANDS.get(panel) ?? '');
        count++;
      }
    }
    // Last, because it changes the motion: a composite, made with the editor.
    for (const id of ['timeline/add', 'timeline/mirror', 'timeline/add', 'timeline/split', 'timeline/duplicate']) await run(id);
    for (const theme of THEMES) {
      const name = `${screen}-${theme}-chained`;
      if (!name.includes(wanted)) continue;
      await run(`view/theme/${theme}`);
      await run(screen === 'phone' ? 'panel/Timeline' : 'panel/Search');
      await driver.until('the transition map', () =>
        window.gaitsmith.widgets().some(({ id, value }) => id === 'timeline/transitions' && value.startsWith('best at')));
      await driver.frames(4);
      await page.screenshot({ path: /** @type {`${string}.png`} */ (join(FOLDER, `${name}.png`)) });
      count++;
    }
    assert.deepEqual(driver.complaints, []);
    await driver.close();
  }
  return count;
}

/** Takes the picture that chat programs show for a link: a figure that has moved far. @param {import('./browsers.mjs').Browser} browser @param {string} address */
async function takePreview(browser, address) {
  const driver = await PageDriver.open(browser, `${address}?panels=none`);
  await driver.page.setViewport({ width: 1200, height: 630 });
  const example = await readFile(join(ROOT, 'examples/gallery/star-man-cartwheel.json'), 'utf8');
  await driver.page.evaluate((text) => {
    window.gaitsmith.open(text);
    window.gaitsmith.run('motion/start');
    for (let frame = 0; frame < 880; frame++) window.gaitsmith.run('motion/forward');
  }, example);
  await driver.frames(4);
  await driver.page.screenshot({ path: /** @type {`${string}.png`} */ (join(ROOT, 'web/preview.png')) });
  await driver.close();
}

/** Takes the picture of the README: two seconds after the first press. @param {import('./browsers.mjs').Browser} browser @param {string} address */
async function takeFirstPress(browser, address) {
  const driver = await PageDriver.open(browser, address, { newcomer: true, plays: true });
  await driver.page.setViewport({ width: 1280, height: 720 });
  await driver.click('stage/teach');
  await driver.until('the gait', () => window.gaitsmith.results().length === 1);
  await driver.until('two seconds of it', () => Number(window.gaitsmith.widgets().find(({ id }) => id === 'transport/scrub')?.value.replace(' s', '')) > 2);
  await driver.page.screenshot({ path: /** @type {`${string}.png`} */ (join(ROOT, 'docs/playground.png')) });
  await driver.close();
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) {
  const address = await serve(join(ROOT, 'build/site'));
  const browser = await startChromium();
  assert.ok(browser, 'Chromium is installed (./dev setup browsers)');
  const docs = process.argv[2] === 'docs';
  console.log(`${await takePictures(browser, address, docs ? '' : process.argv[2])} pictures in build/screenshots`);
  if (docs) {
    await takePreview(browser, address);
    await takeFirstPress(browser, address);
    const text = await readFile(join(ROOT, 'docs/pictures.md'), 'utf8');
    for (const [, name] of text.matchAll(/\(pictures\/(.+?\.png)\)/g)) await copyFile(join(FOLDER, name), join(ROOT, 'docs/pictures', name));
  }
  await browser.close();
  stopAll();
}
