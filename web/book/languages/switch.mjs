// SPDX-License-Identifier: MIT
// The links between the languages of a page: for readers at the top of its text, for search engines in its head.
import { attributes, upFrom } from '../html.mjs';

/** @typedef {import('./words.mjs').Language} Language */
/** A page in one language. @typedef {{address: string, language: Language}} Version */

/** @param {Version} page @param {Version[]} versions  all languages of this page, English first */
export function languageSwitch({ address, language }, versions) {
  if (versions.length < 2) return '';
  const links = versions.map((version) => (version.address === address ? `<span aria-current="page">${version.language.name}</span>`
    : `<a${attributes({ href: upFrom(address) + version.address, lang: version.language.code, hreflang: version.language.code })}>${version.language.name}</a>`));
  return `<nav class="languages"${attributes({ 'aria-label': language.tr('Language') })}>${links.join(' · ')}</nav>\n`;
}

/** @param {Version} page @param {Version[]} versions */
export function alternates({ address }, versions) {
  if (versions.length < 2) return '';
  const link = (/** @type {Version} */ version, /** @type {string} */ hreflang) => `<link rel="alternate"${attributes({ hreflang, href: upFrom(address) + version.address })}>\n`;
  return versions.map((version) => link(version, version.language.code)).join('') + link(versions[0], 'x-default');
}
