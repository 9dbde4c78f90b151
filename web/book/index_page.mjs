// SPDX-License-Identifier: MIT
// The book's first page: the list of pages, and the search.
import { attributes, escaped } from './html.mjs';

/** @typedef {{address: string, name: string, title: string, sentence: string, lesson?: import('./pages.mjs').Lesson}} Entry */

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
<div id="groups">
${groups.map(({ title, id, pages }) => `<section${attributes({ id, 'aria-labelledby': `${id}-heading` })}>
<h2 id="${id}-heading">${title}</h2>
<ul class="shelf">
${pages.map(entry).join('\n')}
</ul>
${id === 'lessons' ? '<p id="progress" hidden>What you have done is kept in this browser only. <button id="forget" type="button" class="bordered">Forget it</button></p>\n' : ''}</section>`).join('\n')}
</div>
</main>`,
  };
}

/** @param {Entry} page */
function entry({ address, name, title, sentence, lesson }) {
  const number = lesson ? `<span class="number">${lesson.number}</span> ` : '';
  const minutes = lesson ? ` <small>${lesson.minutes} minutes</small>` : '';
  return `<li${attributes({ 'data-lesson': lesson && name })}><a href="${address}">${number}${escaped(title)}</a>${minutes}
<p>${escaped(sentence)}</p></li>`;
}
