// SPDX-License-Identifier: MIT
// The page where a teacher collects a class's work (web/classroom/wall.js).

/** @returns {import('./template.mjs').Sheet} */
export const wallPage = () => ({
  title: 'The wall', address: 'wall.html', kind: 'wall', engine: true,
  description: 'Collect the work of a class: every motion is simulated again and compared with its goal.',
  styles: ['wall.css'], scripts: ['../classroom/wall.js'],
  body: `<main id="main" tabindex="-1">
<h1>The wall</h1>
<p class="hook">Collect the work of a class. Every motion is simulated again here and compared with its goal. Nothing leaves this computer, and
nothing is stored: print the wall or save it as a table before you close the page.</p>
<section class="tray" aria-label="Add work">
<label for="wall-text">Paste the links, one on each line. A name before a link is kept.</label>
<textarea id="wall-text" rows="5" spellcheck="false" translate="no" placeholder="Anna: https://…#H1…"></textarea>
<div class="row">
<button id="wall-add" type="button" class="primary">Add to the wall</button>
<label class="button">Choose files<input id="wall-files" type="file" multiple accept=".json,.txt,text/plain,application/json"></label>
<span>or drop them anywhere</span>
</div>
<details>
<summary>A goal for motions without a lesson</summary>
<label for="wall-goal">Conditions, as in an address (<a href="embedding.html">embedding</a>)</label>
<input id="wall-goal" type="text" spellcheck="false" autocomplete="off" translate="no" placeholder="distance >= 8, rotations >= 1">
</details>
<p id="wall-state" role="status"></p>
</section>
<section id="wall-results" hidden aria-label="The class’s work">
<div class="row tools">
<label for="wall-order">Order</label>
<select id="wall-order"><option value="arrival">as they came</option><option value="name">by name</option><option value="lesson">by lesson</option><option value="goal">goal reached first</option></select>
<button id="wall-show" type="button" class="bordered">Class gallery</button>
<button id="wall-print" type="button" class="bordered">Print</button>
<button id="wall-csv" type="button" class="bordered">Save as CSV</button>
<button id="wall-clear" type="button" class="bordered">Clear</button>
</div>
<section class="scroll" tabindex="0" aria-label="Table">
<table id="wall-table">
<thead><tr><td></td><th scope="col">Name</th><th scope="col">Motion</th><th scope="col">Goal</th><th scope="col">Look at this</th><th scope="col">Written</th></tr></thead>
<tbody></tbody>
</table>
</section>
<h2>Answers side by side</h2>
<div id="wall-answers"></div>
<h2>In their own words</h2>
<div id="wall-sentences"></div>
</section>
<section id="wall-quiz" hidden aria-labelledby="wall-quiz-heading">
<h2 id="wall-quiz-heading">Before and after</h2>
<p></p>
<div class="row tools"><button id="wall-quiz-csv" type="button" class="bordered">Save as CSV</button></div>
<section class="scroll" tabindex="0" aria-label="Table of the questions">
<table>
<thead><tr><th scope="col">Question</th><th scope="col">Right before</th><th scope="col">Right after</th><th scope="col">Right only after</th><th scope="col">Right only before</th><th scope="col">Right both times</th><th scope="col">Never right</th></tr></thead>
<tbody></tbody>
</table>
</section>
</section>
<dialog id="wall-gallery" aria-label="Class gallery">
<div class="row"><label><input type="checkbox"> Show names</label> <button type="button" class="bordered">Close</button></div>
<ul></ul>
</dialog>
</main>`,
});
