// SPDX-License-Identifier: MIT
// A lesson's page. Its links open documents in the playground beside the text, its buttons control the playground, and
// the playground checks its goals.
import { Player } from './player.js';
import { keepAnswers } from '../classroom/kept_answers.js';
import { startLessonHandIn } from '../classroom/hand_in.js';
import { holdNotice } from '../classroom/notice.js';
import { startReport } from '../classroom/report.js';
import { storeProgress, progressOf } from '../classroom/progress.js';
import { tr, trLater, trSentence } from '../languages/language.js';
import { startQuizzes } from './quiz.js';

const GOAL_STATES = { '': '', set: trLater('The playground watches for it.'), met: trLater('Reached.') };
trLater('the playground does not answer'); // player.js says so, and is copied by others: it has no languages

const lesson = document.querySelector('main')?.dataset.lesson ?? '';
const frame = /** @type {HTMLIFrameElement} */ (document.getElementById('playground'));
const fold = /** @type {HTMLButtonElement} */ (document.getElementById('fold'));
const enlarge = /** @type {HTMLButtonElement} */ (document.getElementById('enlarge'));
const done = /** @type {HTMLInputElement} */ (document.getElementById('done'));
const links = /** @type {HTMLAnchorElement[]} */ ([...document.querySelectorAll('a[data-open]')]);
const goals = /** @type {HTMLElement[]} */ ([...document.querySelectorAll('.goal')]);
const player = new Player(frame);
/** The goal that the playground checks. */
let watched = frame.dataset.goal;
startReport(lesson);
/** Call when a goal is reached. */
const showNotice = holdNotice(lesson);
/** The panels that the playground shows if there is room. */
let panels = frame.dataset.panels ?? 'all';
// As in lesson.css: half a small screen has room only for the stage.
const small = matchMedia('(max-width: 56em)');

/** The sentence for a failed call. @param {unknown} error */
const sentence = (error) => tr('That did not work: {1}', trSentence(error instanceof Error ? error.message : String(error)));

/** Marks the link whose document is open in the playground. @param {string | undefined} payload */
function markOpen(payload) {
  for (const link of links) {
    if (link.dataset.open === payload) link.setAttribute('aria-current', 'true');
    else link.removeAttribute('aria-current');
  }
}

/** @param {boolean} shown */
function showPlayground(shown) {
  document.body.classList.toggle('folded', !shown);
  fold.setAttribute('aria-expanded', String(shown));
  fold.textContent = shown ? tr('Hide the playground') : tr('Show the playground');
}

/** @param {{panels?: string, lock?: string, goal?: string}} wanted  undefined values change nothing */
function arrange(wanted) {
  panels = wanted.panels ?? panels;
  watched = wanted.goal ?? watched;
  const room = !small.matches || document.body.classList.contains('enlarged');
  const options = Object.entries({ ...wanted, panels: room ? panels : 'none' }).filter(([, value]) => value !== undefined);
  return player.call('arrange', Object.fromEntries(options));
}

/** The payload of the shown motion's link. @returns {Promise<string>} */
const motionNow = async () => String(await player.call('link')).split('#')[1] ?? '';

/** Call when the room for panels has changed. */
const arrangePanels = () => arrange({}).catch(() => {});

/** @param {HTMLAnchorElement} link */
async function follow(link) {
  showPlayground(true);
  try {
    await player.call('open', link.dataset.open);
    const { panels: shown, lock, goal } = link.dataset;
    if (shown ?? lock ?? goal) await arrange({ panels: shown, lock, goal });
    markOpen(link.dataset.open);
  } catch {
    location.href = link.href; // the playground shows the error
  }
}

/** @param {HTMLElement} box @param {keyof typeof GOAL_STATES} state */
function showGoal(box, state) {
  const words = box.querySelector('.state');
  box.classList.toggle('met', state === 'met');
  const text = GOAL_STATES[state] && tr(GOAL_STATES[state]);
  if (words && words.textContent !== text) words.textContent = text;
}

