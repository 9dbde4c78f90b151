// SPDX-License-Identifier: MIT
// Saves a lesson as a SCORM package.
import { fixed, tr } from '../languages/language.js';
import { makeScormPackage } from '../share/scorm_maker.js';

const form = /** @type {HTMLFormElement} */ (document.getElementById('package'));
/** @template {HTMLElement} T @param {string} id @param {new () => T} kind @returns {T} */
const find = (id, kind) => {
  const found = document.getElementById(`package-${id}`);
  if (!(found instanceof kind)) throw new Error(`no #package-${id}`);
  return found;
};
const lesson = find('lesson', HTMLSelectElement), version = find('version', HTMLSelectElement);
const cancel = find('cancel', HTMLButtonElement), progress = find('progress', HTMLProgressElement), state = find('state', HTMLElement);
const save = /** @type {HTMLButtonElement} */ (form.querySelector('[type=submit]'));
/** Of the package that is being made. @type {AbortController | null} */
let making = null;

async function make() {
  if (making) return;
  making = new AbortController();
  const { signal } = making, name = lesson.value, { text: title, dataset: { page } } = lesson.selectedOptions[0];
  const chosen = /** @type {import('../share/scorm_package.js').Version} */ (version.value);
  progress.value = 0;
  progress.hidden = cancel.hidden = false;
  state.textContent = tr('Collecting the files …');
  try {
    const file = `${name}-scorm-${chosen}.zip`;
    const bytes = await makeScormPackage({
      name, title, launch: `book/${page}?scorm`, version: chosen, signal,
      onProgress: (share) => { progress.value = share; },
    });
    const address = URL.createObjectURL(bytes);
    Object.assign(document.createElement('a'), { href: address, download: file }).click();
    setTimeout(() => URL.revokeObjectURL(address), 60000);
    state.textContent = tr('Saved as {1}, {2} MB.', file, fixed(bytes.size / 1e6, 1));
  } catch (error) {
    state.textContent = signal.aborted ? `${tr('Cancelled')}.` : tr('The package could not be made: {1}.', error instanceof Error ? error.message : String(error));
  }
  making = null;
  progress.hidden = cancel.hidden = true;
  save.focus();
}

form.addEventListener('submit', (event) => {
  event.preventDefault();
  void make();
});
cancel.addEventListener('click', () => making?.abort());
save.disabled = false;
