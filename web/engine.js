// SPDX-License-Identifier: MIT
// The engine at the address that programs outside this site import; it lives in search/.
export * from './search/engine.js';
