// SPDX-License-Identifier: MIT
// The page where a lesson is written. The preview is made by the code of the book's build, and the saved file is what the
// build takes. The draft stays in this browser.
import * as tables from '../../catalogue/catalogue.js';
import { tr, trSentence } from '../../languages/language.js';
import { faultOfGoal } from '../../page/goal_conditions.js';
import { Engine } from '../../search/engine.js';
import { Faults } from '../faults.mjs';
import { startQuizzes } from '../quiz.js';
import { goal, motion, motionLink, prediction, quiz } from './inserts.js';
import { fileOf, KEYS, lessonOf, lessonText } from './lesson_file.mjs';
import { Preview } from './preview.mjs';
import { shown } from './shown.js';

const DRAFT = 'gaitsmith-new-lesson';
const REST_MS = 300;
const MOST_BYTES = 1e6;
const START = `One or two sentences that make your reader curious.

## Predict

## Do
What to try, and what to look at.

## Notice
What could be seen. This part stays folded until a goal is reached.

## Explain
Ask for one or two sentences. A field to write in stands below this paragraph.
`;

/** @template {HTMLElement} T @param {string} id @param {new () => T} [kind] @returns {T} */
const find = (id, kind = /** @type {any} */ (HTMLElement)) => {
  const found = document.getElementById(id);
  if (!(found instanceof kind)) throw new Error(`no #${id}`);
  return found;
};
const input = (/** @type {string} */ id) => find(id, HTMLInputElement);
const text = find('lesson-text', HTMLTextAreaElement), state = find('lesson-state'), list = find('lesson-faults'), article = find('lesson-preview');
/** The name of the file that was opened; '': the title's. */
let opened = '';
/** The lesson as it was saved, opened or begun last: what another file may replace without a question. */
let safe = '';
/** The file that would have replaced something else. */
let refused = '';
/** @type {Promise<Preview> | null} */
let preview = null;
/** Rises with each change; an older preview is not shown. */
let round = 0;
/** @type {ReturnType<typeof setTimeout> | undefined} */
let timer;

const boxes = (/** @type {string} */ group) => /** @type {HTMLInputElement[]} */ ([...find(`lesson-${group}`).querySelectorAll('input')]);
const chosen = (/** @type {string} */ group) => boxes(group).filter(({ checked }) => checked).map(({ value }) => value);

/** The lesson's file as it is now. */
function written() {
  const shownPanels = chosen('panels');
  return lessonText({
    title: input('lesson-title').value, minutes: input('lesson-minutes').value, open: input('lesson-open').value, goal: input('lesson-goal').value,
    panels: shownPanels.length === boxes('panels').length ? '' : shownPanels.join(',') || 'none', lock: chosen('lock').join(','),
  }, text.value);
}

/** @param {string} file  its text */
function fill(file) {
  const { lesson: { fields }, body } = lessonOf(file.replace(/\r\n?/g, '\n'), 'x.md', new Faults());
  const value = (/** @type {string} */ key) => fields.get(key)?.value ?? '';
  for (const key of ['title', 'open', 'goal', 'minutes']) input(`lesson-${key}`).value = value(key);
  const panels = value('panels').split(',');
  for (const box of boxes('panels')) box.checked = value('panels') === '' || panels.includes(box.value);
  for (const box of boxes('lock')) box.checked = value('lock').split(',').includes(box.value);
  text.value = body.replace(/\n$/, '');
}

const loadPreview = async () => {
  const [engine, response] = await Promise.all([Engine.load(), fetch(new URL('sources.json', import.meta.url))]);
  if (!response.ok) throw new Error(tr('what a lesson may link to could not be loaded'));
  return new Preview(engine, tables, await response.json());
};

function changed() {
  try {
    localStorage.setItem(DRAFT, JSON.stringify({ text: written(), opened }));
  } catch {
    // Without storage the draft lasts until the page is closed.
  }
  clearTimeout(timer);
  timer = setTimeout(() => void show(), REST_MS);
}

const fileName = () => opened || fileOf(input('lesson-title').value);

