// SPDX-License-Identifier: MIT
// The eight questions are answered before and after the lessons, by keys, and a teacher's wall counts them.
import assert from 'node:assert/strict';
import { ONE_BROWSER } from '../../page_driver.mjs';
import { QUESTIONS } from '../../../../web/classroom/questions.js';
import { until } from './learning_system.mjs';
import { recordFiles, saved } from './saved_files.mjs';

/** @typedef {import('../all.mjs').Visit} Visit */
/** @typedef {import('../../browsers.mjs').Page} Page */

/** @param {Visit} visit @param {string} path */
async function open({ browser, address }, path) {
  const page = await (await browser.createBrowserContext()).newPage();
  /** @type {string[]} */
  const complaints = [];
  page.on('pageerror', (error) => complaints.push(/** @type {Error} */ (error).message));
  page.on('console', (message) => { if (message.type() === 'error') complaints.push(message.text()); });
  await page.evaluateOnNewDocument(recordFiles);
  await page.goto(path.startsWith('http') ? path : `${address}${path}`);
  return { page, complaints };
}

/** @param {Page} page @param {string} id @param {string} words */
const says = (page, id, words) => until(words, page, ([where, what]) => document.getElementById(where)?.textContent?.includes(what) ?? false, [id, words]);
/** @param {Page} page @param {string} selector */
const press = (page, selector) => page.$eval(selector, (node) => /** @type {HTMLElement} */ (node).click());
/** Answers all questions by keys alone. @param {Page} page @param {number[]} answers */
async function answer(page, answers) {
  for (const [i, given] of answers.entries()) {
    await page.focus(`#ask-${i + 1}-0`);
    await page.keyboard.press(' ');
    for (let k = 0; k < given; k++) await page.keyboard.press('ArrowDown');
  }
  await page.focus('#questions [type=submit]');
  await page.keyboard.press('Enter');
}
/** @param {Page} page @returns {Promise<string>} */
async function handedIn(page) {
  await press(page, '#hand-in-make');
  await until('the link', page, () => /#H2\./.test(/** @type {HTMLTextAreaElement} */ (document.getElementById('hand-in-link')).value));
  return page.$eval('#hand-in-link', (field) => /** @type {HTMLTextAreaElement} */ (field).value);
}

const RIGHT = QUESTIONS.map(({ right }) => right);

/** @param {Visit} visit */
async function bothRounds(visit) {
  const { page, complaints } = await open(visit, 'book/quiz.html');
  await says(page, 'round-state', 'The first round comes before the lessons.');
  assert.equal(await page.$eval('#questions', (form) => form.checkVisibility()), false, 'a round begins with a button');
  await page.focus('#round-begin');
  await page.keyboard.press('Enter');
  await says(page, 'round-state', 'First round');
  // An open question is named.
  await page.focus('#questions [type=submit]');
  await page.keyboard.press('Enter');
  await says(page, 'round-missing', 'Question 1 has no answer.');
  const first = QUESTIONS.map((_, i) => (i < 2 ? RIGHT[i] : 4));
  await answer(page, first);
  await says(page, 'round-state', 'The first round is finished.');
  assert.equal(await page.$$eval('.feedback', (boxes) => boxes.filter((box) => box.textContent !== '').length), 0, 'nothing is said about what is right');
  const early = await handedIn(page);
  // The lessons take days.
  await page.reload();
  await says(page, 'round-begin', 'Begin the second round');
  await press(page, '#round-begin');
  await says(page, 'round-state', 'Second round');
  assert.equal(await page.$$eval('#questions input', (inputs) => inputs.filter((input) => /** @type {HTMLInputElement} */ (input).checked).length), 0, 'the first answers are not shown');
  await answer(page, RIGHT.map((right, i) => (i === 0 ? (right + 1) % 4 : right)));
  await says(page, 'round-state', 'First round: 2 of 8 right. Second round: 7 of 8 right.');
  const told = await page.$$eval('.feedback', (boxes) => boxes.map((box) => box.textContent ?? ''));
  assert.match(told[0], /^Right is “Nowhere: .* Your first answer was “Nowhere/);
  assert.match(told[2], /^Right\. A clock feels nothing\..* Your first answer was “I do not know”$/);
  await page.type('#hand-in-name', 'K7');
  const link = await handedIn(page);
  await press(page, '#hand-in-file');
  const [{ name, bytes }] = await saved(page);
  assert.deepEqual([name, JSON.parse(bytes.toString()).quiz.before], ['before-and-after.json', first]);
  await press(page, '#round-forget');
  await press(page, '#round-forget');
  await says(page, 'round-state', 'The first round comes before the lessons.');
  assert.deepEqual(complaints, []);
  await page.browserContext().close();

  // The wall: two with names in two parts, the same link again, other questions, and a motion
  const { page: wall, complaints: more } = await open(visit, link);
  await says(wall, 'wall-state', '1 result of the questions before and after.');
  const others = `${visit.address}book/wall.html#H2..${Buffer.from(JSON.stringify({ lesson: '', predictions: [], answers: [], text: '', name: '', quiz: { set: 'zz', before: [0], after: null } })).toString('base64url')}`;
  await wall.evaluate((text) => { /** @type {HTMLTextAreaElement} */ (document.querySelector('#wall-text')).value = text; }, `k7: ${link}\n${early}\n${others}`);
  await press(wall, '#wall-add');
  await says(wall, 'wall-state', '4 results of the questions before and after.');
  const words = await wall.$eval('#wall-quiz', (section) => section.textContent ?? '');
  assert.match(words, /2 students, 1 with both rounds\. 1 sent a round again: the later answers count\. 1 answered other questions than these and are left out\. Those with both rounds had 2\.0 of 8 right before, on average, and 7\.0 after\. The numbers do not say why/);
  const rows = await wall.$$eval('#wall-quiz tbody tr', (lines) => lines.map((line) => [...line.querySelectorAll('td')].map(({ textContent }) => textContent)));
  assert.deepEqual(rows.slice(0, 3), [['2 of 2', '0 of 1', '0', '1', '0', '0'], ['2 of 2', '1 of 1', '0', '0', '1', '0'], ['0 of 2', '1 of 1', '1', '0', '0', '0']]);
  assert.equal(await wall.$eval('#wall-results', (section) => section.checkVisibility()), false, 'there is no motion');
  await press(wall, '#wall-quiz-csv');
  const [table] = await saved(wall);
  assert.match(table.bytes.toString(), /^\ufeffnumber,name,questions,.*\r\n1,K7,1,c,b,\?,\?,\?,\?,\?,\?,d,b,d,a,c,d,b,a,2,7\r\n2,,1,c,b,\?,.*,2,\r\n$/s);
  await press(wall, '#wall-clear');
  await says(wall, 'wall-state', 'The wall is empty.');
  assert.equal(await wall.$eval('#wall-quiz', (section) => section.checkVisibility()), false);
  assert.deepEqual(more, []);
  await wall.browserContext().close();
}

/** The questions, what is said about the answers, and the wall are in the page's language. @param {Visit} visit */
async function inGerman(visit) {
  const { page, complaints } = await open(visit, 'book/de/quiz.html');
  await says(page, 'round-state', 'Die erste Runde kommt vor den Lektionen.');
  await press(page, '#round-after');
  const shown = await page.$eval('#questions', (form) => /** @type {HTMLElement} */ (form).innerText);
  assert.match(shown, /1\. Ein Putzroboter hat zwei Regeln.*Weiß ich nicht/s);
  for (const { question, answers } of QUESTIONS) for (const words of [question, ...answers]) assert.ok(!shown.includes(words), words);
  await answer(page, RIGHT.map((right, i) => (i === 0 ? 4 : right)));
  await says(page, 'round-state', 'Zweite Runde: 7 von 8 richtig.');
  const [first, , third] = await page.$$eval('.feedback', (boxes) => boxes.map((box) => box.textContent ?? ''));
  assert.match(first, /^Richtig ist „Nirgends: .*“ Die Regeln kennen keinen Raum\./);
  assert.match(third, /^Richtig\. Eine Uhr spürt nichts\./);
  const link = await handedIn(page);
  assert.match(link, /book\/de\/wall\.html#H2\./);
  await page.goto(link);
  await says(page, 'wall-state', '1 Ergebnis der Fragen vorher und nachher.');
  assert.match(await page.$eval('#wall-quiz', (section) => section.textContent ?? ''), /1 Person, 0 mit beiden Runden\. Die Zahlen zeigen nicht.*Putzroboter.*✓ Nirgends.*0 von 1/s);
  assert.deepEqual(complaints, []);
  await page.browserContext().close();
}

/** @type {import('../all.mjs').Scenario[]} */
export const BEFORE_AFTER_SCENARIOS = [
  ['eight questions are answered before and after the lessons, and the wall counts them', bothRounds, ONE_BROWSER],
  ['the questions before and after are asked and explained in German', inGerman, ONE_BROWSER],
];
