// SPDX-License-Identifier: MIT
// Types of planner_module.js, which Emscripten builds from planner.cpp.

import type { Pointer, PlannerExports } from './planner_exports.js';

export type { Pointer };

export interface PlannerModule extends PlannerExports {
  readonly HEAPU8: Uint8Array;
}

export interface PlannerOptions {
  /** Instantiates code that is already compiled. */
  instantiateWasm(
    imports: WebAssembly.Imports,
    receive: (instance: WebAssembly.Instance, module: WebAssembly.Module) => void,
  ): object;
  /** Called during _gs_plan. What it points to is valid until it returns. */
  reported(
    stage: Pointer, letters: number, document: Pointer, bytes: number, iterations: number, cost: number,
    playedMiss: number, firstMiss: number, corrections: number, misses: Pointer, count: number,
  ): void;
}

export default function createPlanner(options: PlannerOptions): Promise<PlannerModule>;