async function show() {
  const mine = ++round, file = written();
  try {
    preview ??= loadPreview();
    const { html, faults, before } = await (await preview).render(file, fileName());
    if (mine !== round) return;
    article.replaceChildren(...shown(html, new URL('lessons/x.html', import.meta.url).href));
    startQuizzes();
    list.replaceChildren(...faults.map((fault) => faultItem(fault, before, file)));
    find('faults-heading').textContent = faults.length === 0 ? tr('Nothing to correct') : tr('To correct');
    article.dataset.shown = String(mine);
  } catch (error) {
    preview = null;
    state.textContent = tr('The preview could not be made: {1}. Reload the page to try again. Your text is kept.', error instanceof Error ? error.message : String(error));
  }
}

/** Leads to the field, or to the line of the text. @param {import('./preview.mjs').Fault} fault @param {number} before @param {string} file */
function faultItem({ line, sentence }, before, file) {
  const item = document.createElement('li'), button = document.createElement('button');
  const header = line <= before;
  const key = /^(\w+):/.exec(file.split('\n')[line - 1] ?? '')?.[1] ?? KEYS.find((each) => sentence.includes(`"${each}`)) ?? 'title';
  button.type = 'button';
  button.textContent = header ? tr('Above the text: {1}', sentence) : tr('Line {1}: {2}', line - before, sentence);
  button.addEventListener('click', () => {
    if (header) return find(['panels', 'lock'].includes(key) ? 'lesson-title' : `lesson-${key}`).focus();
    const lines = text.value.split('\n'), from = lines.slice(0, line - before - 1).join('\n').length + (line - before > 1 ? 1 : 0);
    text.focus();
    text.setSelectionRange(from, from + (lines[line - before - 1]?.length ?? 0));
    text.scrollTop = (text.scrollHeight * (line - before - 4)) / lines.length;
  });
  item.append(button);
  return item;
}

/** Inserts at the caret. @param {string} words */
function insert(words) {
  text.focus();
  // So that the browser's Undo takes it back, where the browser has this command.
  if (!document.execCommand('insertText', false, words)) text.setRangeText(words, text.selectionStart, text.selectionEnd, 'end');
  changed();
}

/** @param {string} kind @param {() => string | Promise<string>} make  inserts, and returns what is missing */
function inserter(kind, make) {
  find(`${kind}-insert`).addEventListener('click', async () => { find(`${kind}-state`).textContent = await make(); });
}

const value = (/** @type {string} */ id) => /** @type {HTMLInputElement | HTMLTextAreaElement} */ (find(id)).value.trim();

inserter('motion', async () => {
  const link = motionLink(value('motion-link')), words = value('motion-words');
  if (!link) return tr('Paste the whole link, from “Copy link” in the playground.');
  if (!words) return tr('Write the words that the reader sees.');
  try {
    preview ??= loadPreview();
    await (await preview).playground.payloadOf(link.split('#')[1]);
  } catch (error) {
    return tr('This link does not open: {1}', trSentence(error instanceof Error ? error.message : String(error)));
  }
  const { inserted, end } = motion(text.value, link, words, input('motion-strip').checked);
  insert(inserted);
  const at = text.selectionStart;
  text.value = `${text.value.trimEnd()}\n${/^\[motion-\d+\]:.*$/.test(text.value.trimEnd().split('\n').at(-1) ?? '') ? '' : '\n'}${end}\n`;
  text.setSelectionRange(at, at);
  changed();
  return tr('Inserted. Its link is at the end of the text.');
});
inserter('goal', () => {
  const fault = faultOfGoal(value('goal-conditions'), tables);
  if (fault) return trSentence(fault);
  if (!value('goal-words')) return tr('Write the goal in words, too.');
  insert(goal(value('goal-conditions'), value('goal-words')));
  return tr('Inserted.');
});
inserter('predict', () => {
  const answers = value('predict-answers').split('\n').filter((/** @type {string} */ line) => line.trim() !== '');
  if (!value('predict-question') || answers.length === 0) return tr('A prediction has a question, and answers or a slider.');
  insert(prediction(value('predict-question'), answers));
  return tr('Inserted.');
});
inserter('quiz', () => {
  const right = /** @type {HTMLInputElement} */ (document.querySelector('[name=quiz-right]:checked')).value;
  const answers = ['1', '2', '3'].map((i) => ({ answer: value(`quiz-answer-${i}`), why: value(`quiz-why-${i}`), right: i === right })).filter(({ answer }) => answer !== '');
  if (!value('quiz-question') || answers.length < 2 || !answers.some((each) => each.right) || answers.some(({ why }) => why === '')) {
    return tr('A question has two or three answers, each with an explanation, and one is right.');
  }
  insert(quiz(value('quiz-question'), answers));
  return tr('Inserted.');
});
input('goal-conditions').addEventListener('change', () => { find('goal-state').textContent = value('goal-conditions') ? trSentence(faultOfGoal(value('goal-conditions'), tables)) : ''; });
input('lesson-open').addEventListener('change', () => {
  input('lesson-open').value = motionLink(value('lesson-open')) || value('lesson-open');
  changed();
});

