// SPDX-License-Identifier: MIT
// Written by web/build/border.mjs from shell/host/page.cpp and shell/host/page_typeface.cpp: change those.

/** An address in the module's memory; 0 is null. */
export type Pointer = number;

export interface AppExports {
  /** 0: there is no canvas that WebGL draws on, and none of the other functions may be called. */
  _gs_running(): number;
  /**
   * Opens JSON, a link or the payload of one. @return an empty text, or a sentence that says what is wrong and
   * where
   */
  _gs_open(text: Pointer, bytes: number): Pointer;
  _gs_document_json(): Pointer;
  /** The payload of a link, without an address. */
  _gs_link(): Pointer;
  /** 16 hexadecimal digits of the shown motion. */
  _gs_hash(): Pointer;
  _gs_title(): Pointer;
  /** Every visible widget of the last frame, as a JSON list. */
  _gs_widgets(): Pointer;
  /** Everything on the canvas, in and out of sight, as WidgetRegistry::MirrorJson; empty: as at the last call. */
  _gs_mirror(): Pointer;
  /** As by a click. */
  _gs_activate(id: Pointer): number;
  /** As by arrow keys. */
  _gs_step(id: Pointer, steps: number, again: number): number;
  /** @param value  as of WidgetRange */
  _gs_set_value(id: Pointer, value: number, again: number): number;
  /** @param ring  it shows that it has the keyboard */
  _gs_focus(id: Pointer, ring: number): number;
  /** The keyboard is elsewhere on the page: nothing on the canvas shows a ring. */
  _gs_unfocus(): void;
  /** Closes an open list. @return 0: there is none */
  _gs_dismiss(): number;
  /** The moment on the stage in words, short or in full. */
  _gs_moment(): Pointer;
  _gs_description(): Pointer;
  _gs_playing(): number;
  /** @param palette a PaletteName */
  _gs_set_theme(palette: number, scale: number): void;
  /**
   * Everything is said in another language from now on. @param table of shell/languages, as JSON; empty:
   * English
   * @return 0: it is no such table, and nothing has changed
   */
  _gs_set_language(table: Pointer): number;
  /** Draws no more often than this; 0: as often as the display does. */
  _gs_set_frame_rate(perSecond: number): void;
  _gs_play(playing: number): void;
  _gs_can_undo(): number;
  _gs_undo(): void;
  _gs_can_redo(): number;
  _gs_redo(): void;
  /** What is open now is where Undo ends. */
  _gs_forget_past(): void;
  /** What can be done without a control, as CommandsJson. */
  _gs_commands(): Pointer;
  /** @return 0: no such command, or not possible now */
  _gs_run(id: Pointer): number;
  /** A key went down. @param name as in Command::keys. @return 1 when a command took it */
  _gs_key(name: Pointer, onCanvas: number, repeated: number): number;
  /** @param options JSON object or empty text. @return an empty text or a sentence */
  _gs_synthesize(options: Pointer): Pointer;
  /**
   * Adds a search to the queue, with these options in place of the document's own. @param options JSON object
   * @return an empty text or a sentence
   */
  _gs_enqueue(options: Pointer): Pointer;
  /** What waits, as QueueJson. */
  _gs_queue(): Pointer;
  /** What was found, the newest first, as FoundJson. */
  _gs_found(): Pointer;
  /** @return 0: there is no such result */
  _gs_show_found(id: Pointer): number;
  /** @param options JSON object: id, name. @return an empty text, or why not */
  _gs_rename_found(options: Pointer): Pointer;
  /** A found motion of an earlier visit. @return its id; empty: the text is none */
  _gs_restore_found(text: Pointer): Pointer;
  /** What is shown and locked. @param options JSON object. @return an empty text, or a sentence */
  _gs_arrange(options: Pointer): Pointer;
  /** The motion shown in numbers, as MeasuresJson. */
  _gs_measures(): Pointer;
  /**
   * Starts the lab; one that runs is stopped first. @param options JSON object
   * @return an empty text, or a sentence, and then nothing has changed
   */
  _gs_lab(options: Pointer): Pointer;
  /** The lab's curves so far, as a file. */
  _gs_lab_csv(): Pointer;
  /** As of LabState. */
  _gs_lab_state(): number;
  _gs_pause(): void;
  _gs_resume(): void;
  _gs_stop(): void;
  /**
   * How far the search is, as DecodeProgress takes it. @return an empty text, or what is wrong with the
   * report, which then changes nothing
   */
  _gs_search_progress(report: Pointer, bytes: Pointer, count: number): Pointer;
  /** A part of a transition map: scores of places from `first` on, and the score that is usual. */
  _gs_transitions_mapped(generation: number, first: number, scores: Pointer, count: number, usual: number): void;
  /** Nothing more comes of the map of this generation. */
  _gs_transitions_failed(generation: number): void;
  /** A TrueType file. */
  _gs_typeface(semibold: number): Pointer;
  _gs_typeface_size(semibold: number): number;
}
