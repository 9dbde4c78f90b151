// SPDX-License-Identifier: MIT
// The engine's code, loaded and compiled once for all workers.

/** @type {Promise<WebAssembly.Module> | null} */
let compiled = null;

/** Rejected when it cannot be loaded; then the next call tries again. */
export function compiledEngine() {
  compiled ??= WebAssembly.compileStreaming(fetch(new URL('engine.wasm', import.meta.url)));
  compiled.catch(() => { compiled = null; });
  return compiled;
}

/** A worker without a role yet. */
export const createWorker = () => new Worker(new URL('worker.js', import.meta.url), { type: 'module' });
