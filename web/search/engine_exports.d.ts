// SPDX-License-Identifier: MIT
// Written by web/build/border.mjs from web/search/engine.cpp and web/search/engine_motion.cpp and web/search/engine_files.cpp and web/search/engine_breeding.cpp: change those.

/** An address in the module's memory; 0 is null. */
export type Pointer = number;

export interface EngineExports {
  _gs_input(size: number): Pointer;
  _gs_error(): Pointer;
  /** @return the document's bytes, gs_document_size() of them */
  _gs_document_from_text(size: number): Pointer;
  _gs_document_size(): number;
  /** The document as JSON, ending with a 0 byte. */
  _gs_document_json(size: number): Pointer;
  /** The payload of a document's link, ending with a 0 byte. */
  _gs_document_link(size: number): Pointer;
  /** @param traits whether they are measured, too, as they are for searches that need them */
  _gs_evaluator_open(size: number, traits: number): Pointer;
  _gs_evaluator_close(role: Pointer): void;
  _gs_evaluator_genes(role: Pointer): number;
  /**
   * Scores `count` genomes that lie one after another in the input area, 16 bits a gene.
   * @return `count` scores of floats: fitness, greatest height, slip, rotations, then the traits; null if the
   * input is too short
   */
  _gs_evaluator_run(role: Pointer, count: number): Pointer;
  _gs_search_open(size: number): Pointer;
  /**
   * A document that shows the genome that follows, which a search of the document may have found.
   * @return its bytes, gs_document_size() of them
   */
  _gs_shown(size: number): Pointer;
  _gs_search_close(role: Pointer): void;
  _gs_search_genes(role: Pointer): number;
  _gs_search_budget(role: Pointer): number;
  /**
   * @return the number of genomes to score next, which gs_search_genomes() returns. 0 while every proposal
   * depends on scores that have not arrived; only some searches can propose genomes before then
   * (gs_search_asks_ahead)
   */
  _gs_search_ask(role: Pointer, wanted: number): number;
  _gs_search_asks_ahead(role: Pointer): number;
  _gs_search_genomes(role: Pointer): Pointer;
  /**
   * Takes a score for each genome of the oldest ask without scores, in its order, from the input area: its
   * floats as gs_evaluator_run returns them, or the fitness alone for searches that need no more. Call once
   * for each ask.
   * @param count floats
   */
  _gs_search_tell(role: Pointer, count: number): number;
  /** Scores the genomes of the last ask here and tells the search. No other ask may be open. */
  _gs_search_score(role: Pointer): number;
  _gs_search_evaluations(role: Pointer): number;
  _gs_search_done(role: Pointer): number;
  _gs_search_best_fitness(role: Pointer): number;
  /** @return gs_search_genes() genes, or null before the first tell */
  _gs_search_best_genome(role: Pointer): Pointer;
  /** The points of the best-so-far curve, each an int (evaluation) and a float (best). */
  _gs_search_curve_length(role: Pointer): number;
  _gs_search_curve(role: Pointer): Pointer;
  /**
   * The spread of the population's fitness as JSON (core/document/spread_json.h), ending with a 0 byte; null
   * if there is none.
   */
  _gs_search_spread(role: Pointer): Pointer;
  /** The whole state of the search. Call between a tell and an ask. */
  _gs_search_save(role: Pointer): Pointer;
  _gs_search_saved_size(role: Pointer): number;
  /**
   * Continues from a saved state in the input area, which must come from the same document. Earlier asks are
   * forgotten.
   */
  _gs_search_load(role: Pointer, size: number): number;
  _gs_map_open(size: number): Pointer;
  _gs_map_close(role: Pointer): void;
  _gs_map_count(role: Pointer): number;
  _gs_map_usual_score(role: Pointer): number;
  /** @return `count` scores, in the map's order; null if the map has no such places */
  _gs_map_run(role: Pointer, first: number, count: number): Pointer;
  _gs_motion_open(size: number): Pointer;
  _gs_motion_close(role: Pointer): void;
  _gs_motion_frames(role: Pointer): number;
  /** A figure of springs has none. */
  _gs_motion_rods(role: Pointer): number;
  /** Ends of rods, or nodes. */
  _gs_motion_endpoints(role: Pointer): number;
  /** For each rod the endpoint at its start; rod i ends at endpoint i + 1. */
  _gs_motion_starts(role: Pointer): Pointer;
  /** For each frame: the active controller (-1: none), the centre of mass, every endpoint [m]. */
  _gs_motion_numbers(role: Pointer): Pointer;
  /** The corners of a drawn ground from left to right, x and y of each [m]; level ground has none. */
  _gs_motion_ground(role: Pointer): Pointer;
  _gs_motion_corners(role: Pointer): number;
  /**
   * The figure's outline in a frame: gs_motion_body_size() numbers, 8 for each part of BodyPartsOf and for its
   * eye: x, y, radius at both ends [m], how far the radius swells halfway [m], and 0 for a near part, 1 for a
   * far one, 2 for the eye.
   * @param frame clamped to the motion
   */
  _gs_motion_body(role: Pointer, frame: number): Pointer;
  /** How far the outline reaches below the endpoints on which the figure stands [m]. */
  _gs_motion_sole(role: Pointer): number;
  /** Of the last gs_motion_body(). */
  _gs_motion_body_size(role: Pointer): number;
  /** The terms of the whole motion by name, whether its simulation failed, and its hash, as JSON. */
  _gs_motion_measures(role: Pointer): Pointer;
  _gs_motion_text_size(role: Pointer): number;
  /**
   * The motion that is planned between the document's keyframes instead of the played one. A plan without a
   * solution is an error.
   */
  _gs_motion_open_planned(size: number): Pointer;
  /**
   * One cycle of the motion, closed (core/gait/document_loop.h). An error says why it has none.
   * @param halves   make the second half of the first one @param in_place without its way
   */
  _gs_motion_open_loop(size: number, halves: number, inPlace: number): Pointer;
  /**
   * What is known of a loop: its period [s], distance [m], turns, likeness, gap and slide [longest rod], and
   * whether the controller had to run on to find it; "null" for a whole motion. As JSON.
   */
  _gs_motion_loop(role: Pointer): Pointer;
  /** @param words_size bytes of FilmStripWords in the input area, with a 0 byte after each */
  _gs_motion_film_strip(role: Pointer, wordsSize: number, poses: number): Pointer;
  /** A file that needs no words. @param id_size of an exporter's id in the input area */
  _gs_motion_file(role: Pointer, idSize: number): Pointer;
  /**
   * The sprite sheet. Numbers outside of their ranges (shell/export/sprite_sheet.h) are moved to their ends.
   * @param size the longer side of a frame [px]
   */
  _gs_motion_sprites(role: Pointer, frames: number, size: number): Pointer;
  /**
   * The nursery of a round of the document's lineage. The genomes are the children of the round's parent.
   * @return the nursery's bytes, gs_document_size() of them
   */
  _gs_nursery(size: number, round: number): Pointer;
  /**
   * A document that shows the child with the genome that follows. @return its bytes, gs_document_size() of
   * them
   */
  _gs_child(size: number): Pointer;
  /** A search for the children of a nursery (core/breeding/litter.h). Its evaluators must measure traits. */
  _gs_brood_open(size: number): Pointer;
  /**
   * The children of a brood: how many, their genomes one after another, and their scores as
   * gs_evaluator_run returns them.
   */
  _gs_brood_children(role: Pointer): number;
  _gs_brood_scores(role: Pointer): Pointer;
  /** Names, units and scales of the traits, as a JSON list, ending with a 0 byte. */
  _gs_traits(): Pointer;
  /** The traits of a document's motion, kTraits floats; null if it has none. */
  _gs_document_traits(size: number): Pointer;
  /**
   * Learns from `count` comparisons in the input area: the traits of two motions, then the place of the
   * verdict in kVerdictNames, as floats.
   */
  _gs_taste_open(count: number): Pointer;
  _gs_taste_close(role: Pointer): void;
  /** A number for each trait, as Taste::Weights and Taste::Doubts. */
  _gs_taste_weights(role: Pointer): Pointer;
  _gs_taste_doubts(role: Pointer): Pointer;
  /** How much a comparison of two motions would tell, whose traits are in the input area; -1 if they are not. */
  _gs_taste_telling(role: Pointer): number;
  /** The document with the taste as the weights of its task. @return its bytes, gs_document_size() of them */
  _gs_taste_document(role: Pointer, size: number): Pointer;
}
