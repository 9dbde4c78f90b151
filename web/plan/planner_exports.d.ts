// SPDX-License-Identifier: MIT
// Written by web/build/border.mjs from web/plan/planner.cpp: change those.

/** An address in the module's memory; 0 is null. */
export type Pointer = number;

export interface PlannerExports {
  /** The input area: the caller writes a document there, then calls gs_plan. */
  _gs_input(size: number): Pointer;
  /**
   * Carries out the plan of the document in the first bytes of the input area.
   * @return false: core refuses the document, or its plan
   */
  _gs_plan(size: number): number;
}
