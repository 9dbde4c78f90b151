// SPDX-License-Identifier: MIT
// The page of a lesson: text, and the playground beside it.
import { attributes, escaped } from './html.mjs';
import { faultOfGoal } from '../page/goal_conditions.js';
import { LESSONS } from './contents.mjs';
import { handIn } from './teaching/hand_in.mjs';
import { playgroundAddress } from './playground.mjs';
import { upFrom } from './template.mjs';

/** @typedef {import('./links.mjs').Links} Links */
/** @typedef {import('./markdown.mjs').Rendered} Rendered */
/** @typedef {import('./pages.mjs').Lesson} Lesson */
/** @typedef {import('./pages.mjs').Page & {lesson: Lesson}} LessonPage */

/**
 * @param {LessonPage} page @param {Rendered} rendered @param {LessonPage[]} all  lessons, in order @param {Links} links
 * @returns {Promise<import('./template.mjs').Sheet>}
 */
export async function lessonPage(page, { html, sentence }, all, links) {
  const { number, title, minutes, fields } = page.lesson;
  const at = all.indexOf(page);
  const open = fields.get('open');
  const { opens } = open ? await links.resolve(page, open.line, open.value) : { opens: undefined };
  if (open && !opens) links.faults.add(page.source, open.line, '"open" names a document of examples');
  const goal = fields.get('goal');
  const fault = goal && faultOfGoal(goal.value, links.playground.tables);
  if (fault) links.faults.add(page.source, goal.line, fault);
  /** @type {[string, string][]} */
  const query = [['lang', 'en']];
  for (const key of /** @type {const} */ (['panels', 'lock', 'goal'])) {
    const value = fields.get(key)?.value ?? opens?.[key];
    if (value) query.push([key, value]);
  }
  const payload = opens?.payload ?? '';
  const up = upFrom(page.address);
  return {
    title: `${number}. ${title}`, description: sentence, address: page.address, kind: 'lesson',
    styles: ['lesson.css'], scripts: ['lesson.js'],
    body: `<div class="desk">
<main id="main" tabindex="-1"${attributes({ 'data-lesson': page.name })}>
<p class="group"><a href="${up}index.html#${LESSONS.id}">${LESSONS.title}</a> · ${number} of ${all.length} · ${minutes} minutes</p>
<h1>${escaped(title)}</h1>
${html}${handIn('One link holds your motion, your predictions, your answers and your sentences.')}<p class="done"><label><input type="checkbox" id="done" disabled> I have done this lesson</label></p>
${around(all[at - 1], all[at + 1], up)}</main>
<aside aria-label="The playground">
<div id="shelf" hidden>
<button id="fold" type="button" aria-expanded="true" aria-controls="playground">Hide the playground</button>
<button id="enlarge" type="button" aria-pressed="false">Whole screen</button>
</div>
<iframe id="playground"${attributes({ src: `${up}../${playgroundAddress(payload, query)}`, 'data-open': payload, 'data-panels': fields.get('panels')?.value ?? opens?.panels, 'data-goal': goal?.value ?? opens?.goal, title: 'The playground', allow: 'clipboard-write' })}></iframe>
<p class="printed">The playground stands here on the screen.</p>
</aside>
</div>`,
  };
}

/** @param {LessonPage | undefined} before @param {LessonPage | undefined} after @param {string} up */
function around(before, after, up) {
  const way = (/** @type {LessonPage} */ { address, lesson }, /** @type {string} */ rel, /** @type {string} */ word) =>
    `<a rel="${rel}" href="${up}${address}"><small>${word}</small> <span>${lesson.number}. ${escaped(lesson.title)}</span></a>`;
  return `<nav class="around" aria-label="Lessons">
${[before && way(before, 'prev', 'Before'), `<a href="${up}index.html#${LESSONS.id}"><small>All</small> <span>Lessons</span></a>`, after && way(after, 'next', 'Next')].filter(Boolean).join('\n')}
</nav>
`;
}
