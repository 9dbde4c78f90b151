// SPDX-License-Identifier: MIT
// Escapes text for HTML, and relative addresses.

/** @type {Record<string, string>} */
const ENTITIES = { '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' };

/** @param {string} text */
export const escaped = (text) => text.replace(/[&<>"]/g, (character) => ENTITIES[character]);

/** Attributes, each after a space. Undefined values are left out. @param {Record<string, string | undefined>} values */
export const attributes = (values) => Object.entries(values)
  .map(([name, value]) => (value === undefined ? '' : ` ${name}="${escaped(value)}"`)).join('');

/** The relative path from an address of the book to its root. @param {string} address */
export const upFrom = (address) => '../'.repeat(address.split('/').length - 1);
