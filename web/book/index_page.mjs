// SPDX-License-Identifier: MIT
// The book's first page: the list of pages, and the search. Each language has one.
import { attributes, escaped } from './html.mjs';
import { ENGLISH } from './languages/words.mjs';
import { stripPictures } from './strip_pictures.mjs';

/** @typedef {import('./languages/words.mjs').Language} Language */
/** goals, strip: of a lesson; language: English if there is none @typedef {{address: string, name: string, title: string, sentence: string, lesson?: import('./pages.mjs').Lesson, goals?: string[], strip?: import('./markdown.mjs').Strip, language?: Language}} Entry */

const RING = '<svg class="tick" viewBox="0 0 20 20" aria-hidden="true"><circle cx="10" cy="10" r="8.5"/><path d="M6 10.4l2.8 2.8L14.2 7.4"/></svg>';

/** @param {{title: string, id: string, pages: Entry[]}[]} groups @param {Language} language @returns {import('./template.mjs').Sheet} */
export function indexPage(groups, language) {
  const { folder, tr } = language;
  const up = folder && '../';
  return {
    title: tr('The book'), address: `${folder}index.html`, kind: 'index', language,
    description: tr('Lessons, a gallery, and everything about the playground where figures find their motions.'),
    scripts: ['find.js', 'shelf.js'],
    body: `<main id="main" tabindex="-1">
<h1>${tr('The book')}</h1>
<p class="hook">${tr('Figures of rods that nobody animated, and how a computer finds their motions. Begin with a lesson, look around in the {1}, or {2}.',
  `<a${attributes({ href: `${up}gallery.html`, hreflang: 'en' })}>${tr('gallery')}</a>`, `<a href="${up}../${folder && `?lang=${language.code}`}">${tr('open the playground')}</a>`)}</p>
${folder && `<p>${tr('Lessons and the pages for teachers are translated. {1} is in English. The translation was not checked by a teacher who grew up with this language.', `<a href="../index.html" hreflang="en">${tr('The whole book')}</a>`)}</p>\n`}<form id="find" role="search" action="index.html">
<label for="find-words">${tr('Search the book')}</label>
<input type="search" id="find-words" name="q" autocomplete="off" spellcheck="false">
<button type="submit" class="bordered">${tr('Search')}</button>
<noscript><p>${tr('The search needs JavaScript. The pages do not.')}</p></noscript>
</form>
<p id="find-count" role="status"></p>
<ol id="found" hidden></ol>
<p id="stored" role="status" hidden>${tr('Everything is stored in this browser and works without a network, except the API reference, the design decisions and the pictures of the playground.')}</p>
<div id="groups">
${groups.map(({ title, id, pages }) => `<section${attributes({ id, 'aria-labelledby': `${id}-heading` })}>
<h2 id="${id}-heading">${tr(title)}</h2>
<ul class="shelf${id === 'lessons' ? ' lessons' : ''}">
${pages.map((page) => entry(page, up, language)).join('\n')}
</ul>
${id === 'lessons' ? `<p id="progress" hidden>${tr('What you have done is kept in this browser only.')} <button id="forget" type="button" class="bordered">${tr('Forget it')}</button></p>\n` : ''}</section>`).join('\n')}
</div>
</main>`,
  };
}

/** @param {Entry} page @param {string} up @param {Language} ours  of the list */
function entry({ address, name, title, sentence, lesson, goals = [], strip, language = ENGLISH }, up, ours) {
  const { tr } = ours;
  const number = lesson ? `<span class="number">${lesson.number}</span> ` : '';
  const minutes = lesson ? ` <small>${tr('{1} minutes', lesson.minutes)}</small>` : '';
  const foreign = language === ours ? '' : ` <small>${tr('in English')}</small>`;
  const lang = language === ours ? undefined : language.code;
  const picture = lesson && strip ? `<span class="strip">${stripPictures(strip, strip.alt, (way) => up + way, { few: true })}</span>\n` : '';
  const reached = lesson && goals.length > 0 ? `\n<p class="reached">${goals.map(() => RING).join('')} <span>${goals.length === 1 ? tr('One goal') : tr('{1} goals', goals.length)}</span></p>` : '';
  return `<li${attributes({ 'data-lesson': lesson && name, 'data-goals': lesson && JSON.stringify(goals) })}>${picture}<div><a${attributes({ href: up + address, hreflang: lang, lang })}>${number}${escaped(title)}</a>${minutes}${foreign}</div>
<p${attributes({ lang })}>${escaped(sentence)}</p>${reached}</li>`;
}
