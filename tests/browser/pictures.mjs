// SPDX-License-Identifier: MIT
// Takes pictures of the page, in build/screenshots: each panel in each theme on three screens.
//   node tests/browser/pictures.mjs [words of the pictures to take, default all]
//   node tests/browser/pictures.mjs door    what a newcomer meets, on five screens
//   node tests/browser/pictures.mjs docs    the pictures of docs/pictures.md, in docs/pictures, of the README, and the link preview
import assert from 'node:assert/strict';
import { copyFile, mkdir, readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { PageDriver, sleep } from './page_driver.mjs';
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

/** Presses a button that may be in the menu. @param {PageDriver} driver @param {string} selector */
const press = (driver, selector) => driver.call('press', `document.querySelector('${selector}').click()`);

/** @param {PageDriver} driver @param {(x: number, y: number) => Promise<void>} use */
async function atButton(driver, use) {
  const { x, y, width, height } = await driver.placeOf('stage/teach');
  await use(x + width / 2, y + height / 2);
}

/** What a newcomer meets, after the first screen. @type {Record<string, (driver: PageDriver) => Promise<unknown>>} */
const STATES = {
  first: () => Promise.resolve(),
  focused: (driver) => driver.press('Tab', 3),
  hovered: (driver) => atButton(driver, (x, y) => driver.page.mouse.move(x, y)),
  pressed: (driver) => atButton(driver, async (x, y) => {
    await driver.page.mouse.move(x, y);
    await driver.page.mouse.down();
  }),
  busy: async (driver) => {
    await driver.page.mouse.up();
    await driver.until('a search', () => window.gaitsmith.widgets().some(({ id }) => id === 'stage/stop'));
  },
  found: async (driver) => {
    await driver.until('the gait', () => window.gaitsmith.results().length === 1);
    await driver.until('the actions', () => window.gaitsmith.widgets().some(({ id }) => id === 'stage/another'));
    await driver.until('two seconds of it', () => Number(window.gaitsmith.widgets().find(({ id }) => id === 'transport/scrub')?.value.replace(' s', '')) > 2);
  },
  share: async (driver) => {
    await press(driver, '#share');
    await driver.until('the dialog', () => document.querySelector('#share-dialog[open]') !== null);
    await sleep(500);
  },
  open: async (driver) => {
    await driver.page.evaluate(() => /** @type {HTMLDialogElement} */ (document.querySelector('#share-dialog')).close());
    await press(driver, '#open');
    await driver.until('the gallery', () => document.querySelectorAll('#open-dialog img, #open-dialog canvas').length > 3);
    await sleep(1500);
  },
  breed: async (driver) => {
    await driver.press('Escape');
    await driver.press('Control+k');
    await driver.page.keyboard.type('Breed');
    await driver.press('Enter');
    await driver.until('nine children', () => [...document.querySelectorAll('#breed-tiles .tile')].filter((tile) => /** @type {HTMLElement} */ (tile).title).length === 9);
    await driver.press('2');
    await sleep(1500);
  },
  drawing: async (driver) => {
    await driver.press('Escape');
    await press(driver, '#new');
    const drawn = (await driver.widgets()).some(({ id }) => id === 'figures/draw');
    if (!drawn) return; // low windows have no room for the row beside the stage
    await driver.click('figures/draw');
    await driver.until('the board', () => window.gaitsmith.widgets().some(({ id }) => id === 'figure/board'));
  },
};
/** @type {[string, number, number, number, string][]} */
const DOORS = [['desk', 1280, 720, 1, 'light'], ['large', 1920, 1080, 1, 'dark'], ['phone', 390, 844, 2, 'light'], ['sideways', 844, 390, 2, 'dark'],
  ['tablet', 820, 1180, 1, 'light'], ['desk', 1280, 720, 1, 'projector'], ['desk', 1280, 720, 1, 'contrast']];

/** Takes pictures of what a newcomer meets. @param {import('./browsers.mjs').Browser} browser @param {string} address @returns {Promise<number>} how many */
async function takeDoor(browser, address) {
  let count = 0;
  for (const [screen, width, height, deviceScaleFactor, theme] of DOORS) {
    const driver = await PageDriver.open(browser, address, { newcomer: true, plays: true });
    await driver.page.setViewport({ width, height, deviceScaleFactor });
    await driver.page.evaluate((name) => window.gaitsmith.run(`view/theme/${name}`), theme);
    await driver.frames(10);
    for (const [state, reach] of Object.entries(STATES)) {
      await reach(driver);
      await driver.frames(4);
      await driver.page.screenshot({ path: /** @type {`${string}.png`} */ (join(FOLDER, `door-${screen}-${theme}-${state}.png`)) });
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
  await mkdir(FOLDER, { recursive: true });
  const address = await serve(join(ROOT, 'build/site'));
  const browser = await startChromium();
  assert.ok(browser, 'Chromium is installed (./dev setup browsers)');
  const docs = process.argv[2] === 'docs';
  if (docs || process.argv[2] === 'door') console.log(`${await takeDoor(browser, address)} pictures of the door in build/screenshots`);
  if (process.argv[2] !== 'door') console.log(`${await takePictures(browser, address, docs ? '' : process.argv[2])} pictures in build/screenshots`);
  if (docs) {
    await takePreview(browser, address);
    await takeFirstPress(browser, address);
    const text = await readFile(join(ROOT, 'docs/pictures.md'), 'utf8');
    for (const [, name] of text.matchAll(/\(pictures\/(.+?\.png)\)/g)) await copyFile(join(FOLDER, name), join(ROOT, 'docs/pictures', name));
  }
  await browser.close();
  stopAll();
}
