// SPDX-License-Identifier: MIT
// Types of app_module.js, the module that Emscripten makes of shell/. shell/host/page.cpp is the other side of this
// border and says what each function does.

import type { AppExports, Pointer } from './app_exports.js';

export type { Pointer };

export interface AppModule extends AppExports {
  readonly HEAPU8: Uint8Array;
  UTF8ToString(text: Pointer): string;
  stringToNewUTF8(text: string): Pointer;
  _malloc(size: number): Pointer;
  _free(at: Pointer): void;
}

/** What the application calls on the page: shell/workspace/host.h, in JavaScript. */
export interface PageForApp {
  /** Most workers that make sense here. */
  maxWorkers(): number;
  /** Runs a document (in binary form). Stops the running search first. */
  startSearch(document: Uint8Array, workers: number): void;
  /** Runs a trial of the lab like a search. The application may request the next trial during the final report of this one. */
  startTrial(document: Uint8Array, workers: number, trial: { words: string, finished: number, total: number }): void;
  /** Runs a search whose reports only the application reads. */
  startPreview(document: Uint8Array, workers: number): void;
  /** Runs a search of the queue. The application may request the next search during the final report of this one. */
  startQueued(document: Uint8Array, workers: number, words: string): void;
  /** Stores a found motion for the next visit. An empty text removes it. */
  storeFound(id: string, text: string): void;
  /** Opens a dialog by the command of the page that does so. */
  learnFrom(id: string, more: boolean): void;
  openDialog(command: string): void;
  askName(id: string, name: string, usual: string): void;
  /** The lab is over, and has no more trials. */
  labEnded(): void;
  /** Gives the reader a file. */
  saveText(name: string, text: string): void;
  pauseSearch(): void;
  resumeSearch(): void;
  stopSearch(): void;
  /** Computes the transition map of the clip that the document's search names. Abandons an unfinished map. */
  startTransitionMap(document: Uint8Array, generation: number): void;
  stopTransitionMap(): void;
  /** Carries out the document's plan. Abandons an unfinished one. */
  startPlan(document: Uint8Array, generation: number): void;
  stopPlan(): void;
  /** A sentence for the status line. */
  status(sentence: string): void;
  /** The document was replaced or edited. */
  documentChanged(title: string): void;
  firstFrame(): void;
  /** The keyboard leaves the canvas: 1: forwards, -1: backwards, 0: no direction. */
  leaveCanvas(direction: number): void;
}

export default function createApp(options: {
  canvas: HTMLCanvasElement;
  /** Instantiates code that was compiled already. */
  instantiateWasm(imports: WebAssembly.Imports, receive: (instance: WebAssembly.Instance, module: WebAssembly.Module) => void): object;
  page: PageForApp;
  onAbort?(reason: unknown): void;
}): Promise<AppModule>;
