// SPDX-License-Identifier: MIT
// The plan of a study: every search on every problem, with a number of seeds. The first line of each of its
// files holds the plan, which is enough to continue, merge or judge a file.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/numeric/error.h"

namespace gaitsmith::shell {

inline constexpr int kMaxTrials = 1'000'000;  // limit for one search on one problem
inline constexpr int kMaxPoints = 100'000;
inline constexpr int kMaxEvaluations = 100'000'000;
inline constexpr std::size_t kMaxShards = 1'000'000'000;

/// The kinds of files of a study.
enum class StudyTable {
  kResults,  // a row for each trial: the score of its best motion
  kCurves,   // rows for each trial: the best score so far at several evaluation counts
  kMotions,  // a row for each trial: its result, and the motion itself as a link
};
/// "results"
[[nodiscard]] std::string_view NameOf(StudyTable);

struct StudyPlan {
  std::string fingerprint;       // 16 hexadecimal digits computed from everything that affects the results
  std::uint32_t first_seed = 1;  // of the first trial; the others count up from it
  int trials = 1;                // of each search on each problem, [1, kMaxTrials]
  int evaluations = 1;           // of each trial, [1, kMaxEvaluations]
  int points = 1;                // of a curve, [1, evaluations], at most kMaxPoints
  std::vector<std::string> problems, searches;  // labels, as of IsLabel, no two the same

  struct Trial {
    std::size_t problem, search;
    std::uint32_t seed;
  };
  [[nodiscard]] std::size_t Total() const;
  /// Trials in canonical order: by problem, search, seed. @param index below Total()
  [[nodiscard]] Trial At(std::size_t index) const;
  /// The index of a trial; nothing if the trial is not in this study.
  [[nodiscard]] std::optional<std::size_t> Find(std::string_view problem, std::string_view search,
                                                std::uint32_t seed) const;
  /// The number of evaluations at a point of the curve; the last point is the whole budget.
  /// @param point [0, points)
  [[nodiscard]] int EvaluationsAt(int point) const;
};

/// The part of a study's trials that one task runs: the trials first, first + of, first + 2 of, …
struct Shard {
  std::size_t first = 0, of = 1;  // first < of

  bool operator==(const Shard&) const = default;
  [[nodiscard]] bool Holds(std::size_t trial) const { return trial % of == first; }
  /// The number of its trials. @param total of the study
  [[nodiscard]] std::size_t Due(std::size_t total) const;
};
/// "3/64", counted from 1
[[nodiscard]] std::string NameOf(const Shard&);
/// @param text such as "3/64"
[[nodiscard]] std::optional<Shard> ParseShard(std::string_view text);

/// Whether a label is valid in a CSV and in a heading: not empty, no blank, comma, quote or control
/// character.
[[nodiscard]] bool IsLabel(std::string_view);

/// The first two lines of a file: the comment and the names of the columns. A shard of several is named, so
/// that a lost file can be named too.
[[nodiscard]] std::string Heading(const StudyPlan&, StudyTable, const Shard& shard = {});

struct ReadHeading {
  StudyPlan plan;
  StudyTable table;
  Shard shard;  // the whole if none is named
};
/// @param text begins with the two lines. The error's `where` is left empty
[[nodiscard]] Result<ReadHeading> ParseHeading(std::string_view text);

}  // namespace gaitsmith::shell
