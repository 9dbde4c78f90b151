// SPDX-License-Identifier: MIT
// Breeding by eye: nine motions, picks, the family tree, taste, and links. Each scenario opens its own pages.
import assert from 'node:assert/strict';
import { Mouse } from '../pointers.mjs';
import { ONCE, PageDriver, RARELY, sleep } from '../page_driver.mjs';

/** @typedef {import('./all.mjs').Visit} Visit */

/** @param {PageDriver} page @param {string} id */
const hidden = (page, id) => page.call(`hidden ${id}`, `document.querySelector('#${id}')?.hidden ?? true`);
/** @param {PageDriver} page */
const grown = (page) => page.until('nine children', () => {
  const root = document.querySelector('#breed');
  return root instanceof HTMLElement && !root.hidden && root.dataset.busy === undefined
    && [...document.querySelectorAll('#breed-tiles .tile')].filter((tile) => /** @type {HTMLElement} */ (tile).title).length === 9;
});
/** The tiles' names. @param {PageDriver} page */
const names = (page) => page.call('names', () => [...document.querySelectorAll('#breed-tiles .tile')].map((tile) => tile.ariaLabel ?? ''));
/** @param {PageDriver} page */
const generations = (page) => page.call('generations', () => [...document.querySelectorAll('#breed-rounds button:not(.icon)')].map((round) => round.textContent ?? ''));
/** @param {PageDriver} page */
const lineage = (page) => page.call('lineage', () => window.gaitsmith.document().lineage ?? { rounds: [] });

/** Clicks what may lie below the edge of its panel. @param {PageDriver} page @param {string} selector */
async function clickInPanel(page, selector) {
  await page.call('scroll', `document.querySelector('${selector}').scrollIntoView({ block: 'nearest' })`);
  await page.clickElement(selector);
}

/** @param {Visit} visit @param {object} [options] */
async function breeding({ browser, address }, options) {
  const page = await PageDriver.open(browser, address, options);
  await page.click('stage/breed');
  await grown(page);
  return page;
}

/** @param {Visit} visit */
async function breeds(visit) {
  const page = await breeding(visit);
  const before = await page.hash();
  assert.deepEqual((await lineage(page)).rounds, [], 'looking changes nothing');
  const first = await names(page);
  assert.equal(new Set(first).size, 9, `no two look alike: ${first.join('\n')}`);
  assert.match(first[0], /^Motion 1: −?[\d.]+ m\..*(More than the others|Less): /);
  const pictures = () => page.call('pictures', () => [...document.querySelectorAll('#breed-tiles canvas')].map((canvas) => /** @type {HTMLCanvasElement} */ (canvas).toDataURL()));
  const earlier = /** @type {string[]} */ (await pictures());
  await sleep(400);
  const later = /** @type {string[]} */ (await pictures());
  assert.ok(earlier.filter((picture, i) => picture !== later[i]).length >= 7, 'they play');

  // What is learned on the way would change what the same picks lead to.
  await clickInPanel(page, '#breed-towards');
  // Nothing is picked, so there is nothing to breed from.
  await page.clickElement('#breed-next');
  assert.deepEqual((await lineage(page)).rounds, []);
  await page.clickElement('#breed-tiles li:nth-child(2) .tile');
  await page.press('5');
  assert.equal(await page.call('count', () => document.querySelector('#breed-count')?.textContent), '2 picked');
  await page.press('n');
  await page.until('a second generation', () => window.gaitsmith.document().lineage?.rounds.length === 2);
  await grown(page);
  const second = await names(page);
  assert.notDeepEqual(second, first);
  const [, round] = (await lineage(page)).rounds;
  assert.deepEqual([round.parent, round.picks, round.seed ?? 1], [0, 0b10010, 1]);
  assert.deepEqual((await generations(page)).length, 2);
  assert.notEqual(await page.hash(), before, 'the first pick is the motion now');
  assert.equal(await page.call('measures', () => window.gaitsmith.measures().generations), 2, 'what goals count');

  // What was picked says what is liked.
  assert.equal(await hidden(page, 'likes-use'), false);
  assert.ok(await page.call('bars', () => document.querySelectorAll('#likes li').length) === 6);

  // Back to the ancestor, another branch, and both stay.
  await page.clickElement('#breed-rounds li:nth-child(1) button');
  await grown(page);
  assert.deepEqual(await names(page), first);
  await page.press('9');
  await page.press('n');
  await page.until('a branch', () => window.gaitsmith.document().lineage?.rounds.length === 3);
  await grown(page);
  // The same picks again lead to the children that are there.
  await page.clickElement('#breed-rounds li:nth-child(1) button');
  await grown(page);
  await page.press('2');
  await page.press('5');
  await page.press('n');
  await grown(page);
  assert.deepEqual(await names(page), second);
  assert.equal((await lineage(page)).rounds.length, 3);
  await page.clickElement('#breed-others');
  await page.until('nine others', () => window.gaitsmith.document().lineage?.rounds.length === 4);
  await grown(page);
  assert.notDeepEqual(await names(page), second);

  // One step of Undo for each.
  await page.press('Control+z');
  await page.until('the children before', () => (window.gaitsmith.document().lineage?.rounds.length ?? 0) === 3);
  await page.until('their names', `document.querySelector('#breed-tiles .tile')?.ariaLabel === ${JSON.stringify(second[0])}`);

  // A name for the branch.
  await page.clickElement('#breed-rounds .icon');
  await page.page.keyboard.type('Hops');
  await page.press('Enter');
  assert.equal((await lineage(page)).rounds[1].name, 'Hops');
  assert.match((await generations(page))[1], /^Hops/);

  // To the stage, by the menu.
  await page.clickElement('#breed-tiles li:nth-child(3) .more');
  await page.clickElement('#breed-menu button:first-child');
  await page.until('the stage', () => document.querySelector('#breed')?.hasAttribute('hidden') ?? false);
  assert.equal(await page.call('title', () => window.gaitsmith.document().title), 'Mr. Star-Man');
  const link = await page.link();
  const shown = await page.hash();
  assert.deepEqual(page.complaints, []);
  await page.close();

  // A link has the motion and its family, and grows the same children elsewhere.
  const elsewhere = await PageDriver.open(visit.browser, `${link.replace('#', '?edit#')}`);
  assert.equal(await elsewhere.hash(), shown);
  await elsewhere.click('stage/breed');
  await grown(elsewhere);
  assert.deepEqual(await names(elsewhere), second);
  assert.equal((await generations(elsewhere)).length, 3);
  await elsewhere.press('Escape');
  assert.equal(await hidden(elsewhere, 'breed'), true);
  assert.deepEqual(elsewhere.complaints, []);
  await elsewhere.close();
}