/** @param {HTMLElement} box @param {boolean} met */
function updateGoal(box, met) {
  const goal = box.dataset.goal ?? '';
  if (!met && box.classList.contains('met')) return; // a goal stays reached
  showGoal(box, met ? 'met' : 'set');
  if (!met) return;
  storeProgress(lesson, { goals: [...new Set([...progressOf(lesson).goals, goal])] });
  showNotice();
  void motionNow().then((motion) => storeProgress(lesson, { motion }), () => {});
}

/** Makes the playground check this goal instead of any other. @param {HTMLElement} box */
async function setGoal(box) {
  for (const other of goals) if (other !== box && !other.classList.contains('met')) showGoal(other, '');
  try {
    await arrange({ goal: box.dataset.goal });
    if (!box.classList.contains('met')) showGoal(box, 'set');
  } catch (error) {
    const words = box.querySelector('.state');
    if (words) words.textContent = sentence(error);
  }
}

/** @param {HTMLButtonElement} button @param {HTMLElement} state */
async function runButton(button, state) {
  const { call = '', args = '[]' } = button.dataset;
  if (button.getAttribute('aria-disabled') === 'true') return;
  showPlayground(true);
  button.setAttribute('aria-disabled', 'true'); // not `disabled`, because a disabled button loses the focus
  state.textContent = tr('Working …');
  try {
    const [first, ...others] = JSON.parse(args);
    const answer = await (call === 'arrange' ? arrange(first) : player.call(call, first, ...others));
    if (call === 'open') markOpen(first);
    state.textContent = call === 'run' && answer === false ? tr('That is not possible now.') : tr('Done.');
  } catch (error) {
    state.textContent = sentence(error);
  }
  button.removeAttribute('aria-disabled');
}

for (const link of links) {
  link.addEventListener('click', (event) => {
    if (event.ctrlKey || event.metaKey || event.shiftKey || event.altKey) return; // opens a new tab or window
    event.preventDefault();
    void follow(link);
  });
}

for (const box of goals) {
  const button = /** @type {HTMLButtonElement} */ (box.querySelector('button'));
  button.hidden = false;
  if (progressOf(lesson).goals.includes(box.dataset.goal ?? '')) showGoal(box, 'met');
  button.addEventListener('click', () => {
    showPlayground(true);
    void setGoal(box);
  });
}

for (const button of document.querySelectorAll('button[data-call]')) {
  const state = button.parentElement?.querySelector('.state');
  if (!(button instanceof HTMLButtonElement && state instanceof HTMLElement)) continue;
  button.disabled = false;
  button.addEventListener('click', () => runButton(button, state));
}

player.addEventListener('goal', (event) => {
  const { goal, met } = /** @type {import('./player.js').PlayerEvent} */ (event).detail;
  for (const box of goals) if (box.dataset.goal === goal) updateGoal(box, met);
});
// After every load of the playground. Its events about the goal in its address came before it knew this page.
player.addEventListener('ready', () => {
  const box = goals.find(({ dataset }) => dataset.goal === watched);
  if (box) void setGoal(box);
  else if (small.matches) void arrangePanels();
});
small.addEventListener('change', arrangePanels);

/** @type {HTMLElement} */ (document.getElementById('shelf')).hidden = false;
fold.addEventListener('click', () => showPlayground(document.body.classList.contains('folded')));
enlarge.addEventListener('click', () => {
  enlarge.setAttribute('aria-pressed', String(document.body.classList.toggle('enlarged')));
  void arrangePanels();
});
done.disabled = false;
done.checked = progressOf(lesson).done;
done.addEventListener('change', () => storeProgress(lesson, { done: done.checked }));
markOpen(frame.dataset.open);
startQuizzes();
keepAnswers(lesson); // after the quizzes: what was answered shows its explanation again
startLessonHandIn(lesson, motionNow);
