// SPDX-License-Identifier: MIT
// One file of a study as text: rows of finished trials, whoever ran them and in whatever order.
#pragma once

#include <map>
#include <span>

#include "core/rollout/ground_use.h"
#include "core/search/search.h"
#include "shell/study/study_plan.h"

namespace gaitsmith::shell {

/// What a trial found.
struct TrialResult {
  float best;          // fitness
  Terms terms;         // of the best motion
  GroundUse ground;    // likewise
  std::uint64_t hash;  // of its trajectory
  std::span<const Search::CurvePoint> curve;
  std::string link = {};  // of the motion's document; of kMotions alone
};
/// The trial's rows in one of the files. Points of the curve before any score have none.
[[nodiscard]] std::string RowsOf(const StudyPlan&, StudyTable, std::size_t trial, const TrialResult&);

/// The best so far at each point of the plan: a step function.
/// @param before what stands at points before any score
[[nodiscard]] std::vector<float> BestAtPoints(const StudyPlan&, std::span<const Search::CurvePoint> curve,
                                              float before);

/// One field of a row that was checked, counted from 0 as the heading names them; the line's end is none.
[[nodiscard]] std::string_view FieldOf(std::string_view row, int field);

/// The fitness in a row of results or motions that was checked.
[[nodiscard]] double BestIn(std::string_view row);

/// How a file may end.
enum class Ending {
  kWhole,  // with a finished trial
  kTorn,   // anywhere: whoever wrote it may have been killed, or goes on writing
};

struct StudyFile {
  StudyPlan plan;
  StudyTable table;
  struct Rows {
    std::string text;
    std::size_t line;  // of the first, from 1
  };
  std::map<std::size_t, Rows> trials = {};  // by canonical index
  std::size_t whole_bytes = 0;              // read until the end of the last finished trial

  /// Every row is checked. @param path for the error, which names file and line
  [[nodiscard]] static Result<StudyFile> Parse(std::string_view text, const std::string& path, Ending);

  /// Heading and rows in canonical order: the same bytes for the same trials.
  [[nodiscard]] std::string Text() const;
};

}  // namespace gaitsmith::shell
