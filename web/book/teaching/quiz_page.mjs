// SPDX-License-Identifier: MIT
// The page with the eight questions that a class answers before and after the lessons (web/classroom/before_after.js).
import { escaped } from '../html.mjs';
import { QUESTIONS, UNKNOWN } from '../../classroom/questions.js';
import { handIn } from './hand_in.mjs';

/** @param {import('../../classroom/questions.js').Asked} asked @param {number} i */
const asked = ({ question, answers }, i) => `<fieldset class="ask" id="ask-${i + 1}">
<legend>${i + 1}. ${escaped(question)}</legend>
${[...answers, UNKNOWN].map((words, k) => `<p><input type="radio" name="ask-${i + 1}" id="ask-${i + 1}-${k}" value="${k}"> <label for="ask-${i + 1}-${k}">${escaped(words)}</label></p>`).join('\n')}
<div class="feedback" hidden></div>
</fieldset>`;

/** @returns {import('../template.mjs').Sheet} */
export const quizPage = () => ({
  title: 'Before and after', address: 'quiz.html', kind: 'tool questions',
  description: 'Eight questions, answered before the lessons and again after them.',
  styles: ['lesson.css', 'teaching.css'], scripts: ['../classroom/before_after.js'],
  body: `<main id="main" tabindex="-1">
<p class="group"><a href="teachers.html#before-and-after">For teachers</a></p>
<h1>Before and after</h1>
<p class="hook">Eight questions, answered once before the lessons and once after them. This is no test that counts: it shows your class what has changed.
Answer alone. If you do not know an answer, say so. Your answers stay in this browser until you hand them in.</p>
<noscript><p>Keeping the answers needs JavaScript. The questions can be printed.</p></noscript>
<div id="rounds" class="tray" hidden>
<p id="round-state" role="status"></p>
<p class="row"><button type="button" id="round-begin" class="primary">Begin</button> <button type="button" id="round-after" class="bordered">I have done the first round on another computer</button>
<button type="button" id="round-forget" class="bordered" hidden>Forget my answers</button></p>
</div>
<form id="questions">
${QUESTIONS.map(asked).join('\n')}
<p class="row"><button type="submit" class="primary" hidden>Finish this round</button> <span id="round-missing" role="status"></span></p>
</form>
${handIn('One link holds your answers of the rounds that you have finished.')}
</main>`,
});
