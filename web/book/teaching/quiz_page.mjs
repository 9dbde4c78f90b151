// SPDX-License-Identifier: MIT
// The page with the eight questions that a class answers before and after the lessons (web/classroom/before_after.js).
import { escaped } from '../html.mjs';
import { QUESTIONS, UNKNOWN } from '../../classroom/questions.js';
import { handIn } from './hand_in.mjs';

/** @typedef {import('../languages/words.mjs').Language} Language */

/** @param {import('../../classroom/questions.js').Asked} asked @param {number} i @param {Language} language */
const asked = ({ question, answers }, i, { tr }) => `<fieldset class="ask" id="ask-${i + 1}">
<legend>${i + 1}. ${escaped(tr(question))}</legend>
${[...answers, UNKNOWN].map((words, k) => `<p><input type="radio" name="ask-${i + 1}" id="ask-${i + 1}-${k}" value="${k}"> <label for="ask-${i + 1}-${k}">${escaped(tr(words))}</label></p>`).join('\n')}
<div class="feedback" hidden></div>
</fieldset>`;

/** @param {Language} language @returns {import('../template.mjs').Sheet} */
export const quizPage = (language) => ({
  title: language.tr('Before and after'), address: `${language.folder}quiz.html`, kind: 'tool questions', language,
  description: language.tr('Eight questions, answered before the lessons and again after them.'),
  styles: ['lesson.css', 'teaching.css'], scripts: ['../classroom/before_after.js'],
  body: bodyOf(language),
});

/** @param {Language} language */
const bodyOf = (language, { tr } = language) => `<main id="main" tabindex="-1">
<p class="group"><a href="teachers.html#before-and-after">${tr('For teachers')}</a></p>
<h1>${tr('Before and after')}</h1>
<p class="hook">${tr('Eight questions, answered once before the lessons and once after them. This is no test that counts: it shows your class what has changed. Answer alone. If you do not know an answer, say so. Your answers stay in this browser until you hand them in.')}</p>
<noscript><p>${tr('Keeping the answers needs JavaScript. The questions can be printed.')}</p></noscript>
<div id="rounds" class="tray" hidden>
<p id="round-state" role="status"></p>
<p class="row"><button type="button" id="round-begin" class="primary">${tr('Begin the first round')}</button> <button type="button" id="round-after" class="bordered">${tr('I have done the first round on another computer')}</button>
<button type="button" id="round-forget" class="bordered" hidden>${tr('Forget my answers')}</button></p>
</div>
<form id="questions">
${QUESTIONS.map((each, i) => asked(each, i, language)).join('\n')}
<p class="row"><button type="submit" class="primary" hidden>${tr('Finish this round')}</button> <span id="round-missing" role="status"></span></p>
</form>
${handIn(language, tr('One link holds your answers of the rounds that you have finished. It is not sent: give it to your teacher as you usually do.'))}
</main>`;
