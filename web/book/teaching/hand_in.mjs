// SPDX-License-Identifier: MIT
// The section of a page that hands in what a student did there (web/classroom/hand_in.js).

/** @param {string} holds  what the link holds, in a sentence */
export const handIn = (holds) => `<section id="hand-in" hidden>
<h2 id="hand-in-heading">Hand in</h2>
<p>${holds} It is not sent: give it to your teacher as you usually do.</p>
<p class="write"><label for="hand-in-name">Your name or initials, if your teacher wants them</label>
<input type="text" id="hand-in-name" maxlength="80" autocomplete="off"></p>
<p class="do"><button type="button" id="hand-in-make" class="primary">Make the link</button> <button type="button" id="hand-in-file" class="bordered">Save as a file</button> <span class="state" role="status"></span></p>
<p class="write" id="hand-in-made" hidden><label for="hand-in-link">The link</label>
<textarea id="hand-in-link" rows="3" readonly spellcheck="false" translate="no"></textarea>
<button type="button" id="hand-in-copy" class="bordered">Copy</button></p>
</section>
`;
