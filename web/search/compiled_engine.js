// SPDX-License-Identifier: MIT
// The engine's code, loaded and compiled once for all workers, and the creation of workers.
import { compiledModule } from '../browser/compiled_module.js';
import { scriptAddress } from '../browser/trusted.js';

/** False in frames without an origin (sandbox without allow-same-origin). */
export const hasWorkers = self.origin !== 'null';

/** @type {Promise<WebAssembly.Module> | null} */
let compiled = null;
/** The replacement for workers, if it is needed and loaded. @type {typeof import('./page_worker.js').PageWorker | null} */
let PageWorker = null;

/** Await this before createWorker(). Rejected if loading fails; the next call tries again. */
export function compiledEngine() {
  compiled ??= load();
  compiled.catch(() => { compiled = null; });
  return compiled;
}

async function load() {
  if (!hasWorkers) ({ PageWorker } = await import('./page_worker.js'));
  return compiledModule(new URL('../search/engine_module.wasm', import.meta.url));
}

/** A worker without a role yet. */
export function createWorker() {
  if (PageWorker) return /** @type {Worker} */ (/** @type {unknown} */ (new PageWorker()));
  return new Worker(scriptAddress('search/worker.js'), { type: 'module' });
}
