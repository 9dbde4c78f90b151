// SPDX-License-Identifier: MIT
// The section of a page that hands in what a student did there (web/classroom/hand_in.js).

/** @param {import('../languages/words.mjs').Language} language @param {string} holds  what the link holds, and that it is not sent */
export const handIn = ({ tr }, holds) => `<section id="hand-in" hidden>
<h2 id="hand-in-heading">${tr('Hand in')}</h2>
<p>${holds}</p>
<p class="write"><label for="hand-in-name">${tr('Your name or initials, if your teacher wants them')}</label>
<input type="text" id="hand-in-name" maxlength="80" autocomplete="off"></p>
<p class="do"><button type="button" id="hand-in-make" class="primary">${tr('Make the link')}</button> <button type="button" id="hand-in-file" class="bordered">${tr('Save as a file')}</button> <span class="state" role="status"></span></p>
<p class="write" id="hand-in-made" hidden><label for="hand-in-link">${tr('The link')}</label>
<textarea id="hand-in-link" rows="3" readonly spellcheck="false" translate="no"></textarea>
<button type="button" id="hand-in-copy" class="bordered">${tr('Copy the link')}</button></p>
</section>
`;
