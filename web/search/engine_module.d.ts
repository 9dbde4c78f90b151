// SPDX-License-Identifier: MIT
// Types of engine_module.js, which Emscripten builds from engine.cpp. Pointers and sizes are numbers in the module's
// memory. engine.cpp documents each function and how long its result is valid.

import type { EngineExports, Pointer } from './engine_exports.js';

export type { Pointer };

export interface EngineModule extends EngineExports {
  readonly HEAPU8: Uint8Array;
}

export interface EngineOptions {
  /** Instantiates a module that is already compiled, instead of fetching engine_module.wasm. */
  instantiateWasm?(
    imports: WebAssembly.Imports,
    receive: (instance: WebAssembly.Instance, module: WebAssembly.Module) => void,
  ): object;
}

export default function createEngine(options?: EngineOptions): Promise<EngineModule>;
