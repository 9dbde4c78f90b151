// SPDX-License-Identifier: MIT
// The page with the eight questions: a round before the lessons, without feedback, and one after them, with feedback. The
// answers are kept in the browser.
import { tr } from '../languages/language.js';
import { emptyWork } from '../share/work.js';
import { startHandIn } from './hand_in.js';
import { QUESTIONS, SET, UNKNOWN } from './questions.js';

/** @typedef {(number | null)[] | null} Round */
/** What is kept. round: the one that is being answered @typedef {{set: string, before: Round, after: Round, round: 'before' | 'after' | '', given: (number | null)[]}} Kept */

const KEY = 'gaitsmith-quiz';
/** @template {HTMLElement} T @param {string} id @param {new () => T} [kind] @returns {T} */
const find = (id, kind = /** @type {any} */ (HTMLElement)) => {
  const found = document.getElementById(id);
  if (!(found instanceof kind)) throw new Error(`no #${id}`);
  return found;
};
const form = find('questions', HTMLFormElement), finish = /** @type {HTMLButtonElement} */ (form.querySelector('[type=submit]'));
const begin = find('round-begin'), other = find('round-after'), forget = find('round-forget'), state = find('round-state');
const fields = /** @type {HTMLFieldSetElement[]} */ ([...form.querySelectorAll('.ask')]);
const none = () => QUESTIONS.map(() => null);

/** @returns {Kept} */
function stored() {
  /** @type {Kept} */
  const nothing = { set: SET, before: null, after: null, round: '', given: none() };
  try {
    const value = JSON.parse(localStorage.getItem(KEY) ?? 'null');
    if (value?.set !== SET) return nothing; // of other questions
    const round = (/** @type {unknown} */ one) => (Array.isArray(one) ? QUESTIONS.map((_, i) => (Number.isInteger(one[i]) ? one[i] : null)) : null);
    return { ...nothing, before: round(value.before), after: round(value.after), round: ['before', 'after'].includes(value.round) ? value.round : '', given: round(value.given) ?? none() };
  } catch {
    return nothing;
  }
}
let kept = stored();

/** @param {Partial<Kept>} change */
function keep(change) {
  kept = { ...kept, ...change };
  try {
    localStorage.setItem(KEY, JSON.stringify(kept));
  } catch {
    // Without storage the answers last until the page is closed.
  }
  show();
}

const right = (/** @type {Round} */ round) => (round ?? []).filter((given, i) => given === QUESTIONS[i].right).length;

function show() {
  const { before, after, round, given } = kept;
  const finished = before !== null || after !== null;
  form.hidden = round === '' && after === null;
  finish.hidden = round === '';
  begin.hidden = round !== '' || after !== null;
  begin.textContent = before === null ? tr('Begin the first round') : tr('Begin the second round');
  other.hidden = round !== '' || finished;
  forget.hidden = !finished && round === '';
  find('hand-in').hidden = !finished || round !== '';
  if (round !== '') state.textContent = round === 'before' ? tr('First round, before the lessons.') : tr('Second round, after the lessons.');
  else if (after !== null) state.textContent = [tr('Both rounds are over.'), before && tr('First round: {1} of {2} right.', right(before), QUESTIONS.length), tr('Second round: {1} of {2} right.', right(after), QUESTIONS.length)].filter(Boolean).join(' ');
  else if (before !== null) state.textContent = tr('The first round is finished. Do the lessons, and come back for the second round. Or hand in the first round now.');
  else state.textContent = tr('The first round comes before the lessons.');
  fields.forEach((field, i) => {
    const chosen = round === '' ? after?.[i] ?? null : given[i];
    for (const input of field.querySelectorAll('input')) {
      input.checked = Number(input.value) === chosen;
      input.disabled = round === '';
    }
    explain(field, i);
  });
}

/** Only after the second round. @param {HTMLElement} field @param {number} i */
function explain(field, i) {
  const box = /** @type {HTMLElement} */ (field.querySelector('.feedback'));
  const { before, after, round } = kept, { answers, right: wanted, why } = QUESTIONS[i];
  box.hidden = round !== '' || after === null;
  if (box.hidden || after === null) return box.replaceChildren();
  const words = (/** @type {number | null} */ given) => (given === null ? tr('no answer') : tr('“{1}”', tr(answers[given] ?? UNKNOWN)));
  box.classList.toggle('right', after[i] === wanted);
  const first = before === null || before[i] === after[i] ? '' : tr('Your first answer was {1}', words(before[i]));
  box.textContent = [after[i] === wanted ? tr('Right.') : tr('Right is {1}', words(wanted)), tr(why), first].filter(Boolean).join(' ');
}

form.addEventListener('change', ({ target }) => {
  if (!(target instanceof HTMLInputElement) || kept.round === '') return;
  const given = [...kept.given];
  given[fields.findIndex((field) => field.contains(target))] = Number(target.value);
  find('round-missing').textContent = '';
  keep({ given });
});
form.addEventListener('submit', (event) => {
  event.preventDefault();
  if (kept.round === '') return;
  const open = kept.given.indexOf(null);
  if (open >= 0) {
    find('round-missing').textContent = tr('Question {1} has no answer. “{2}” is an answer, too.', open + 1, tr(UNKNOWN));
    fields[open].querySelector('input')?.focus();
    return;
  }
  keep({ [kept.round]: kept.given, round: '', given: none() });
  find('rounds').scrollIntoView();
  (begin.hidden ? find('main') : begin).focus();
});
/** @param {'before' | 'after'} round */
function start(round) {
  keep({ round, given: none() });
  fields[0].querySelector('input')?.focus();
}
begin.addEventListener('click', () => start(kept.before === null ? 'before' : 'after'));
other.addEventListener('click', () => start('after'));
forget.addEventListener('click', () => {
  if (forget.dataset.asked === undefined) {
    forget.dataset.asked = '';
    forget.textContent = tr('Forget both rounds?');
    return;
  }
  unask();
  keep({ before: null, after: null, round: '', given: none() });
  begin.focus();
});
forget.addEventListener('blur', unask);
function unask() {
  delete forget.dataset.asked;
  forget.textContent = tr('Forget my answers');
}

find('rounds').hidden = false;
show();
startHandIn('before-and-after', () => Promise.resolve({ ...emptyWork(), quiz: { set: SET, before: kept.before, after: kept.after } }),
  () => (kept.before !== null && kept.after !== null ? tr('Both rounds are in it.') : kept.before === null ? tr('Only the second round is in it.') : tr('Only the first round is in it.')));
