// SPDX-License-Identifier: MIT
// A lesson is predicted, done, written about and handed in, and a teacher's wall judges it.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { ROOT } from '../../browsers.mjs';
import { ONE_BROWSER, PageDriver, PATIENCE_MS } from '../../page_driver.mjs';

/** @typedef {import('../all.mjs').Visit} Visit */
/** @typedef {import('../../browsers.mjs').Page} Page */

/** @param {Visit} visit @param {string} path */
async function open({ browser, address }, path) {
  const page = await (await browser.createBrowserContext()).newPage();
  /** @type {string[]} */
  const faults = [];
  page.on('pageerror', (error) => faults.push(/** @type {Error} */ (error).message));
  page.on('console', (message) => { if (message.type() === 'error') faults.push(message.text()); });
  await page.goto(`${address}${path}`);
  return { page, faults };
}
/** @param {Page} page @param {string} selector @param {RegExp} words */
const says = (page, selector, words) => page.waitForFunction((which, source) => new RegExp(source).test(document.querySelector(which)?.textContent ?? ''), { timeout: PATIENCE_MS }, selector, words.source);
/** @param {Page} page @param {string} selector */
const press = (page, selector) => page.evaluate((which) => /** @type {HTMLElement} */ (document.querySelector(which)).click(), selector);

