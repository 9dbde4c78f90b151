// SPDX-License-Identifier: MIT
// The page's theme: the system's, unless another one is chosen.
import { element } from '../browser/dom.js';
import { followLanguage, tr, trLater } from '../languages/language.js';
import { remember, remembered } from '../browser/storage.js';

const KEY = 'gaitsmith-theme';

/** Names of the choices. @type {Record<string, string>} */
export const THEMES = { system: trLater('System'), light: trLater('Light'), dark: trLater('Dark'),
  projector: trLater('Projector'), contrast: trLater('High contrast') };

/**
 * The appearance that follows from the choice.
 * @typedef {object} Look
 * @property {'light' | 'dark' | 'strong-light' | 'strong-dark'} palette  as in shell/widgets/theme.h
 * @property {number} scale  of everything; a projector needs larger text
 */

const dark = matchMedia('(prefers-color-scheme: dark)');
const contrast = matchMedia('(prefers-contrast: more), (forced-colors: active)');
/** @type {((look: Look) => void)[]} */
const followers = [];
const stored = remembered(KEY) ?? '';
let chosen = Object.hasOwn(THEMES, stored) ? stored : 'system';

/** @returns {Look} */
function look() {
  const strong = dark.matches ? 'strong-dark' : 'strong-light';
  switch (chosen) {
    case 'light': case 'dark': return { palette: chosen, scale: 1 };
    case 'projector': return { palette: 'strong-light', scale: 1.25 };
    case 'contrast': return { palette: strong, scale: 1 };
    default: return { palette: contrast.matches ? strong : dark.matches ? 'dark' : 'light', scale: 1 };
  }
}

function update() {
  for (const apply of followers) apply(look());
}

/** Calls `apply` now and at every change. @param {(look: Look) => void} apply */
export function followTheme(apply) {
  followers.push(apply);
  apply(look());
}

/** Without storage the choice lasts until the page is closed. @param {string} theme  key of THEMES */
export function chooseTheme(theme) {
  chosen = theme;
  remember(KEY, theme === 'system' ? null : theme);
  update();
}

/** Chooses the next theme, without the system's. */
export function nextTheme() {
  const [, ...names] = Object.keys(THEMES);
  const { palette } = look();
  const now = chosen !== 'system' ? chosen : palette.startsWith('strong') ? 'contrast' : palette;
  chooseTheme(names[(names.indexOf(now) + 1) % names.length]);
}

/** Applies the theme and sets up the list in the header. */
export function startTheme() {
  const list = element('theme', HTMLSelectElement);
  const options = Object.entries(THEMES).map(([value, name]) => ({ name, option: new Option(name, value) }));
  list.append(...options.map(({ option }) => option));
  followLanguage(() => { for (const { name, option } of options) option.text = tr(name); });
  followTheme(({ palette, scale }) => {
    const { dataset } = document.documentElement;
    dataset.theme = palette;
    dataset.scale = scale > 1 ? 'large' : 'normal';
    list.value = chosen;
  });
  for (const query of [dark, contrast]) query.addEventListener('change', update);
  list.addEventListener('change', () => chooseTheme(list.value));
}
