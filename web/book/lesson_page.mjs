// SPDX-License-Identifier: MIT
// The page of a lesson: text, and the playground beside it.
import { attributes, escaped, upFrom } from './html.mjs';
import { faultOfGoal } from '../page/goal_conditions.js';
import { LESSONS } from './contents.mjs';
import { handIn } from './teaching/hand_in.mjs';
import { playgroundAddress } from './playground.mjs';

/** @typedef {import('./links.mjs').Links} Links */
/** @typedef {import('./markdown.mjs').Rendered} Rendered */
/** @typedef {import('./pages.mjs').Lesson} Lesson */
/** @typedef {import('./pages.mjs').Page & {lesson: Lesson}} LessonPage */
/** @typedef {import('./languages/words.mjs').Language} Language */

/**
 * @param {LessonPage} page @param {Rendered} rendered @param {LessonPage[]} all  lessons, in order @param {Links} links
 * @returns {Promise<import('./template.mjs').Sheet>}
 */
export async function lessonPage(page, { html, sentence }, all, links) {
  const { number, title, minutes, fields } = page.lesson;
  const at = all.indexOf(page);
  const open = fields.get('open');
  const { opens } = open ? await links.resolve(page, open.line, open.value, page.original?.source) : { opens: undefined };
  if (open && !opens) links.faults.add(page.source, open.line, '"open" names a document of examples');
  const goal = fields.get('goal');
  const fault = goal && faultOfGoal(goal.value, links.playground.tables);
  if (fault) links.faults.add(page.source, goal.line, fault);
  /** @type {[string, string][]} */
  const query = [['lang', page.language.code]];
  for (const key of /** @type {const} */ (['panels', 'lock', 'goal'])) {
    const value = fields.get(key)?.value ?? opens?.[key];
    if (value) query.push([key, value]);
  }
  const payload = opens?.payload ?? '';
  const up = upFrom(page.address);
  const { language } = page;
  const { tr } = language;
  return {
    title: `${number}. ${title}`, description: sentence, address: page.address, kind: 'lesson',
    styles: ['lesson.css'], scripts: ['lesson.js'], language,
    body: `<div class="desk">
<main id="main" tabindex="-1"${attributes({ 'data-lesson': page.name })}>
<p class="group"><a href="${up}${language.folder}index.html#${LESSONS.id}">${tr(LESSONS.title)}</a> · ${tr('{1} of {2}', number, all.length)} · ${tr('{1} minutes', minutes)}</p>
<h1>${escaped(title)}</h1>
${html}${handIn(language, tr('One link holds your motion, your predictions, your answers and your sentences. It is not sent: give it to your teacher as you usually do.'))}<p class="done"><label><input type="checkbox" id="done" disabled> ${tr('I have done this lesson')}</label></p>
${around(all[at - 1], all[at + 1], up, language)}</main>
<aside aria-label="${tr('The playground')}">
<div id="shelf" hidden>
<button id="fold" type="button" aria-expanded="true" aria-controls="playground">${tr('Hide the playground')}</button>
<button id="enlarge" type="button" aria-pressed="false">${tr('Whole screen')}</button>
</div>
<iframe id="playground"${attributes({ src: `${up}../${playgroundAddress(payload, query)}`, 'data-open': payload, 'data-panels': fields.get('panels')?.value ?? opens?.panels, 'data-goal': goal?.value ?? opens?.goal, title: tr('The playground'), allow: 'clipboard-write' })}></iframe>
<p class="printed">${tr('The playground stands here on the screen.')}</p>
</aside>
</div>`,
  };
}

/** @param {LessonPage | undefined} before @param {LessonPage | undefined} after @param {string} up @param {Language} language */
function around(before, after, up, { folder, tr }) {
  const way = (/** @type {LessonPage} */ { address, lesson, language }, /** @type {string} */ rel, /** @type {string} */ word) =>
    `<a${attributes({ rel, href: up + address, hreflang: language.code })}><small>${word}</small> <span>${lesson.number}. ${escaped(lesson.title)}</span></a>`;
  return `<nav class="around" aria-label="${tr(LESSONS.title)}">
${[before && way(before, 'prev', tr('Before')), `<a href="${up}${folder}index.html#${LESSONS.id}"><small>${tr('All')}</small> <span>${tr(LESSONS.title)}</span></a>`, after && way(after, 'next', tr('Next'))].filter(Boolean).join('\n')}
</nav>
`;
}