/** @param {Visit} visit */
async function tastes(visit) {
  const page = await breeding(visit);
  assert.match(await page.call('words', () => document.querySelector('#likes-from')?.textContent ?? ''), /^Nothing is known yet/);
  for (let question = 0; question < 3; question++) await clickInPanel(page, question === 1 ? '#pair-neither' : '#pair-first');
  assert.equal(await page.call('words', () => document.querySelector('#likes-from')?.textContent), 'Guessed from 3 comparisons. Grey: not sure yet.');
  await page.press('1');
  await page.press('n');
  await page.until('a second generation', () => window.gaitsmith.document().lineage?.rounds.length === 2);
  await grown(page);
  // A reload keeps family and taste.
  await page.page.reload();
  await page.until('the page', () => window.gaitsmith !== undefined);
  await page.call('ready', () => window.gaitsmith.ready.then(() => true));
  assert.equal((await lineage(page)).rounds.length, 2);
  await page.click('stage/breed');
  await grown(page);
  assert.equal(await page.call('words', () => document.querySelector('#likes-from')?.textContent), 'Guessed from 11 comparisons. Grey: not sure yet.');
  await clickInPanel(page, '#likes-use');
  const weights = await page.call('weights', () => Object.values(window.gaitsmith.document().task?.weights ?? {}));
  assert.ok(weights.some((weight) => weight !== 0), 'the taste is the document’s style');
  await clickInPanel(page, '#likes-forget');
  assert.match(await page.call('words', () => document.querySelector('#likes-from')?.textContent ?? ''), /^Nothing is known yet/);
  // Into the timeline, by the menu.
  await page.clickElement('#breed-tiles li:nth-child(4) .more');
  await page.clickElement('#breed-menu button:nth-child(4)');
  assert.equal(await page.call('clips', () => window.gaitsmith.document().timeline?.length), 2);
  await page.clickElement('#breed-done');
  assert.equal(await hidden(page, 'breed'), true);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** On the cards of results: more and less like this. @param {Visit} visit */
async function cards({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  const pointer = new Mouse(page);
  const learned = () => page.call('learned', () => /** @type {unknown[]} */ (JSON.parse(localStorage.getItem('gaitsmith-taste') ?? '[]')).length);
  await page.call('three results', async () => {
    for (const seed of [1, 2, 3]) await window.gaitsmith.synthesize({ seed, evaluations: 400 });
  });
  const [newest, , oldest] = await page.call('results', () => window.gaitsmith.results().map(({ id, hash }) => ({ id, hash })));
  await page.click('panels/3');
  await pointer.press(`found/${newest.id}/dislike`);
  await page.until('it is noted', () => document.querySelector('#toast')?.textContent === 'Noted: you prefer the other results to this one.');
  assert.equal(await learned(), 2, 'two others are preferred');
  assert.equal(await page.hash(), newest.hash, 'the stage stays');
  await pointer.press(`found/${oldest.id}/like`);
  await grown(page);
  assert.equal(await page.hash(), oldest.hash, 'what is bred from is on the stage');
  assert.equal(await learned(), 4);
  assert.equal(await page.call('words', () => document.querySelector('#likes-from')?.textContent), 'Guessed from 4 comparisons. Grey: not sure yet.');
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @type {import('./all.mjs').Scenario[]} */
export const BREED_SCENARIOS = [
  ['breeds: nine children of picks, a family tree, Undo, and a link that grows the same children', breeds],
  ['learns a taste from picks and answers, keeps it, and makes it the style', tastes, ONCE, RARELY],
  ['a result’s card: more like this breeds from it, less like this is remembered', cards],
];
