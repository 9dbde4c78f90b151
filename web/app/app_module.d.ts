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
