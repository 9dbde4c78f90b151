// SPDX-License-Identifier: MIT
// The frame of every page of the book: head, header and footer.
import { attributes, escaped, upFrom } from './html.mjs';
import { liveWordsOf } from './languages/live_words.mjs';
import { alternates, languageSwitch } from './languages/switch.mjs';
import { ENGLISH } from './languages/words.mjs';

/**
 * @typedef {object} Sheet
 * @property {string} title
 * @property {string} description
 * @property {string} address    in the book
 * @property {string} kind       class of the body
 * @property {string} body       HTML of main and its siblings
 * @property {string[]} [styles]   beside those of every page
 * @property {string[]} [scripts]  modules
 * @property {Language} [language]  English if there is none
 * @property {boolean} [engine]   whether the page runs the engine, which the policy must allow
 */
/** @typedef {import('./languages/words.mjs').Language} Language */
/** A link in the header. current: to this page, or to its group; language: of a page in another one. @typedef {{name: string, address: string, current?: 'page' | 'true', language?: string}} HeaderLink */

const POLICY = 'default-src \'self\'; script-src \'self\'; style-src \'self\'; img-src \'self\' data:; frame-src \'self\'; form-action \'self\'; base-uri \'none\'; object-src \'none\'';
const MARK = '<svg viewBox="-1.15 -1.15 2.3 2.3" aria-hidden="true"><path d="M0 0L0 -1M0 0L.95 -.31M0 0L.59 .81M0 0L-.59 .81M0 0L-.95 -.31"/></svg>';

/** The first line of a printed lesson. @param {Language} language */
const worksheet = ({ tr }) => `<p class="worksheet"><span>${tr('Name')}</span> <span>${tr('Date')}</span></p>\n`;

/** @param {Sheet} sheet @param {HeaderLink[]} headerLinks @param {import('./languages/switch.mjs').Version[]} [versions]  all languages of the page */
export function htmlPage({ title, description, address, kind, body, styles = [], scripts = [], engine = false, language = ENGLISH }, headerLinks, versions = []) {
  const up = upFrom(address);
  const { tr } = language;
  const wholeBody = body.replace(/<main[^>]*>\n/, (main) => main + languageSwitch({ address, language }, versions));
  const whole = title === 'Gaitsmith' ? title : `${title} · Gaitsmith`;
  return `<!doctype html>
<html lang="${language.code}">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="${engine ? POLICY.replace('script-src', 'script-src \'wasm-unsafe-eval\'') : POLICY}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>${escaped(whole)}</title>
<meta${attributes({ name: 'description', content: description })}>
<meta name="color-scheme" content="light dark">
<meta${attributes({ property: 'og:title', content: title })}>
<meta${attributes({ property: 'og:description', content: description })}>
<meta property="og:type" content="article">
<meta property="og:site_name" content="Gaitsmith">
<meta${attributes({ property: 'og:image', content: `${up}../preview.png` })}>
${alternates({ address, language }, versions)}<link rel="icon" href="${up}../favicon.svg" type="image/svg+xml">
<script src="${up}look.js"></script>
${['tokens.css', 'book.css', ...styles].map((file) => `<link rel="stylesheet" href="${up}${file}">`).join('\n')}
${[...language === ENGLISH ? [] : [liveWordsOf(language)], ...scripts, 'stored.js'].map((file) => `<script type="module" src="${up}${file}"></script>`).join('\n')}
</head>
<body class="${kind}">
<a class="skip" href="#main">${tr('Skip to the text')}</a>
<header>
  <a class="word" href="${up}${headerLinks[0]?.address ?? '../'}"${attributes({ 'aria-label': tr('Gaitsmith: the playground') })}>${MARK}<span translate="no">Gaitsmith</span></a>
  <nav${attributes({ 'aria-label': tr('Book') })}>
    <ul>
${headerLinks.map((link) => `      <li><a${attributes({ href: up + link.address, 'aria-current': link.current, hreflang: link.language })}>${link.name}</a></li>`).join('\n')}
    </ul>
  </nav>
${kind === 'index' || kind === 'lesson' ? '' : finder(up, language)}</header>
${kind === 'lesson' ? worksheet(language) : ''}${wholeBody}
${kind === 'lesson' ? '' : footer(up, language)}</body>
</html>
`;
}

/** @param {string} up @param {Language} language */
function footer(up, { tr }) {
  return `<footer>
  <p>${tr('Gaitsmith is free software under the {1}. This page asks nothing of other servers and tells them nothing.', `<a href="${up}../LICENSE">${tr('MIT licence')}</a>`)}</p>
</footer>
`;
}

/** @param {string} up @param {Language} language */
function finder(up, { folder, tr }) {
  return `  <form class="finder" role="search" action="${up}${folder}index.html">
    <input type="search" name="q" aria-label="${tr('Search the book')}" placeholder="${tr('Search')}" autocomplete="off" spellcheck="false">
    <button type="submit" aria-label="${tr('Search')}"><svg viewBox="0 0 20 20" aria-hidden="true"><circle cx="9" cy="9" r="5"/><path d="M13 13l4 4"/></svg></button>
  </form>
`;
}
