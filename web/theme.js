// SPDX-License-Identifier: MIT
// Light or dark: as the system is, until the person says otherwise.
import { element, onClick } from './dom.js';
import { remember, remembered } from './storage.js';

const KEY = 'gaitsmith-theme';

const system = matchMedia('(prefers-color-scheme: dark)');
/** @type {((dark: boolean) => void)[]} */
const followers = [];
let chosen = remembered(KEY);

const isDark = () => (chosen ? chosen === 'dark' : system.matches);

/** Calls back now and at every change. @param {(dark: boolean) => void} apply */
export function followTheme(apply) {
  followers.push(apply);
  apply(isDark());
}

/** Gives the page its theme and the button its work. */
export function startTheme() {
  const update = () => {
    for (const apply of followers) apply(isDark());
  };
  followTheme((dark) => {
    document.documentElement.dataset.theme = dark ? 'dark' : 'light';
    const button = element('theme');
    button.textContent = dark ? 'Light' : 'Dark';
    button.setAttribute('aria-label', dark ? 'Light theme' : 'Dark theme');
  });
  system.addEventListener('change', update);
  onClick('theme', () => {
    chosen = isDark() ? 'light' : 'dark';
    remember(KEY, chosen); // where storage is forbidden it holds until the page is left
    update();
  });
}
