// SPDX-License-Identifier: MIT
// The search's library as it lies beside find.js on the site.
export { default } from 'minisearch';
