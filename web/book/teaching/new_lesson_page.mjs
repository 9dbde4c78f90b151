// SPDX-License-Identifier: MIT
// The page where a lesson is written (new_lesson.js): a form, a text field, and a preview beside it.
import { locks } from '../../share/locks.js';

/** @param {string} name @param {string} legend @param {readonly {name: string}[]} parts @param {boolean} checked */
const choices = (name, legend, parts, checked) => `<fieldset id="lesson-${name}"><legend>${legend}</legend>
${parts.map((part) => `<label><input type="checkbox" value="${part.name}"${checked ? ' checked' : ''}> ${part.name}</label>`).join('\n')}</fieldset>`;

/** @typedef {import('../languages/words.mjs').Language} Language */
/** @typedef {import('../../page/goal_conditions.js').Tables & {panels?: readonly {name: string}[]}} Tables */

/** @param {Tables} tables @param {Language} language @returns {import('../template.mjs').Sheet} */
export const newLessonPage = (tables, language) => ({
  title: language.tr('New lesson'), address: `${language.folder}new-lesson.html`, kind: 'tool writing', engine: true, language,
  description: language.tr('Write a lesson in the browser, with goals, questions and motions, and save it as a file.'),
  styles: ['lesson.css', 'teaching.css'], scripts: ['new_lesson.js'],
  body: bodyOf(tables, language),
});

/** @param {Tables} tables @param {Language} language */
const bodyOf = ({ panels = [] }, { folder, tr }, up = folder && '../') => `<main id="main" tabindex="-1">
<p class="group"><a href="${up}writing-lessons.html" hreflang="en">${tr('Write a lesson of your own')}</a></p>
<h1>${tr('New lesson')}</h1>
<noscript><p>${tr('This page needs JavaScript.')}</p></noscript>
<div class="sides">
<section aria-label="${tr('Write')}">
<p class="row"><button type="button" id="lesson-save" class="primary">${tr('Save')}</button> <label class="button">${tr('Open a file')}<input type="file" id="lesson-file" accept=".md,text/markdown,text/plain"></label>
<button type="button" id="lesson-print" class="bordered">${tr('Print')}</button> <button type="button" id="lesson-clear" class="bordered">${tr('Start over')}</button></p>
<p id="lesson-state" role="status"></p>
<div class="tray">
<p><label for="lesson-title">${tr('Title')}</label> <input type="text" id="lesson-title" maxlength="80" autocomplete="off"></p>
<p><label for="lesson-minutes">${tr('Minutes')}</label> <input type="number" id="lesson-minutes" min="1" max="240" value="10"></p>
<p><label for="lesson-open">${tr('Opened first: paste a link of the playground')}</label> <input type="text" id="lesson-open" autocomplete="off" spellcheck="false" translate="no"></p>
<p><label for="lesson-goal">${tr('Goal that the playground shows from the beginning, if any')}</label> <input type="text" id="lesson-goal" autocomplete="off" spellcheck="false" translate="no" placeholder="travel >= 8"></p>
<details><summary>${tr('Panels and locked parts')}</summary>
${choices('panels', tr('Panels to show'), panels, true)}
${choices('lock', tr('Locked parts'), locks, false)}</details>
</div>
<div class="tray" id="lesson-insert">
<p>${tr('Insert into the text:')}</p>
<details><summary>${tr('A motion')}</summary>
<p><label for="motion-link">${tr('Link of the playground')}</label> <input type="text" id="motion-link" autocomplete="off" spellcheck="false" translate="no"></p>
<p><label for="motion-words">${tr('Words that the reader sees')}</label> <input type="text" id="motion-words" autocomplete="off"></p>
<p><label><input type="checkbox" id="motion-strip"> ${tr('as a picture of its poses, which the words describe')}</label></p>
<p class="row"><button type="button" id="motion-insert" class="bordered">${tr('Insert')}</button> <span id="motion-state" role="status"></span></p></details>
<details><summary>${tr('A goal')}</summary>
<p><label for="goal-conditions">${tr('Conditions, for example {1} ({2})', 'distance &gt;= 8, rotations &gt;= 1', `<a href="${up}embedding.html#conditions-of-a-goal" hreflang="en">${tr('all conditions')}</a>`)}</label> <input type="text" id="goal-conditions" autocomplete="off" spellcheck="false" translate="no"></p>
<p><label for="goal-words">${tr('In words, for your pupils')}</label> <input type="text" id="goal-words" autocomplete="off"></p>
<p class="row"><button type="button" id="goal-insert" class="bordered">${tr('Insert')}</button> <span id="goal-state" role="status"></span></p></details>
<details><summary>${tr('A prediction')}</summary>
<p><label for="predict-question">${tr('Question')}</label> <input type="text" id="predict-question" autocomplete="off"></p>
<p><label for="predict-answers">${tr('Answers, one on each line, or a slider such as 0 to 40 by 1 m')}</label> <textarea id="predict-answers" rows="3"></textarea></p>
<p class="row"><button type="button" id="predict-insert" class="bordered">${tr('Insert')}</button> <span id="predict-state" role="status"></span></p></details>
<details><summary>${tr('A question with answers')}</summary>
<p><label for="quiz-question">${tr('Question')}</label> <input type="text" id="quiz-question" autocomplete="off"></p>
${[1, 2, 3].map((i) => `<div class="answer"><label><input type="radio" name="quiz-right" value="${i}"${i === 1 ? ' checked' : ''}> ${tr('right')}</label>
<input type="text" id="quiz-answer-${i}" aria-label="${tr('Answer {1}', i)}" placeholder="${tr('Answer {1}', i)}" autocomplete="off"> <input type="text" id="quiz-why-${i}" aria-label="${tr('Explanation {1}', i)}" placeholder="${tr('Explanation {1}', i)}" autocomplete="off"></div>`).join('\n')}
<p class="row"><button type="button" id="quiz-insert" class="bordered">${tr('Insert')}</button> <span id="quiz-state" role="status"></span></p></details>
</div>
<p><label for="lesson-text">${tr('The text ({1})', `<a href="${up}writing-lessons.html#in-this-book" hreflang="en">${tr('how it is written')}</a>`)}</label>
<textarea id="lesson-text" rows="24" spellcheck="true"></textarea></p>
</section>
<section aria-label="${tr('Preview')}">
<h2 id="faults-heading">${tr('To correct')}</h2>
<ul id="lesson-faults" aria-live="polite" aria-labelledby="faults-heading"></ul>
<article id="lesson-preview" aria-label="${tr('The lesson')}"></article>
</section>
</div>
</main>`;
