// SPDX-License-Identifier: MIT
// The first screen and the stage at the sizes of a desk, a small window and a phone: what is there, and that nothing covers anything.
import assert from 'node:assert/strict';
import { ONE_BROWSER, PageDriver } from '../page_driver.mjs';
import { Mouse } from '../pointers.mjs';

/** @typedef {import('./all.mjs').Visit} Visit */

// Firefox's window cannot be narrower than about 500.
const SIZES = [{ width: 1280, height: 720 }, { width: 900, height: 700 }, { width: 844, height: 390 }, { width: 700, height: 600 }, { width: 390, height: 844 }];
/** @param {string} name */
const sizesFor = (name) => SIZES.filter(({ width }) => name === 'Chromium' || width > 500);

/** @param {Visit} visit */
async function nothingToPlay({ browser, address, name }) {
  for (const size of sizesFor(name)) {
    const where = `${size.width}×${size.height}`;
    const page = await PageDriver.open(browser, address, { newcomer: true });
    await page.page.setViewport(size);
    await page.frames(6);
    const before = (await page.widgets()).map(({ id }) => id);
    assert.ok(before.includes('stage/teach') && !before.some((id) => id.startsWith('transport/')), `${where}: ${before}`);
    assert.ok(before.some((id) => id.startsWith('goal/')), `${where}: the choices are there`);
    assert.ok(!before.includes('stage/settings'), where);
    if (size.height < 440) { // the figures are a tab beside the goal
      await page.click('dock/1');
      await page.frames();
    }
    assert.ok((await page.widgets()).some(({ id }) => id === 'figures/draw'), `${where}: figures to choose from`);
    await page.click('stage/teach');
    await page.until('a motion', () => window.gaitsmith.results().length > 0);
    await page.until('its transport', () => window.gaitsmith.widgets().some(({ id }) => id === 'transport/play'));
    const after = (await page.widgets()).map(({ id }) => id);
    assert.ok(after.includes('dock/0') && !after.some((id) => id.startsWith('panels/')), `${where}: no panel before it is asked for: ${after}`);
    assert.deepEqual(page.complaints, []);
    await page.close();
  }
}

/** @param {Visit} visit */
async function follow({ browser, address, name }) {
  const page = await PageDriver.open(browser, address);
  for (const size of sizesFor(name)) {
    const where = `${size.width}×${size.height}`;
    await page.page.setViewport(size);
    // On a busy machine the page is laid out much later.
    await page.until(`${where}: a page of this size`, () => {
      const rects = window.gaitsmith.widgets().map(({ rect }) => rect);
      return rects.every(({ x, y, width, height }) => x + width <= innerWidth + 1 && y + height <= innerHeight + 1);
    });
    await page.frames(6);
    const stage = await page.placeOf('stage');
    await page.play(false); // a figure that runs by would be pushed
    const at = { x: stage.x + stage.width - 60, y: stage.y + 0.6 * stage.height };
    // A busy machine draws the end of a drag late, or all of a drag in one frame, which then is a click.
    for (let drags = 0; drags < 5 && !(await page.widgets()).some(({ id }) => id === 'stage/follow'); drags++) {
      await new Mouse(page).drag(at, { x: at.x - 80, y: at.y });
      await page.frames(6);
    }
    assert.ok((await page.widgets()).some(({ id }) => id === 'stage/follow'), `${where}: no Follow`);
    const button = await page.placeOf('stage/follow');
    const all = await page.widgets();
    const over = all.filter(({ id, rect }) => !['stage', 'stage/follow'].includes(id) && rect.x < button.x + button.width && button.x < rect.x + rect.width
      && rect.y < button.y + button.height && button.y < rect.y + rect.height);
    assert.deepEqual(over.map(({ id }) => id), [], where);
    // The numbers end at 63 from the top. The ground begins at 17 to 31 % from the bottom.
    assert.ok(button.y >= stage.y + 63 && button.y + button.height < stage.y + 0.83 * stage.height, `${where}: ${JSON.stringify({ button, stage })}`);
    await page.click('stage/follow');
  }
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function noRing({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  const ring = () => page.call('ring', () => getComputedStyle(/** @type {Element} */ (document.querySelector('canvas'))).outlineStyle);
  const stage = (await page.widgets()).find(({ id }) => id === 'stage')?.rect ?? assert.fail('no stage');
  await page.clickAt(stage.x + 0.5 * stage.width, stage.y + 0.4 * stage.height);
  assert.equal(await page.call('active', () => document.activeElement?.id), 'canvas');
  await page.press('j');
  assert.equal(await ring(), 'none', 'no ring after a click and a letter');
  await page.press('Shift+Tab');
  await page.press('Escape');
  await page.page.focus('#canvas');
  assert.equal(await ring(), 'solid', 'a ring when the keyboard moves the focus');
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function foldedScore({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  await page.click('panels/2');
  await page.frames(4);
  const texts = () => page.call('texts', () => [...document.querySelectorAll('#mirror p')].map((node) => node.textContent ?? ''));
  await page.until('metres', () => [...document.querySelectorAll('#mirror p')].some((node) => /^Travel.*: .* m$/.test(node.textContent ?? '')));
  assert.ok(!(await texts()).some((text) => text.includes('Score')), 'the sum is folded away');
  await page.click('style/sum');
  await page.until('the sum', () => window.gaitsmith.widgets().some(({ id }) => id === 'style/score'));
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @type {import('./all.mjs').Scenario[]} */
export const FIRST_SCREEN_SCENARIOS = [
  ['first screen: the choices and no transport at every size, and a transport with the motion', nothingToPlay, ONE_BROWSER],
  ['first screen: Follow covers nothing at any size', follow, ONE_BROWSER],
  ['first screen: no focus ring around the canvas after a click, and one by keyboard', noRing],
  ['first screen: the Style panel shows metres first, and the sum when unfolded', foldedScore, ONE_BROWSER],
];
