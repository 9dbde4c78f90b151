// SPDX-License-Identifier: MIT
// Shows a lesson's HTML inside another page. The file may come from a stranger: only these elements and attributes are
// shown, and no address that runs anything. The book's Markdown has no HTML of its own, and the page's policy forbids
// scripts in the text: this is the third lock of three.

const ELEMENTS = new Set(('a abbr article blockquote br button code dd del details div dl dt em fieldset figcaption figure h1 h2 h3 h4 h5 h6 hr img input label legend li ol output p picture '
  + 'pre s section small source span strong sub summary sup table tbody td textarea th thead tr ul svg circle path canvas').split(' '));
const ATTRIBUTES = new Set(('alt aria-hidden aria-label class colspan cx cy d data-right data-unit disabled for height hidden href id loading max maxlength media min name open r '
  + 'role rows rowspan scope src srcset start step tabindex type value viewbox width').split(' '));
const NAMES = new Set(['id', 'for', 'name']);
const PREFIX = 'shown-'; // so that no name of the text is one of the page

/** @param {string} html  a page's body @param {string} address  of the page that it is for @returns {Node[]} what its main element holds */
export function shown(html, address) {
  const main = new DOMParser().parseFromString(html, 'text/html').querySelector('main');
  if (!main) return [];
  for (const left of main.querySelectorAll('.around, .group, p.done, #hand-in')) left.remove(); // of the book around the lesson
  for (const element of [...main.querySelectorAll('*')]) clean(element, address);
  return [...main.childNodes].map((node) => document.adoptNode(node));
}

/** @param {Element} element @param {string} address */
function clean(element, address) {
  if (!ELEMENTS.has(element.localName.toLowerCase())) return element.remove();
  for (const { name, value } of [...element.attributes]) {
    const plain = name.toLowerCase();
    if (!ATTRIBUTES.has(plain)) element.removeAttribute(name);
    else if (NAMES.has(plain)) element.setAttribute(name, PREFIX + value);
    else if (plain === 'href') link(element, value, address);
    else if ((plain === 'src' || plain === 'srcset') && !isPicture(value, address)) element.removeAttribute(name);
    else if (plain === 'src' && !value.startsWith('data:')) element.setAttribute(name, new URL(value, address).href);
  }
}

/** @param {Element} element @param {string} href @param {string} address */
function link(element, href, address) {
  const target = addressOf(href, address);
  if (element.localName !== 'a' || !target || !['http:', 'https:', 'mailto:'].includes(target.protocol)) return element.removeAttribute('href');
  if (href.startsWith('#')) return element.setAttribute('href', `#${PREFIX}${href.slice(1)}`);
  element.setAttribute('href', target.href);
  element.setAttribute('target', '_blank');
  element.setAttribute('rel', 'noopener');
}

/** A drawing of ours, or a file of this site. @param {string} source @param {string} address */
const isPicture = (source, address) => source.startsWith('data:image/svg+xml,') || (!source.startsWith('#') && addressOf(source, address)?.origin === location.origin);

/** @param {string} text @param {string} base @returns {URL | null} */
function addressOf(text, base) {
  try {
    return new URL(text, base);
  } catch {
    return null;
  }
}
