// SPDX-License-Identifier: MIT
// The part of the Share dialog that saves an assignment as a SCORM package. Loaded on first use.
import { element, offerFile, setText } from '../browser/dom.js';
import { tr } from '../languages/language.js';
import { makeScormPackage } from './scorm_maker.js';
import { fileName } from './sharing.js';
import { stamp } from './stamp.js';

/** Of the package that is being made. @type {AbortController | null} */
let making = null;

/** @param {string} assignment  its address @param {string} title */
export async function saveScormPackage(assignment, title) {
  if (making) return;
  const said = element('share-scorm-said'), progress = element('share-scorm-progress', HTMLProgressElement), cancel = element('share-scorm-cancel', HTMLButtonElement);
  const version = /** @type {import('./scorm_package.js').Version} */ (element('share-scorm-version', HTMLSelectElement).value);
  const { search, hash } = new URL(assignment);
  // Learning systems know packages by their names.
  const name = `${fileName(title).normalize('NFD').replace(/[^a-z0-9-]/g, '').slice(0, 40) || 'assignment'}-${stamp(search + hash)}`;
  making = new AbortController();
  const { signal } = making;
  const dialog = element('share-dialog', HTMLDialogElement);
  const stop = () => making?.abort();
  cancel.onclick = stop;
  dialog.addEventListener('close', stop, { once: true });
  progress.value = 0;
  progress.hidden = cancel.hidden = false;
  setText(said, tr('Collecting the files …'));
  cancel.focus();
  try {
    const launch = `index.html?${search ? `${search.slice(1)}&` : ''}scorm${hash}`;
    const bytes = await makeScormPackage({ name, title, launch, version, signal, onProgress: (share) => { progress.value = share; } });
    const file = `${name}-scorm-${version}.zip`;
    offerFile(file, bytes, 'application/zip');
    setText(said, tr('Saved as {1}', file));
  } catch (error) {
    setText(said, signal.aborted ? tr('Cancelled') : tr('The package could not be made: {1}.', error instanceof Error ? error.message : String(error)));
  } finally {
    making = null;
    progress.hidden = cancel.hidden = true;
    dialog.removeEventListener('close', stop);
    if (dialog.open) element('share-scorm').focus();
  }
}
