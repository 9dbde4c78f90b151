// SPDX-License-Identifier: MIT
// The frame of every page of the book: head, header and footer.
import { attributes, escaped } from './html.mjs';

/**
 * @typedef {object} Sheet
 * @property {string} title
 * @property {string} description
 * @property {string} address    in the book
 * @property {string} kind       class of the body
 * @property {string} body       HTML of main and its siblings
 * @property {string[]} [styles]   beside those of every page
 * @property {string[]} [scripts]  modules
 * @property {boolean} [engine]   whether the page runs the engine, which the policy must allow
 */
/** A link in the header. current: to this page, or to its group. @typedef {{name: string, address: string, current?: 'page' | 'true'}} HeaderLink */

const POLICY = 'default-src \'self\'; script-src \'self\'; style-src \'self\'; img-src \'self\' data:; frame-src \'self\'; form-action \'self\'; base-uri \'none\'; object-src \'none\'';
const MARK = '<svg viewBox="-1.15 -1.15 2.3 2.3" aria-hidden="true"><path d="M0 0L0 -1M0 0L.95 -.31M0 0L.59 .81M0 0L-.59 .81M0 0L-.95 -.31"/></svg>';

/** The first line of a printed lesson. */
const WORKSHEET = '<p class="worksheet"><span>Name</span> <span>Date</span></p>\n';

/** The relative path from an address of the book to its root. @param {string} address */
export const upFrom = (address) => '../'.repeat(address.split('/').length - 1);

/** @param {Sheet} sheet @param {HeaderLink[]} headerLinks */
export function htmlPage({ title, description, address, kind, body, styles = [], scripts = [], engine = false }, headerLinks) {
  const up = upFrom(address);
  const whole = title === 'Gaitsmith' ? title : `${title} · Gaitsmith`;
  return `<!doctype html>
<html lang="en">
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
<link rel="icon" href="${up}../favicon.svg" type="image/svg+xml">
<script src="${up}look.js"></script>
${['tokens.css', 'book.css', ...styles].map((file) => `<link rel="stylesheet" href="${up}${file}">`).join('\n')}
${[...scripts, 'stored.js'].map((file) => `<script type="module" src="${up}${file}"></script>`).join('\n')}
</head>
<body class="${kind}">
<a class="skip" href="#main">Skip to the text</a>
<header>
  <a class="word" href="${up}../" aria-label="Gaitsmith: the playground">${MARK}<span translate="no">Gaitsmith</span></a>
  <nav aria-label="Book">
    <ul>
${headerLinks.map((link) => `      <li><a${attributes({ href: up + link.address, 'aria-current': link.current })}>${link.name}</a></li>`).join('\n')}
    </ul>
  </nav>
${address === 'index.html' || kind === 'lesson' ? '' : finder(up)}</header>
${kind === 'lesson' ? WORKSHEET : ''}${body}
${kind === 'lesson' ? '' : footer(up)}</body>
</html>
`;
}

/** @param {string} up */
function footer(up) {
  return `<footer>
  <p>Gaitsmith is free software under the <a href="${up}../LICENSE">MIT licence</a>. This page asks nothing of other servers and tells them nothing.</p>
</footer>
`;
}

/** @param {string} up */
function finder(up) {
  return `  <form class="finder" role="search" action="${up}index.html">
    <input type="search" name="q" aria-label="Search the book" placeholder="Search" autocomplete="off" spellcheck="false">
    <button type="submit" aria-label="Search"><svg viewBox="0 0 20 20" aria-hidden="true"><circle cx="9" cy="9" r="5"/><path d="M13 13l4 4"/></svg></button>
  </form>
`;
}
