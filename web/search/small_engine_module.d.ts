// SPDX-License-Identifier: MIT
// The small engine of pages that must load quickly: the interface of engine_module.js without breeding and exported files.
export { default } from './engine_module.js';
