// SPDX-License-Identifier: MIT
// Types of uqr.js, the QR encoder of the npm package of that name, as far as the page uses it.

/** data: rows of dark and light modules, the border included. Throws when the text is too long. */
export function encode(text: string, options: { ecc: 'L' | 'M' | 'Q' | 'H'; border: number }): { data: boolean[][]; size: number };