/** @param {Visit} visit */
async function lesson(visit) {
  const { page, faults } = await open(visit, 'book/lessons/1-a-rule.html');
  assert.equal(await page.evaluate(() => getComputedStyle(/** @type {Element} */ (document.querySelector('#observations'))).display), 'none', 'Notice waits');
  await press(page, '.predict input[value="1"]');
  await press(page, '.quiz input[value="1"]');
  await page.type('#sentences', 'The ground joins <b>two</b> rules.');
  // The goal: four of six rules go.
  const frame = await page.waitForFrame((each) => each.url().includes('panels=controller'), { timeout: PATIENCE_MS });
  await frame.waitForFunction(() => window.gaitsmith?.document !== undefined, { timeout: PATIENCE_MS });
  await frame.evaluate(() => window.gaitsmith.ready.then(() => true));
  const json = JSON.parse(await readFile(join(ROOT, 'examples/gallery/kangaroo-hop.json'), 'utf8'));
  const rules = json.controllers[0].rules;
  const bare = { ...json, hash: undefined, controllers: [{ ...json.controllers[0], rules: [rules[0], rules[2]] }] };
  await frame.evaluate((text) => window.gaitsmith.open(text), JSON.stringify(bare));
  await page.waitForFunction(() => document.querySelector('.goal.met') !== null, { timeout: PATIENCE_MS });
  await page.waitForFunction(() => getComputedStyle(/** @type {Element} */ (document.querySelector('#observations'))).display !== 'none');
  await page.waitForFunction(() => /"motion":"A/.test(localStorage.getItem('gaitsmith-lessons') ?? ''), { timeout: PATIENCE_MS });
  await page.reload();
  await page.waitForFunction(() => /** @type {HTMLInputElement} */ (document.querySelector('.predict input[value="1"]')).checked);
  assert.equal(await page.evaluate(() => /** @type {HTMLTextAreaElement} */ (document.querySelector('#sentences')).value), 'The ground joins <b>two</b> rules.', 'kept over a reload');
  await page.type('#hand-in-name', 'Zoë');
  await press(page, '#hand-in-make');
  await says(page, '#hand-in .state', /Still missing: questions are open\./);
  const link = await page.evaluate(() => /** @type {HTMLTextAreaElement} */ (document.querySelector('#hand-in-link')).value);
  assert.deepEqual(faults, []);
  await page.browserContext().close();

  // The wall in another language has the lesson's questions in it.
  const { page: german, faults: none } = await open(visit, `book/de/wall.html${new URL(link).hash}`);
  await says(german, '#wall-state', /^1 Arbeit, 1 mit erreichtem Ziel\.$/);
  assert.match(await german.evaluate(() => document.querySelector('#wall-table tbody tr')?.textContent ?? ''), /1\. Was eine Reiz-Reaktions-Regel ist.*✓ erreicht.*zwei.*1 von 2 Fragen richtig/s);
  assert.deepEqual(none, []);
  await german.browserContext().close();

  // What the teacher gets.
  const { page: wall, faults: more } = await open(visit, new URL(link).pathname.slice(1) + new URL(link).hash);
  await says(wall, '#wall-state', /1 piece of work, 1 with the goal reached/);
  const row = await wall.evaluate(() => document.querySelector('#wall-table tbody tr')?.textContent ?? '');
  assert.match(row, /Zoë.*✓ reached.*rules 2.*travel 2\d.*two.*1 of 2 questions right.*The ground joins <b>two<\/b> rules\./s);
  assert.equal(await wall.evaluate(() => document.querySelectorAll('#wall-results b').length), 0, 'what was written is no markup');
  // The same link again, a damaged one, and a motion without a lesson with the teacher's goal
  await wall.evaluate((text) => { /** @type {HTMLTextAreaElement} */ (document.querySelector('#wall-text')).value = text; },
    `Ben: ${link.replace('Zoë', '')}\nEve: ${link.slice(0, -9)}\nMia: ${visit.address}#${link.split('.').at(-2)}\nhello`);
  await press(wall, '#wall-add');
  await says(wall, '#wall-state', /4 pieces of work, 2 with the goal reached, 1 that cannot be read. 1 line has no link./);
  await wall.evaluate(() => {
    const goal = /** @type {HTMLInputElement} */ (document.querySelector('#wall-goal'));
    goal.value = 'travel >= 1000';
    goal.dispatchEvent(new Event('change'));
  });
  await wall.waitForFunction(() => document.querySelectorAll('#wall-table .bad').length === 1, { timeout: PATIENCE_MS });
  const text = await wall.evaluate(() => document.querySelector('#wall-results')?.textContent ?? '');
  assert.match(text, /same motion as 1/);
  assert.match(text, /cut off|damaged/);
  await press(wall, '#wall-show');
  await wall.waitForFunction(() => document.querySelectorAll('#wall-gallery[open] canvas').length === 3);
  await press(wall, '#wall-gallery button');
  await press(wall, '#wall-clear');
  await says(wall, '#wall-state', /empty/);
  assert.deepEqual(more, []);
  await wall.browserContext().close();
}

/** An assignment made in Share, done, handed in and judged. @param {Visit} visit */
async function assignment(visit) {
  const page = await PageDriver.open(visit.browser, visit.address);
  await page.clickElement('#share');
  await page.until('the dialog', () => document.querySelector('#share-dialog[open]') !== null);
  await page.clickElement('#share-embed summary');
  await page.clickElement('#share-locks input[value=world]');
  await page.page.type('#share-goal', 'distence >= 1');
  await page.press('Tab');
  await page.until('the fault', () => /distence/.test(document.querySelector('#share-goal-fault')?.textContent ?? ''));
  await page.page.evaluate(() => { /** @type {HTMLInputElement} */ (document.querySelector('#share-goal')).value = ''; });
  await page.page.type('#share-goal', 'distance >= 1');
  await page.press('Tab');
  await page.page.type('#share-task', 'Go a <i>metre</i>.');
  const set = await page.call('link', () => /** @type {HTMLTextAreaElement} */ (document.querySelector('#share-set')).value);
  const wallAddress = await page.call('wall', () => /** @type {HTMLAnchorElement} */ (document.querySelector('#share-wall')).href);
  assert.match(set, /\?lock=world&goal=distance%3E%3D1&task=[^#]+#A/);
  assert.deepEqual(page.complaints, []);
  await page.close();

  const pupil = await PageDriver.open(visit.browser, set);
  await pupil.until('the task', () => document.querySelector('#task-text')?.textContent === 'Go a <i>metre</i>.');
  await pupil.until('the goal', () => document.querySelector('#goal.met') !== null);
  await pupil.clickElement('#task-hand-in');
  await pupil.until('the dialog', () => document.querySelector('#work-dialog[open]') !== null);
  await pupil.page.type('#work-text', 'It shuffles.');
  const link = await pupil.call('link', () => /** @type {HTMLTextAreaElement} */ (document.querySelector('#work-link')).value);
  assert.deepEqual(pupil.complaints, []);
  await pupil.close();

  const { page: wall, faults } = await open(visit, wallAddress.slice(visit.address.length));
  await wall.evaluate((text) => { /** @type {HTMLTextAreaElement} */ (document.querySelector('#wall-text')).value = text; }, link);
  await press(wall, '#wall-add');
  await says(wall, '#wall-state', /1 piece of work, 1 with the goal reached/);
  assert.match(await wall.evaluate(() => document.querySelector('#wall-table tbody tr')?.textContent ?? ''), /✓ distance .*It shuffles\./s);
  assert.deepEqual(faults, []);
  await wall.browserContext().close();
}

/** @type {import('../all.mjs').Scenario[]} */
export const CLASSROOM_SCENARIOS = [
  ['a lesson is handed in by a link, and the wall simulates and judges it', lesson, ONE_BROWSER],
  ['an assignment is made in Share, done, handed in and judged', assignment, ONE_BROWSER],
];
