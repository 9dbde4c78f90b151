// SPDX-License-Identifier: MIT
// The engine's code, loaded and compiled once for all workers, and the workers.
import { compiledModule } from '../browser/compiled_module.js';
import { scriptAddress } from '../browser/trusted.js';

/** A frame without an origin of its own (sandbox without allow-same-origin) gets no workers. */
export const hasWorkers = self.origin !== 'null';

/** @type {Promise<WebAssembly.Module> | null} */
let compiled = null;
/** What stands in for workers, once it is loaded. @type {typeof import('./page_worker.js').PageWorker | null} */
let PageWorker = null;

/** Before it there are no workers. Rejected when it cannot be loaded; then the next call tries again. */
export function compiledEngine() {
  compiled ??= load();
  compiled.catch(() => { compiled = null; });
  return compiled;
}

async function load() {
  if (!hasWorkers) ({ PageWorker } = await import('./page_worker.js'));
  return compiledModule(new URL('engine_module.wasm', import.meta.url));
}

/** A worker without a role yet. */
export function createWorker() {
  if (PageWorker) return /** @type {Worker} */ (/** @type {unknown} */ (new PageWorker()));
  return new Worker(scriptAddress('search/worker.js'), { type: 'module' });
}
