// SPDX-License-Identifier: MIT
// Written by web/build/border.mjs from shell/host/page.cpp and shell/host/page_reports.cpp and shell/host/page_hints.cpp and shell/host/page_typeface.cpp: change those.

/** An address in the module's memory; 0 is null. */
export type Pointer = number;

export interface AppExports {
  /** @return 0: WebGL is unavailable, and no other function may be called */
  _gs_running(): number;
  /**
   * Opens JSON, a link or the payload of a link. @param bred  from the open document
   * @return an empty text, or a sentence with the error and its location
   */
  _gs_open(text: Pointer, bytes: number, bred: number): Pointer;
  _gs_document_json(): Pointer;
  /** The payload of a link, without an address. */
  _gs_link(): Pointer;
  /** The hash of the shown motion, 16 hexadecimal digits. */
  _gs_hash(): Pointer;
  _gs_title(): Pointer;
  /** Every visible widget of the last frame, as a JSON list. */
  _gs_widgets(): Pointer;
  /**
   * All widgets, including those out of view, as WidgetRegistry::MirrorJson; empty: unchanged since the last
   * call.
   */
  _gs_mirror(): Pointer;
  /** Activates a widget, as a click does. */
  _gs_activate(id: Pointer): number;
  /** Steps a widget's value, as arrow keys do. */
  _gs_step(id: Pointer, steps: number, again: number): number;
  /** @param value  in WidgetRange */
  _gs_set_value(id: Pointer, value: number, again: number): number;
  /** @param ring  show the focus ring */
  _gs_focus(id: Pointer, ring: number): number;
  /** The focus is elsewhere on the page: hides the focus ring on the canvas. */
  _gs_unfocus(): void;
  /** Closes an open list, or ends drawing the ground. @return 0: there is nothing to end */
  _gs_dismiss(): number;
  /** Describes the shown moment in words, short or in full. */
  _gs_moment(): Pointer;
  _gs_description(): Pointer;
  _gs_playing(): number;
  /** @param palette of kPaletteNames; another name keeps the present one @param scale of texts and controls */
  _gs_set_theme(palette: Pointer, scale: number): void;
  /**
   * Sets the language of all texts. @param table of shell/words/languages, as JSON; empty: English
   * @return 0: it is not such a table, and nothing has changed
   */
  _gs_set_language(table: Pointer): number;
  /** Sets the greatest frame rate; 0: that of the display. */
  _gs_set_frame_rate(perSecond: number): void;
  _gs_play(playing: number): void;
  _gs_can_undo(): number;
  _gs_undo(): void;
  _gs_can_redo(): number;
  _gs_redo(): void;
  /**
   * Shows the first document of a visit: a shipped motion, or without a name a figure that cannot move yet.
   * Returns 0 if there is no such motion.
   */
  _gs_begin(example: Pointer): number;
  /** Shows the open motion in the viewer, or leaves it for the workbench. */
  _gs_set_viewing(viewing: number): void;
  _gs_viewing(): number;
  /** Whether nothing moves unless a person plays it. */
  _gs_set_calm(calm: number): void;
  /** Makes the open document the last one that Undo reaches. */
  _gs_forget_past(): void;
  /** Undo, Redo and the queue, as StoreVisit. */
  _gs_store_visit(): Pointer;
  /** @return 0: the text is damaged, and nothing has changed */
  _gs_restore_visit(text: Pointer): number;
  /** The commands, as CommandsJson. */
  _gs_commands(): Pointer;
  /** @return 0: there is no such command, or it is unavailable */
  _gs_run(id: Pointer): number;
  /** Handles a key press. @param name as in Command::keys. @return 1 if a command handled it */
  _gs_key(name: Pointer, onCanvas: number, repeated: number): number;
  /** @param options JSON object or empty text. @return an empty text or a sentence */
  _gs_synthesize(options: Pointer): Pointer;
  /**
   * Adds a search to the queue. @param options JSON object, overrides the document's settings
   * @return an empty text or a sentence
   */
  _gs_enqueue(options: Pointer): Pointer;
  /** The waiting searches, as QueueJson. */
  _gs_queue(): Pointer;
  /** The results, newest first, as FoundJson. */
  _gs_found(): Pointer;
  /** @return 0: there is no such result */
  _gs_show_found(id: Pointer): number;
  /** @param options JSON object: id, name. @return an empty text, or the error */
  _gs_rename_found(options: Pointer): Pointer;
  /** Restores a found motion of an earlier visit. @return its id; empty: the text is invalid */
  _gs_restore_found(text: Pointer): Pointer;
  /** Sets the shown panels and the locks. @param options JSON object. @return an empty text, or a sentence */
  _gs_arrange(options: Pointer): Pointer;
  /** The numbers of the shown motion, as MeasuresJson. */
  _gs_measures(): Pointer;
  /**
   * Starts the lab, after stopping a running one. @param options JSON object
   * @return an empty text, or a sentence, with nothing changed
   */
  _gs_lab(options: Pointer): Pointer;
  /** The lab's curves so far, as the text of a file. */
  _gs_lab_csv(): Pointer;
  /** One of kLabStateNames. */
  _gs_lab_state(): Pointer;
  _gs_pause(): void;
  _gs_resume(): void;
  _gs_stop(): void;
  /**
   * Reports the progress of a search in the format of DecodeProgress. @return an empty text, or the error in
   * the report, which is then ignored
   */
  _gs_search_progress(report: Pointer, bytes: Pointer, count: number): Pointer;
  /** Reports a part of a transition map: scores from place `first` on, and the usual score. */
  _gs_transitions_mapped(generation: number, first: number, scores: Pointer, count: number, usual: number): void;
  /** Reports that no more parts of this generation's map will arrive. */
  _gs_transitions_failed(generation: number): void;
  /**
   * Reports how this generation's plan is getting on. @param stage of kPlanStageNames
   * @param document in binary form; of a refused plan 0 bytes @param misses four numbers each
   */
  _gs_plan_reported(generation: number, stage: Pointer, document: Pointer, bytes: number, iterations: number, cost: number, playedMissM: number, firstMissM: number, corrections: number, misses: Pointer, count: number): void;
  /** Reports that this generation's plan will not be carried out. */
  _gs_plan_failed(generation: number): void;
  /** @param table of shell/words/hints, as JSON. @return 0: it is not such a table, and nothing has changed */
  _gs_set_hints(table: Pointer): number;
  /** A TrueType file. */
  _gs_typeface(semibold: number): Pointer;
  _gs_typeface_size(semibold: number): number;
}
