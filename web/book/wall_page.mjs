// SPDX-License-Identifier: MIT
// The page where a teacher collects a class's work (web/classroom/wall.js).

/** @param {import('./languages/words.mjs').Language} language @returns {import('./template.mjs').Sheet} */
export const wallPage = (language) => ({
  title: language.tr('The wall'), address: `${language.folder}wall.html`, kind: 'wall', engine: true, language,
  description: language.tr('Collect the work of a class: every motion is simulated again and compared with its goal.'),
  styles: ['wall.css'], scripts: ['../classroom/wall.js'],
  body: bodyOf(language),
});

/** @param {import('./languages/words.mjs').Language} language */
const bodyOf = ({ folder, tr }) => `<main id="main" tabindex="-1">
<h1>${tr('The wall')}</h1>
<p class="hook">${tr('Collect the work of a class. Every motion is simulated again here and compared with its goal. Nothing leaves this computer, and nothing is stored: print the wall or save it as a table before you close the page.')}</p>
<section class="tray" aria-label="${tr('Add work')}">
<label for="wall-text">${tr('Paste the links, one on each line. A name before a link is kept.')}</label>
<textarea id="wall-text" rows="5" spellcheck="false" translate="no" placeholder="Anna: https://…#H1…"></textarea>
<div class="row">
<button id="wall-add" type="button" class="primary">${tr('Add to the wall')}</button>
<label class="button">${tr('Choose files')}<input id="wall-files" type="file" multiple accept=".json,.txt,text/plain,application/json"></label>
<span>${tr('or drop them anywhere')}</span>
</div>
<details>
<summary>${tr('A goal for motions without a lesson')}</summary>
<label for="wall-goal">${tr('Conditions, as in an address ({1})', `<a href="${folder && '../'}embedding.html" hreflang="en">${tr('embedding')}</a>`)}</label>
<input id="wall-goal" type="text" spellcheck="false" autocomplete="off" translate="no" placeholder="distance >= 8, rotations >= 1">
</details>
<p id="wall-state" role="status"></p>
</section>
<section id="wall-results" hidden aria-label="${tr('The class’s work')}">
<div class="row tools">
<label for="wall-order">${tr('Order')}</label>
<select id="wall-order"><option value="arrival">${tr('as they came')}</option><option value="name">${tr('by name')}</option><option value="lesson">${tr('by lesson')}</option><option value="goal">${tr('goal reached first')}</option></select>
<button id="wall-show" type="button" class="bordered">${tr('Class gallery')}</button>
<button id="wall-print" type="button" class="bordered">${tr('Print')}</button>
<button id="wall-csv" type="button" class="bordered">${tr('Save as CSV')}</button>
<button id="wall-clear" type="button" class="bordered">${tr('Clear')}</button>
</div>
<section class="scroll" tabindex="0" aria-label="${tr('Table')}">
<table id="wall-table">
<thead><tr><td></td><th scope="col">${tr('Name')}</th><th scope="col">${tr('Motion')}</th><th scope="col">${tr('Goal')}</th><th scope="col">${tr('Look at this')}</th><th scope="col">${tr('Written')}</th></tr></thead>
<tbody></tbody>
</table>
</section>
<h2>${tr('Answers side by side')}</h2>
<div id="wall-answers"></div>
<h2>${tr('In their own words')}</h2>
<div id="wall-sentences"></div>
</section>
<section id="wall-quiz" hidden aria-labelledby="wall-quiz-heading">
<h2 id="wall-quiz-heading">${tr('Before and after')}</h2>
<p></p>
<div class="row tools"><button id="wall-quiz-csv" type="button" class="bordered">${tr('Save as CSV')}</button></div>
<section class="scroll" tabindex="0" aria-label="${tr('Table of the questions')}">
<table>
<thead><tr><th scope="col">${tr('Question')}</th><th scope="col">${tr('Right before')}</th><th scope="col">${tr('Right after')}</th><th scope="col">${tr('Right only after')}</th><th scope="col">${tr('Right only before')}</th><th scope="col">${tr('Right both times')}</th><th scope="col">${tr('Never right')}</th></tr></thead>
<tbody></tbody>
</table>
</section>
</section>
<dialog id="wall-gallery" aria-label="${tr('Class gallery')}">
<div class="row"><label><input type="checkbox"> ${tr('Show names')}</label> <button type="button" class="bordered">${tr('Close')}</button></div>
<ul></ul>
</dialog>
</main>`;
