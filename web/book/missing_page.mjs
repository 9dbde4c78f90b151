// SPDX-License-Identifier: MIT
// The page that the service worker shows instead of a page that is not stored, when there is no network. The service
// worker keeps one paragraph of those with data-of, and the links that lead to stored pages (web/storage/service_worker.js).

/** What can be missing. @type {Record<string, string>} */
const REASONS = {
  reference: 'It belongs to the API reference, which is too large to be stored beforehand. Its pages are stored when you read them.',
  pictures: 'It shows pictures of the playground, which are too large to be stored beforehand. They are stored when you look at them.',
  design: 'It is the list of design decisions, which is too large to be stored beforehand. It is stored when you read it.',
  page: 'It belongs to Gaitsmith’s book. The book is stored in English and in your language while the playground is open and idle. Here it was not complete yet.',
  unknown: 'Gaitsmith knows no page at this address. Perhaps it is new, or the address has a mistake.',
};
const LINKS = [['../', 'The playground'], ['index.html#lessons', 'Lessons'], ['gallery.html', 'Gallery'], ['teachers.html', 'For teachers'], ['index.html', 'All of the book']];

/** @returns {import('./template.mjs').Sheet} */
export function missingPage() {
  return {
    title: 'This page was not stored', address: 'missing.html', kind: 'page',
    description: 'There is no network, and this page was not stored in the browser.',
    body: `<div class="spread">
<main id="main" tabindex="-1">
<h1>This page was not stored</h1>
<p class="hook">There is no network now, and the page <code>{page}</code> is not stored in this browser.</p>
${Object.entries(REASONS).map(([of, reason]) => `<p data-of="${of}">${reason}</p>`).join('\n')}
<p><a href="">Try again</a> when you are connected.</p>
<h2>What is stored here</h2>
<ul>
${LINKS.map(([address, name]) => `<li class="stored"><a href="${address}">${name}</a></li>`).join('\n')}
</ul>
</main>
</div>`,
  };
}
