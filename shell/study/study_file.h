// SPDX-License-Identifier: MIT
// One file of a study as text: rows of finished trials, from any machine and in any order.
#pragma once

#include <map>
#include <span>

#include "core/rollout/ground_use.h"
#include "core/search/search.h"
#include "shell/study/study_plan.h"

namespace gaitsmith::shell {

/// The result of a trial.
struct TrialResult {
  float best;          // fitness of the best motion
  Terms terms;         // of the best motion
  GroundUse ground;    // of the best motion
  std::uint64_t hash;  // hash of its trajectory
  std::span<const Search::CurvePoint> curve;
  std::string link = {};  // link to the motion's document; only in kMotions
};
/// The trial's rows in one of the files. Points of the curve before the first score have no row.
[[nodiscard]] std::string RowsOf(const StudyPlan&, StudyTable, std::size_t trial, const TrialResult&);

/// The best so far at each point of the plan, as a step function.
/// @param before value of points before the first score
[[nodiscard]] std::vector<float> BestAtPoints(const StudyPlan&, std::span<const Search::CurvePoint> curve,
                                              float before);

/// One field of a checked row, counted from 0 as in the heading, without the line's end.
[[nodiscard]] std::string_view FieldOf(std::string_view row, int field);

/// The field of a checked row of motions that holds the link.
inline constexpr int kLinkField = 12;

/// The fitness in a checked row of results or motions.
[[nodiscard]] double BestIn(std::string_view row);

/// How a file may end.
enum class Ending {
  kWhole,  // with a finished trial
  kTorn,   // anywhere: the writer may have been killed, or may still be writing
};

struct StudyFile {
  StudyPlan plan;
  StudyTable table;
  Shard shard = {};  // whose trials the file may hold
  struct Rows {
    std::string text;
    std::size_t line;  // line number of the first row, from 1
  };
  std::map<std::size_t, Rows> trials = {};  // by canonical index
  std::size_t whole_bytes = 0;              // end of the last finished trial

  /// Checks every row. @param path for the error, which names file and line
  [[nodiscard]] static Result<StudyFile> Parse(std::string_view text, const std::string& path, Ending);

  /// "star-man with sphc and seed 3"
  [[nodiscard]] std::string NameOfTrial(std::size_t trial) const;

  /// Heading and rows in canonical order. The same trials give the same bytes.
  [[nodiscard]] std::string Text() const;
};

}  // namespace gaitsmith::shell
