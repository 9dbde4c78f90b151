// SPDX-License-Identifier: MIT
// What a student hands in: a motion, and what was predicted, answered and written. Travels as the part of a link after
// '#', or as a file.
//
//   #H1.<payload of the motion's link, may be empty>.<base64url of JSON>
//   #H2.….…  the same with the answers of the quiz before and after the lessons
//
// Its errors are English. Pages translate them with trSentence.
import { trLater } from '../languages/language.js';

/** Choices and sliders in their order in the lesson; null: not given. */
/**
 * @typedef {object} Work
 * @property {string} lesson               name of its file, such as '1-a-rule'; '': a motion without a lesson
 * @property {(number | null)[]} predictions  number of the choice, or the slider's value
 * @property {(number | null)[]} answers   number of the choice
 * @property {string} text                 what was written under Explain
 * @property {string} name                 only if typed
 * @property {string} motion               payload of its link; '': none
 * @property {Quiz | null} quiz            only in the second form
 */
/**
 * Answers before and after the lessons, by their number; one more than the last: "I do not know"; a list is null until its round
 * is finished, and one of them is not. set: of the questions (web/classroom/questions.js)
 * @typedef {{set: string, before: (number | null)[] | null, after: (number | null)[] | null}} Quiz
 */

/** The form that older pages read, and the one with a quiz. */
const MARKS = { plain: 'H1', quiz: 'H2' };
const FORMS = { plain: 1, quiz: 2 };
const MOST = { predictions: 20, answers: 40, text: 4000, name: 80, data: 40000, motion: 200000, quiz: 40 };

/** @returns {Work} */
export const emptyWork = () => ({ lesson: '', predictions: [], answers: [], text: '', name: '', motion: '', quiz: null });

/** The part of its link after '#'. @param {Work} work */
export function encodeWork({ motion, ...rest }) {
  return `${MARKS[formOf(rest)]}.${motion}.${toBase64url(new TextEncoder().encode(JSON.stringify(parts(rest))))}`;
}

/** @param {{quiz: Quiz | null}} work */
const formOf = ({ quiz }) => (quiz ? 'quiz' : 'plain');

/** Without a quiz that is not there, as in the first form. @template {{quiz: Quiz | null}} T @param {T} work */
const parts = ({ quiz, ...rest }) => (quiz ? { ...rest, quiz } : rest);

/** The text of its file. @param {Work} work */
export const workFile = (work) => `${JSON.stringify({ gaitsmith_work: FORMS[formOf(work)], ...parts(work) }, null, 1)}\n`;

/** @param {string} fragment  without '#' @returns {Work} throws an Error with a sentence */
export function decodeWork(fragment) {
  const [mark, motion = '', data, ...more] = fragment.split('.');
  if (!/^H\d+$/.test(mark)) throw new Error(trLater('This is not work that was handed in.'));
  const form = mark === MARKS.plain ? 'plain' : 'quiz';
  if (mark !== MARKS[form]) throw new Error(trLater('This work comes from a newer version of Gaitsmith.'));
  if (data === undefined || data === '' || more.length > 0) throw new Error(trLater('The link is cut off or has something added.'));
  if (data.length > MOST.data) throw new Error(trLater('The link is too long.'));
  return checked({ ...objectIn(utf8(fromBase64url(data))), motion }, form);
}