for (const field of [find('lesson-title'), find('lesson-minutes'), find('lesson-open'), find('lesson-goal'), find('lesson-panels'), find('lesson-lock'), text]) field.addEventListener('input', changed);
find('lesson-save').addEventListener('click', () => {
  const address = URL.createObjectURL(new Blob([written()], { type: 'text/markdown' }));
  Object.assign(document.createElement('a'), { href: address, download: fileName() }).click();
  setTimeout(() => URL.revokeObjectURL(address), 60000);
  safe = written();
  state.textContent = [`${tr('Saved as {1}', fileName())}.`, list.children.length > 0 && tr('There is something to correct before the book takes it.')].filter(Boolean).join(' ');
});
/** @param {File | undefined} file */
async function openFile(file) {
  if (!file) return;
  if (file.size > MOST_BYTES) {
    state.textContent = tr('This file is too large for a lesson.');
    return;
  }
  const lesson = await file.text();
  if (lessonOf(lesson.replace(/\r\n?/g, '\n'), 'x.md', new Faults()).lesson.fields.size === 0) {
    state.textContent = tr('{1} is not a lesson: it does not begin with a line of three hyphens and a title.', file.name);
    return;
  }
  if (written() !== safe && refused !== file.name) {
    refused = file.name;
    state.textContent = tr('The text here is not saved. Open {1} once more to replace it.', file.name);
    return;
  }
  fill(lesson);
  safe = written();
  opened = /^[a-z0-9-]{1,60}\.md$/.test(file.name) ? file.name : '';
  state.textContent = tr('Opened {1}.', file.name);
  changed();
}
input('lesson-file').addEventListener('change', async ({ target }) => {
  const field = /** @type {HTMLInputElement} */ (target);
  await openFile(field.files?.[0]);
  field.value = '';
});
find('lesson-print').addEventListener('click', () => print());
const clear = find('lesson-clear');
clear.addEventListener('click', () => {
  if (clear.dataset.asked === undefined) {
    clear.dataset.asked = '';
    clear.textContent = tr('Start over: forget this text?');
    return;
  }
  begin('');
  state.textContent = tr('This is a new lesson.');
  changed();
});
clear.addEventListener('blur', forgetQuestion);
function forgetQuestion() {
  delete clear.dataset.asked;
  clear.textContent = tr('Start over');
}

/** @param {string} draft */
function begin(draft) {
  forgetQuestion();
  opened = '';
  refused = '';
  fill(lessonText({ minutes: '10' }, START));
  safe = written();
  if (draft) fill(draft);
}

/** @returns {{text: string, opened: string}} */
function kept() {
  try {
    const { text: draft, opened: name } = JSON.parse(localStorage.getItem(DRAFT) ?? '{}');
    return { text: typeof draft === 'string' ? draft : '', opened: typeof name === 'string' ? name : '' };
  } catch {
    return { text: '', opened: '' };
  }
}
const before = kept();
begin(before.text);
opened = before.opened;
void show();
