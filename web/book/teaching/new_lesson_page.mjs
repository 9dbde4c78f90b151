// SPDX-License-Identifier: MIT
// The page where a lesson is written (new_lesson.js): a form, a text field, and a preview beside it.
import { locks } from '../../share/locks.js';

const HINT = 'Opened first: paste a link of the playground';

/** @param {string} name @param {string} legend @param {readonly {name: string}[]} parts @param {boolean} checked */
const choices = (name, legend, parts, checked) => `<fieldset id="lesson-${name}"><legend>${legend}</legend>
${parts.map((part) => `<label><input type="checkbox" value="${part.name}"${checked ? ' checked' : ''}> ${part.name}</label>`).join('\n')}</fieldset>`;

/** @param {import('../../page/goal_conditions.js').Tables & {panels?: readonly {name: string}[]}} tables @returns {import('../template.mjs').Sheet} */
export const newLessonPage = ({ panels = [] }) => ({
  title: 'New lesson', address: 'new-lesson.html', kind: 'tool writing', engine: true,
  description: 'Write a lesson in the browser, with goals, questions and motions, and save it as a file.',
  styles: ['lesson.css', 'teaching.css'], scripts: ['new_lesson.js'],
  body: `<main id="main" tabindex="-1">
<p class="group"><a href="writing-lessons.html">Write a lesson of your own</a></p>
<h1>New lesson</h1>
<noscript><p>This page needs JavaScript.</p></noscript>
<div class="sides">
<section aria-label="Write">
<p class="row"><button type="button" id="lesson-save" class="primary">Save</button> <label class="button">Open a file<input type="file" id="lesson-file" accept=".md,text/markdown,text/plain"></label>
<button type="button" id="lesson-print" class="bordered">Print</button> <button type="button" id="lesson-clear" class="bordered">Start over</button></p>
<p id="lesson-state" role="status"></p>
<div class="tray">
<p><label for="lesson-title">Title</label> <input type="text" id="lesson-title" maxlength="80" autocomplete="off"></p>
<p><label for="lesson-minutes">Minutes</label> <input type="number" id="lesson-minutes" min="1" max="240" value="10"></p>
<p><label for="lesson-open">${HINT}</label> <input type="text" id="lesson-open" autocomplete="off" spellcheck="false" translate="no"></p>
<p><label for="lesson-goal">Goal that the playground shows from the beginning, if any</label> <input type="text" id="lesson-goal" autocomplete="off" spellcheck="false" translate="no" placeholder="travel >= 8"></p>
<details><summary>Panels and locked parts</summary>
${choices('panels', 'Panels to show', panels, true)}
${choices('lock', 'Locked parts', locks, false)}</details>
</div>
<div class="tray" id="lesson-insert">
<p>Insert into the text:</p>
<details><summary>A motion</summary>
<p><label for="motion-link">Link of the playground</label> <input type="text" id="motion-link" autocomplete="off" spellcheck="false" translate="no"></p>
<p><label for="motion-words">Words that the reader sees</label> <input type="text" id="motion-words" autocomplete="off"></p>
<p><label><input type="checkbox" id="motion-strip"> as a picture of its poses, which the words describe</label></p>
<p class="row"><button type="button" id="motion-insert" class="bordered">Insert</button> <span id="motion-state" role="status"></span></p></details>
<details><summary>A goal</summary>
<p><label for="goal-conditions">Conditions, for example distance &gt;= 8, rotations &gt;= 1 (<a href="embedding.html#conditions-of-a-goal">all conditions</a>)</label> <input type="text" id="goal-conditions" autocomplete="off" spellcheck="false" translate="no"></p>
<p><label for="goal-words">In words, for your pupils</label> <input type="text" id="goal-words" autocomplete="off"></p>
<p class="row"><button type="button" id="goal-insert" class="bordered">Insert</button> <span id="goal-state" role="status"></span></p></details>
<details><summary>A prediction</summary>
<p><label for="predict-question">Question</label> <input type="text" id="predict-question" autocomplete="off"></p>
<p><label for="predict-answers">Answers, one on each line, or a slider such as 0 to 40 by 1 m</label> <textarea id="predict-answers" rows="3"></textarea></p>
<p class="row"><button type="button" id="predict-insert" class="bordered">Insert</button> <span id="predict-state" role="status"></span></p></details>
<details><summary>A question with answers</summary>
<p><label for="quiz-question">Question</label> <input type="text" id="quiz-question" autocomplete="off"></p>
${[1, 2, 3].map((i) => `<div class="answer"><label><input type="radio" name="quiz-right" value="${i}"${i === 1 ? ' checked' : ''}> right</label>
<input type="text" id="quiz-answer-${i}" aria-label="Answer ${i}" placeholder="Answer ${i}" autocomplete="off"> <input type="text" id="quiz-why-${i}" aria-label="Explanation ${i}" placeholder="Explanation ${i}" autocomplete="off"></div>`).join('\n')}
<p class="row"><button type="button" id="quiz-insert" class="bordered">Insert</button> <span id="quiz-state" role="status"></span></p></details>
</div>
<p><label for="lesson-text">The text (<a href="writing-lessons.html#in-this-book">how it is written</a>)</label>
<textarea id="lesson-text" rows="24" spellcheck="true"></textarea></p>
</section>
<section aria-label="Preview">
<h2 id="faults-heading">To correct</h2>
<ul id="lesson-faults" aria-live="polite" aria-labelledby="faults-heading"></ul>
<article id="lesson-preview" aria-label="The lesson"></article>
</section>
</div>
</main>`,
});
