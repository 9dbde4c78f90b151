// SPDX-License-Identifier: MIT
// Copies the text of a field, or selects it for copying by hand.
import { tr } from '../languages/language.js';

/** @param {HTMLTextAreaElement} field @returns {Promise<string>} what to say */
export async function copyField(field) {
  try {
    await navigator.clipboard.writeText(field.value);
    return tr('Copied');
  } catch {
    field.select();
    return tr('The browser did not allow copying by itself. The text is selected: press Ctrl+C or ⌘C.');
  }
}
