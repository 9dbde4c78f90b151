// SPDX-License-Identifier: MIT
// What the page reads of the tables in C++. The build writes catalogue.js into the site (shell/catalogue/catalogue.h);
// `gaitsmith catalogue` prints the tables as a whole.

/** Searches, in the order of the panel. label: short, in English, as tr() takes it. */
export const algorithms: readonly { readonly name: string; readonly label: string }[];
/** Secondary terms, by their names in documents, in their order. */
export const terms: readonly { readonly name: string }[];
/** What decides a controller's state. words: in English, as tr() takes it. */
export const control_modes: readonly { readonly name: string; readonly words: string }[];
/** In the order of the tabs. label: in English, as tr() takes it. */
export const panels: readonly { readonly name: string; readonly label: string }[];
/** Files that C++ makes of a motion. type: MIME. springs: whether they can show figures of springs. label, note: in English, as tr() takes them. */
export const exporters: readonly {
  readonly name: string; readonly ending: string; readonly type: string; readonly springs: boolean; readonly group: 'pictures' | 'programs'; readonly label: string; readonly note: string;
}[];
/** English first. name: in the language itself. */
export const languages: readonly { readonly code: string; readonly name: string }[];
