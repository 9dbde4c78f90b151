// SPDX-License-Identifier: MIT
// The page where a teacher collects a class's work. Everything happens in this page: it sends nothing.
import { Engine } from '../search/engine.js';
import { control_modes, terms } from '../catalogue/catalogue.js';
import { tr, trSentence } from '../languages/language.js';
import { MotionPicture, pageColours } from '../share/motion_picture.js';
import { parseGoal } from '../page/goal_conditions.js';
import { collect, fromFile } from './collected.js';
import { Judge } from './judge.js';
import { answerTables, rowOf, sentences } from './wall_rows.js';
import { showQuiz } from './wall_quiz.js';
import { ClassGallery } from './class_gallery.js';
import { copies, csvOf, sorted } from './table.js';

/** @typedef {import('./collected.js').Entry} Entry */
/** @typedef {import('./judge.js').Row} Row */

const SITE = new URL('../', import.meta.url).href;
/** @template {HTMLElement} T @param {string} id @param {new () => T} kind @returns {T} */
const find = (id, kind) => {
  const found = document.getElementById(id);
  if (!(found instanceof kind)) throw new Error(`no #${id}`);
  return found;
};
const pasted = find('wall-text', HTMLTextAreaElement);
const goal = find('wall-goal', HTMLInputElement);
const order = find('wall-order', HTMLSelectElement);
const files = find('wall-files', HTMLInputElement);
const state = find('wall-state', HTMLElement);
const results = find('wall-results', HTMLElement);
const body = /** @type {HTMLTableSectionElement} */ (document.querySelector('#wall-table tbody'));

/** What was sent, in order of arrival. @type {Entry[]} */
let entries = [];
/** @type {Row[]} */
let rows = [];
/** Rises with each new judgement; an older one stops. */
let round = 0;
const tables = { terms, control_modes };
/** @type {Promise<Judge> | null} */
let judge = null;
const loadJudge = async () => {
  const [engine, response] = await Promise.all([Engine.load(), fetch('lessons.json')]);
  return new Judge(engine, tables, await response.json());
};
const gallery = new ClassGallery(find('wall-gallery', HTMLDialogElement));

/** @param {Entry[]} more @param {number} [idle]  lines without a link */
async function add(more, idle = 0) {
  entries = [...entries, ...more];
  await judgeAll(idle === 0 ? '' : idle === 1 ? tr('1 line has no link.') : tr('{1} lines have no link.', idle));
}

/** Simulates everything anew, because the goal may have changed. @param {string} [remark] */
async function judgeAll(remark = '') {
  const mine = ++round;
  for (const { motion } of rows) motion?.close();
  rows = [];
  state.textContent = tr('Simulating …');
  try {
    parseGoalField();
    judge ??= loadJudge();
    const with_ = await judge;
    for (const entry of entries.filter((each) => !quizOf(each))) {
      if (mine !== round) return;
      rows.push(with_.judge(entry, goal.value.trim()));
      if (rows.length % 5 === 0) await new Promise((resolve) => { setTimeout(resolve); });
    }
  } catch (error) {
    judge = null;
    state.textContent = trSentence(error instanceof Error ? error.message : String(error));
    return;
  }
  if (mine !== round) return;
  show();
  const asked = showQuiz(entries.flatMap((entry) => quizOf(entry) ?? []));
  const met = rows.filter((row) => row.met === true).length, faulty = rows.filter(({ fault }) => fault !== '').length;
  const count = rows.length === 1 ? tr('1 piece of work') : tr('{1} pieces of work', rows.length);
  const works = faulty > 0 ? tr('{1}, {2} with the goal reached, {3} that cannot be read.', count, met, faulty) : tr('{1}, {2} with the goal reached.', count, met);
  state.textContent = [asked !== '' && rows.length === 0 ? '' : works, asked, remark].filter(Boolean).join(' ');
}

/** Results of the questions before and after have no motion, and a table of their own. @param {Entry} entry */
const quizOf = (entry) => (entry.fault === undefined && entry.work.quiz ? entry.work : null);

function parseGoalField() {
  goal.removeAttribute('aria-invalid');
  if (goal.value.trim() === '') return;
  try {
    parseGoal(goal.value, tables);
  } catch (error) {
    goal.setAttribute('aria-invalid', 'true');
    throw error;
  }
}

function show() {
  results.hidden = rows.length === 0;
  const same = copies(rows), colours = pageColours();
  const shown = sorted(rows, /** @type {import('./table.js').Order} */ (order.value));
  body.replaceChildren(...shown.map((row) => rowOf(row, rows.indexOf(row) + 1, same.get(row), SITE)));
  for (const [i, canvas] of [...body.querySelectorAll('canvas')].entries()) {
    const { motion } = shown.filter((row) => row.motion)[i];
    if (motion) new MotionPicture(motion).strip(canvas, colours);
  }
  find('wall-answers', HTMLElement).replaceChildren(...answerTables(rows));
  find('wall-sentences', HTMLElement).replaceChildren(...sentences(rows));
}

/** @param {Iterable<File>} chosen */
async function addFiles(chosen) {
  /** @type {Entry[]} */
  const found = [];
  for (const file of chosen) found.push(...file.size > 5_000_000 ? [{ fault: tr('This file is too large.'), source: file.name }] : fromFile(file.name, await file.text()));
  await add(found);
}

find('wall-add', HTMLButtonElement).addEventListener('click', () => {
  const { entries: found, idle } = collect(pasted.value);
  if (found.length === 0) {
    state.textContent = tr('There is no link in this text.');
    return;
  }
  pasted.value = '';
  void add(found, idle);
});
files.addEventListener('change', async () => {
  await addFiles(files.files ?? []);
  files.value = '';
});
goal.addEventListener('change', () => void judgeAll());
order.addEventListener('change', show);
addEventListener('dragover', (event) => event.preventDefault());
addEventListener('drop', (event) => {
  event.preventDefault();
  const { files: dropped = [] } = event.dataTransfer ?? {};
  if (dropped.length > 0) return void addFiles(dropped);
  const { entries: found, idle } = collect(event.dataTransfer?.getData('text/plain') ?? '');
  if (found.length > 0) void add(found, idle);
});
find('wall-clear', HTMLButtonElement).addEventListener('click', () => {
  entries = [];
  void judgeAll().then(() => { state.textContent = tr('The wall is empty.'); });
});
find('wall-print', HTMLButtonElement).addEventListener('click', () => print());
find('wall-csv', HTMLButtonElement).addEventListener('click', () => {
  const address = URL.createObjectURL(new Blob(['\ufeff', csvOf(rows, SITE)], { type: 'text/csv' }));
  Object.assign(document.createElement('a'), { href: address, download: 'class.csv' }).click();
  setTimeout(() => URL.revokeObjectURL(address), 60000);
});
find('wall-show', HTMLButtonElement).addEventListener('click', () => gallery.open(rows));
// The book's switch between light and dark follows the system.
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', show);

goal.value = new URLSearchParams(location.search).get('goal') ?? '';
if (goal.value) /** @type {HTMLDetailsElement} */ (goal.closest('details')).open = true;
// A link to a student's work opens the wall with that work.
if (location.hash.length > 1) void add(collect(location.href).entries).then(() => results.scrollIntoView());
