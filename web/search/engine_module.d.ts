// SPDX-License-Identifier: MIT
// Types of engine_module.js, the module that Emscripten makes of engine.cpp. Pointers and sizes are numbers into
// the module's memory; engine.cpp says what each function does and how long its result lives.

import type { EngineExports, Pointer } from './engine_exports.js';

export type { Pointer };

export interface EngineModule extends EngineExports {
  readonly HEAPU8: Uint8Array;
}

export interface EngineOptions {
  /** Instantiates a module that was compiled elsewhere instead of fetching engine_module.wasm. */
  instantiateWasm?(
    imports: WebAssembly.Imports,
    receive: (instance: WebAssembly.Instance, module: WebAssembly.Module) => void,
  ): object;
}

export default function createEngine(options?: EngineOptions): Promise<EngineModule>;
