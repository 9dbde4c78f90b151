// SPDX-License-Identifier: MIT
// A newcomer's first minute: a bird that cannot move, one press, and a sprint. Each scenario opens its own pages.
import assert from 'node:assert/strict';
import { ONE_BROWSER, PageDriver } from '../page_driver.mjs';

/** @typedef {import('./all.mjs').Visit} Visit */

const BIRD_METRES = 16; // 2 m/s for eight seconds
/** @param {PageDriver} page */
const ids = async (page) => (await page.widgets()).map(({ id }) => id);
/** Waits for the end of a search. @param {PageDriver} page @param {number} searches  number of results until then @returns the metres of the shown motion */
async function metres(page, searches) {
  await page.until('the end of the search', `window.gaitsmith.results().length >= ${searches}`);
  return page.call('metres', () => window.gaitsmith.results().find(({ hash }) => hash === window.gaitsmith.hash())?.score ?? 0);
}

/** @param {Visit} visit */
async function firstPress({ browser, address }) {
  const page = await PageDriver.open(browser, address, { newcomer: true, plays: true });
  assert.match(await page.call('headline', () => document.querySelector('#mirror')?.textContent ?? ''), /This ostrich can’t move yet\./);
  const before = await ids(page);
  assert.ok(before.includes('stage/teach') && before.includes('figures/draw'), 'the first screen');
  assert.ok(!before.some((id) => /^(panels|timeline|transport|search)\//.test(id)), 'nothing else asks for attention');
  assert.equal(await page.call('undo', () => window.gaitsmith.canUndo()), false);
  await page.click('stage/teach');
  assert.ok(await metres(page, 1) >= BIRD_METRES, 'it sprints');
  await page.until('it plays', () => window.gaitsmith.widgets().some(({ id, label }) => id === 'transport/play' && label === 'Pause'));
  // Each further try takes the next seed.
  const first = await page.hash();
  await page.click('stage/another');
  assert.ok(await metres(page, 2) >= BIRD_METRES, 'the next one sprints, too');
  assert.notEqual(await page.hash(), first);
  // A calmer one begins with this one.
  await page.click('stage/calmer');
  await page.until('the calmer one', () => window.gaitsmith.results().length === 3);
  assert.ok(await page.call('weight', () => (window.gaitsmith.document().task?.weights?.effort ?? 0) < 0));
  // Another goal makes the stage's button teach again.
  await page.click('goal/high-jump');
  await page.until('another lesson', () => window.gaitsmith.widgets().some(({ id, label }) => id === 'stage/another' && label === 'Teach it to jump'));
  // All panels, and back.
  await page.click('make/advanced');
  await page.until('the panels', () => window.gaitsmith.widgets().some(({ id }) => id === 'panels/2'));
  assert.ok(!(await ids(page)).some((id) => id.startsWith('goal/')));
  await page.page.evaluate(() => window.gaitsmith.run('view/simple'));
  await page.until('the choices', () => window.gaitsmith.widgets().some(({ id }) => id === 'goal/far'));
  await page.reload();
  assert.ok((await ids(page)).includes('goal/far'), 'a reload keeps the choices');
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function byKey({ browser, address }) {
  const page = await PageDriver.open(browser, address, { newcomer: true, plays: true });
  await page.press('Enter');
  assert.ok(await metres(page, 1) >= BIRD_METRES);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function lessMotion({ browser, address }) {
  const page = await PageDriver.open(browser, address, { newcomer: true, plays: true, before: () => {
    const { matchMedia } = window;
    window.matchMedia = (query) => (query.includes('prefers-reduced-motion')
      ? /** @type {MediaQueryList} */ (Object.assign(new EventTarget(), { matches: true, media: query, onchange: null })) : matchMedia.call(window, query));
  } });
  await page.click('stage/teach');
  assert.ok(await metres(page, 1) >= BIRD_METRES);
  const still = (await page.widgets()).find(({ id }) => id === 'transport/play');
  assert.equal(still?.label, 'Play', 'nothing plays by itself');
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** Motions lie in a row: a press shows one, nothing moves under the pointer, and the goal stays. @param {Visit} visit */
async function rail({ browser, address }) {
  const page = await PageDriver.open(browser, address, { newcomer: true, plays: true, live: false });
  await page.click('stage/teach');
  await metres(page, 1);
  const first = await page.hash();
  await page.click('stage/another');
  await metres(page, 2);
  await page.click('goal/head-up');
  const cards = async () => (await page.widgets()).filter(({ id }) => /^rail\/[0-9a-f]{16}$/.test(id));
  await page.until('two cards', () => window.gaitsmith.widgets().filter(({ id }) => /^rail\/[0-9a-f]{16}$/.test(id)).length === 2);
  const before = await cards();
  await page.click(before[1].id);
  await page.until('the first motion', `window.gaitsmith.hash() === ${JSON.stringify(first)}`);
  await page.frames(5);
  const after = await cards();
  assert.deepEqual(after.map(({ id, rect }) => [id, rect]), before.map(({ id, rect }) => [id, rect]), 'nothing moves');
  assert.deepEqual(after.map(({ state }) => state.selected), [false, true]);
  assert.ok((await page.widgets()).some(({ id, state }) => id === 'goal/head-up' && state.checked), 'the goal stays');
  // A second clip opens the timeline; another motion does not take its place without a question.
  await page.click('stage/chain');
  await page.until('two clips', () => (/** @type {{timeline?: unknown[]}} */ (window.gaitsmith.document()).timeline ?? []).length === 2);
  await page.until('the timeline', () => window.gaitsmith.widgets().some(({ id }) => id === 'timeline/add'));
  const chained = await page.hash();
  await page.click('dock/1');
  await page.frames(5);
  await page.click(before[0].id);
  await page.frames(5);
  assert.equal(await page.hash(), chained);
  await page.click('rail/cancel');
  await page.frames(5);
  await page.click(before[0].id);
  await page.click('rail/replace');
  await page.until('one clip', () => (/** @type {{timeline?: unknown[]}} */ (window.gaitsmith.document()).timeline ?? []).length === 1);
  // Another figure is one press away.
  await page.click('dock/0');
  await page.frames(5);
  const frog = (await page.widgets()).find(({ id, label }) => id.startsWith('figures/') && label === 'Frog');
  assert.ok(frog);
  await page.click(frog.id);
  await page.until('the frog', () => window.gaitsmith.document().figure?.name === 'Frog');
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function addresses({ browser, address }) {
  const page = await PageDriver.open(browser, `${address}?open=there-and-back`);
  await page.until('the example', () => window.gaitsmith.document().title === 'There and back');
  assert.equal(await page.call('undo', () => window.gaitsmith.canUndo()), false);
  await page.close();
  const wrong = await PageDriver.open(browser, `${address}?open=unicorn&panels=kitchen`);
  const banner = () => document.querySelector('#banner-text')?.textContent ?? '';
  await wrong.until('the banner', () => !document.querySelector('#banner')?.hasAttribute('hidden'));
  assert.match(await wrong.call('banner', banner), /kitchen.*unicorn/s, 'all mistakes are reported');
  assert.deepEqual([...page.complaints, ...wrong.complaints], []);
  await wrong.close();
}

/** @type {import('./all.mjs').Scenario[]} */
export const DOOR_SCENARIOS = [
  ['a newcomer teaches a bird to sprint, tries another, calms it, and finds all panels', firstPress],
  ['a newcomer teaches the bird by the Enter key', byKey],
  ['a newcomer compares motions in a row, chains two, and takes another figure', rail, ONE_BROWSER],
  ['with reduced motion the first press finds a gait, and nothing plays by itself', lessMotion],
  ['an address opens an example by its name, and all its mistakes are reported', addresses],
];