/** Whether a file's text is meant to be work. @param {string} text */
export const isWorkFile = (text) => /^\s*\{\s*"gaitsmith_work"/.test(text);

/** @param {string} text @returns {Work} throws an Error with a sentence */
export function readWorkFile(text) {
  if (text.length > MOST.data + MOST.motion) throw new Error(trLater('The file is too long.'));
  const { gaitsmith_work: version, ...work } = objectIn(text);
  const form = version === FORMS.plain ? 'plain' : 'quiz';
  if (version !== FORMS[form]) throw new Error(trLater('This file comes from a newer version of Gaitsmith.'));
  return checked(work, form);
}

/** @param {string} text @returns {Record<string, unknown>} */
function objectIn(text) {
  /** @type {unknown} */
  let value;
  try {
    value = JSON.parse(text);
  } catch {
    throw new Error(trLater('Some characters are damaged or missing.'));
  }
  if (value === null || typeof value !== 'object' || Array.isArray(value)) throw new Error(trLater('Some characters are damaged or missing.'));
  return /** @type {Record<string, unknown>} */ (value);
}

/** @param {Record<string, unknown>} value @param {keyof typeof FORMS} form @returns {Work} */
function checked(value, form) {
  const { lesson, predictions, answers, text, name, motion, quiz, ...others } = value;
  const [stranger] = [...Object.keys(others), ...form === 'plain' && quiz !== undefined ? ['quiz'] : []];
  if (stranger !== undefined) throw new Error(`${trLater('The work has a part that is not known here')}: “${stranger.slice(0, 40)}”.`);
  const fault = (/** @type {string} */ what) => new Error(`${trLater('The work is damaged')}: ${what}`);
  if (typeof lesson !== 'string' || !/^[a-z0-9-]{0,60}$/.test(lesson)) throw fault(trLater('“lesson” is not a lesson’s name.'));
  const list = (/** @type {unknown} */ values, /** @type {'predictions' | 'answers'} */ key, /** @type {(number: number) => boolean} */ fits) => {
    if (!Array.isArray(values) || values.length > MOST[key] || !values.every((each) => each === null || (typeof each === 'number' && fits(each)))) throw fault(key === 'answers' ? trLater('“answers” is not a list of numbers.') : trLater('“predictions” is not a list of numbers.'));
    return /** @type {(number | null)[]} */ (values);
  };
  const words = (/** @type {unknown} */ given, /** @type {'text' | 'name'} */ key) => {
    if (typeof given !== 'string' || given.length > MOST[key]) throw fault((key === 'text' ? trLater('“text” is not a text of at most {1} characters.') : trLater('“name” is not a text of at most {1} characters.')).replace('{1}', String(MOST[key])));
    return given;
  };
  if (typeof motion !== 'string' || motion.length > MOST.motion || !/^[\w-]*$/.test(motion)) throw fault(trLater('its motion has characters that no link has.'));
  return {
    lesson, motion,
    predictions: list(predictions, 'predictions', Number.isFinite),
    answers: list(answers, 'answers', (number) => Number.isInteger(number) && number >= 0 && number < 100),
    text: words(text, 'text'),
    name: words(name, 'name'),
    quiz: form === 'quiz' ? checkedQuiz(quiz) : null,
  };
}

/** @param {unknown} value @returns {Quiz} */
function checkedQuiz(value) {
  const fault = new Error(`${trLater('The work is damaged')}: ${trLater('“quiz” is not the answers of a quiz.')}`);
  if (value === null || typeof value !== 'object') throw fault;
  const { set, before, after, ...others } = /** @type {Record<string, unknown>} */ (value);
  const isRound = (/** @type {unknown} */ round) => round === null || (Array.isArray(round) && round.length <= MOST.quiz
    && round.every((each) => each === null || (Number.isInteger(each) && each >= 0 && each < 100)));
  if (typeof set !== 'string' || !/^[a-z0-9]{1,8}$/.test(set) || !isRound(before) || !isRound(after) || (before === null && after === null) || Object.keys(others).length > 0) throw fault;
  return /** @type {Quiz} */ ({ set, before, after });
}

/** @param {Uint8Array} bytes */
function toBase64url(bytes) {
  return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join('')).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
}

/** @param {string} text */
function fromBase64url(text) {
  try {
    if (!/^[\w-]*$/.test(text)) throw new Error('no base64url');
    return Uint8Array.from(atob(text.replaceAll('-', '+').replaceAll('_', '/')), (letter) => letter.charCodeAt(0));
  } catch {
    throw new Error(trLater('Some characters are damaged or missing.'));
  }
}

/** @param {Uint8Array} bytes */
function utf8(bytes) {
  try {
    return new TextDecoder('utf-8', { fatal: true }).decode(bytes);
  } catch {
    throw new Error(trLater('Some characters are damaged or missing.'));
  }
}
