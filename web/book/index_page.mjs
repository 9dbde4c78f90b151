// SPDX-License-Identifier: MIT
// The book's first page: the list of pages, and the search.
import { attributes, escaped } from './html.mjs';
import { stripPictures } from './strip_pictures.mjs';

/** goals, strip: of a lesson @typedef {{address: string, name: string, title: string, sentence: string, lesson?: import('./pages.mjs').Lesson, goals?: string[], strip?: import('./markdown.mjs').Strip}} Entry */

const RING = '<svg class="tick" viewBox="0 0 20 20" aria-hidden="true"><circle cx="10" cy="10" r="8.5"/><path d="M6 10.4l2.8 2.8L14.2 7.4"/></svg>';

/** @param {{title: string, id: string, pages: Entry[]}[]} groups @returns {import('./template.mjs').Sheet} */
export function indexPage(groups) {
  return {
    title: 'The book', address: 'index.html', kind: 'index',
    description: 'Lessons, a gallery, and everything about the playground where figures find their motions.',
    scripts: ['find.js', 'shelf.js'],
    body: `<main id="main" tabindex="-1">
<h1>The book</h1>
<p class="hook">Figures of rods that nobody animated, and how a computer finds their motions. Begin with a lesson, look around in
the gallery, or <a href="../">open the playground</a>.</p>
<form id="find" role="search" action="index.html">
<label for="find-words">Search the book</label>
<input type="search" id="find-words" name="q" autocomplete="off" spellcheck="false">
<button type="submit" class="bordered">Search</button>
<noscript><p>The search needs JavaScript; the pages do not.</p></noscript>
</form>
<p id="find-count" role="status"></p>
<ol id="found" hidden></ol>
<p id="stored" role="status" hidden>Everything is stored in this browser and works without a network, except the API reference and the pictures of the playground.</p>
<div id="groups">
${groups.map(({ title, id, pages }) => `<section${attributes({ id, 'aria-labelledby': `${id}-heading` })}>
<h2 id="${id}-heading">${title}</h2>
<ul class="shelf${id === 'lessons' ? ' lessons' : ''}">
${pages.map(entry).join('\n')}
</ul>
${id === 'lessons' ? '<p id="progress" hidden>What you have done is kept in this browser only. <button id="forget" type="button" class="bordered">Forget it</button></p>\n' : ''}</section>`).join('\n')}
</div>
</main>`,
  };
}

/** @param {Entry} page */
function entry({ address, name, title, sentence, lesson, goals = [], strip }) {
  const number = lesson ? `<span class="number">${lesson.number}</span> ` : '';
  const minutes = lesson ? ` <small>${lesson.minutes} minutes</small>` : '';
  const picture = lesson && strip ? `<span class="strip">${stripPictures(strip, strip.alt, (way) => way, { few: true })}</span>\n` : '';
  const reached = lesson && goals.length > 0 ? `\n<p class="reached">${goals.map(() => RING).join('')} <span>${goals.length === 1 ? 'One goal' : `${goals.length} goals`}</span></p>` : '';
  return `<li${attributes({ 'data-lesson': lesson && name, 'data-goals': lesson && JSON.stringify(goals) })}>${picture}<div><a href="${address}">${number}${escaped(title)}</a>${minutes}</div>
<p>${escaped(sentence)}</p>${reached}</li>`;
}
