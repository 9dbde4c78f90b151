// SPDX-License-Identifier: MIT
// What the page adds to the browser's window.
import type { Gaitsmith } from './api.js';

declare global {
  interface Window {
    gaitsmith: Gaitsmith;
  }
}
