// SPDX-License-Identifier: MIT
// Types of app_module.js, the module that Emscripten makes of shell/. shell/host/page.cpp is the other side of this
// border and says what each function does.

/** An address in the module's memory; 0 is null. */
export type Pointer = number;

export interface AppModule {
  readonly HEAPU8: Uint8Array;
  UTF8ToString(text: Pointer): string;
  stringToNewUTF8(text: string): Pointer;
  _malloc(size: number): Pointer;
  _free(at: Pointer): void;

  _gs_running(): number;
  _gs_open(text: Pointer, bytes: number): Pointer;
  _gs_document_json(): Pointer;
  _gs_link(): Pointer;
  _gs_hash(): Pointer;
  _gs_title(): Pointer;
  _gs_widgets(): Pointer;
  _gs_score(): Pointer;
  _gs_typeface(semibold: number): Pointer;
  _gs_typeface_size(semibold: number): number;
  _gs_mirror(): Pointer;
  _gs_activate(id: Pointer): number;
  _gs_step(id: Pointer, steps: number, again: number): number;
  _gs_set_value(id: Pointer, value: number, again: number): number;
  _gs_focus(id: Pointer, ring: number): number;
  _gs_unfocus(): void;
  _gs_dismiss(): number;
  _gs_moment(): Pointer;
  _gs_description(): Pointer;
  _gs_playing(): number;
  _gs_set_theme(palette: number, scale: number): void;
  _gs_set_language(table: Pointer): number;
  _gs_set_frame_rate(per_second: number): void;
  _gs_play(playing: number): void;
  _gs_can_undo(): number;
  _gs_undo(): void;
  _gs_can_redo(): number;
  _gs_redo(): void;
  _gs_forget_past(): void;
  _gs_commands(): Pointer;
  _gs_run(id: Pointer): number;
  _gs_key(name: Pointer, on_canvas: number, repeated: number): number;
  _gs_synthesize(options: Pointer): Pointer;
  _gs_enqueue(options: Pointer): Pointer;
  _gs_queue(): Pointer;
  _gs_found(): Pointer;
  _gs_show_found(id: Pointer): number;
  _gs_rename_found(options: Pointer): Pointer;
  _gs_restore_found(text: Pointer): Pointer;
  _gs_arrange(options: Pointer): Pointer;
  _gs_measures(): Pointer;
  _gs_lab(options: Pointer): Pointer;
  _gs_lab_csv(): Pointer;
  _gs_lab_state(): number;
  _gs_pause(): void;
  _gs_resume(): void;
  _gs_stop(): void;
  _gs_search_progress(state: number, evaluations: number, budget: number, rate: number, seconds_left: number,
    best: number, curve: Pointer, points: number, genes: Pointer, gene_count: number,
    spread: Pointer, saved: Pointer, saved_bytes: number): void;
  _gs_transitions_mapped(generation: number, first: number, scores: Pointer, count: number, usual: number): void;
  _gs_transitions_failed(generation: number): void;
}

/** What the application calls on the page: shell/session/host.h, in JavaScript. */
export interface PageForApp {
  /** Most workers that make sense here. */
  maxWorkers(): number;
  /** Runs a document (in binary form); a search that runs is dropped. */
  startSearch(document: Uint8Array, workers: number): void;
  /** Runs a trial of the lab like a search; the next one may be asked for while the page reports the end of this one. */
  startTrial(document: Uint8Array, workers: number, trial: { words: string, finished: number, total: number }): void;
  /** Runs a search of the queue; the next one is asked for while the page reports the end of this one. */
  startQueued(document: Uint8Array, workers: number, words: string): void;
  /** A found motion to keep for the next visit; without text: to forget. */
  storeFound(id: string, text: string): void;
  askName(id: string, name: string, usual: string): void;
  /** The lab is over, and has no more trials. */
  labEnded(): void;
  /** Gives the reader a file. */
  saveText(name: string, text: string): void;
  pauseSearch(): void;
  resumeSearch(): void;
  stopSearch(): void;
  /** Works out the transition map of the clip that the document's search names; one that is under way is given up. */
  startTransitionMap(document: Uint8Array, generation: number): void;
  stopTransitionMap(): void;
  /** A sentence for the status line. */
  status(sentence: string): void;
  /** The document is another one, or not the same any more. */
  documentChanged(title: string): void;
  firstFrame(): void;
  /** The keyboard leaves the canvas: 1 forwards, -1 backwards, 0 just away. */
  leaveCanvas(direction: number): void;
}

export default function createApp(options: {
  canvas: HTMLCanvasElement;
  /** Instantiates code that was compiled already. */
  instantiateWasm(imports: WebAssembly.Imports, receive: (instance: WebAssembly.Instance, module: WebAssembly.Module) => void): object;
  page: PageForApp;
  onAbort?(reason: unknown): void;
}): Promise<AppModule>;
