// SPDX-License-Identifier: MIT
// Types of engine_module.js, the module that Emscripten makes of engine.cpp. Pointers and sizes are numbers into
// the module's memory; engine.cpp says what each function does and how long its result lives.

/** An address in the module's memory; 0 is null. */
export type Pointer = number;

export interface EngineModule {
  readonly HEAPU8: Uint8Array;

  _gs_input(size: number): Pointer;
  _gs_error(): Pointer;

  _gs_document_from_text(size: number): Pointer;
  _gs_document_size(): number;

  _gs_evaluator_open(size: number): Pointer;
  _gs_evaluator_close(evaluator: Pointer): void;
  _gs_evaluator_genes(evaluator: Pointer): number;
  _gs_evaluator_run(evaluator: Pointer, count: number): Pointer;

  _gs_search_open(size: number): Pointer;
  _gs_search_close(search: Pointer): void;
  _gs_search_genes(search: Pointer): number;
  _gs_search_budget(search: Pointer): number;
  _gs_search_ask(search: Pointer, wanted: number): number;
  _gs_search_asks_ahead(search: Pointer): number;
  _gs_search_genomes(search: Pointer): Pointer;
  _gs_search_tell(search: Pointer, count: number): number;
  _gs_search_evaluations(search: Pointer): number;
  _gs_search_done(search: Pointer): number;
  _gs_search_best_fitness(search: Pointer): number;
  _gs_search_best_genome(search: Pointer): Pointer;
  _gs_search_curve_length(search: Pointer): number;
  _gs_search_curve(search: Pointer): Pointer;
  _gs_search_spread(search: Pointer): Pointer;
  _gs_search_save(search: Pointer): Pointer;
  _gs_search_saved_size(search: Pointer): number;
  _gs_search_load(search: Pointer, size: number): number;

  _gs_map_open(size: number): Pointer;
  _gs_map_close(map: Pointer): void;
  _gs_map_count(map: Pointer): number;
  _gs_map_usual_score(map: Pointer): number;
  _gs_map_run(map: Pointer, first: number, count: number): Pointer;

  _gs_motion_open(size: number): Pointer;
  _gs_motion_close(motion: Pointer): void;
  _gs_motion_frames(motion: Pointer): number;
  _gs_motion_rods(motion: Pointer): number;
  _gs_motion_starts(motion: Pointer): Pointer;
  _gs_motion_numbers(motion: Pointer): Pointer;
  _gs_motion_film_strip(motion: Pointer, wordsSize: number, poses: number): Pointer;
  _gs_motion_gltf(motion: Pointer): Pointer;
  _gs_motion_csv(motion: Pointer): Pointer;
  _gs_motion_text_size(motion: Pointer): number;
}

export interface EngineOptions {
  /** Instantiates a module that was compiled elsewhere instead of fetching engine_module.wasm. */
  instantiateWasm?(
    imports: WebAssembly.Imports,
    receive: (instance: WebAssembly.Instance, module: WebAssembly.Module) => void,
  ): object;
}

export default function createEngine(options?: EngineOptions): Promise<EngineModule>;
