// SPDX-License-Identifier: MIT
// The address from which programs outside this site import the engine.
export * from './search/engine.js';
