// SPDX-License-Identifier: MIT
// What `gaitsmith compare --summary` says of finished trials.
#pragma once

#include <string>
#include <vector>

#include "shell/study/running_time.h"
#include "shell/study/study_file.h"

namespace gaitsmith::shell {

struct SummaryRequest {
  std::vector<std::string> paths;     // of files of results, or of curves
  std::vector<std::string> searches;  // only these; empty: all
  std::string ranks = {};             // file for the diagram of ranks; empty: none
  std::string ioh = {};               // folder for IOHanalyzer; empty: none
};

/// Prints tables: of results how good each search was and which differences are more than luck, of curves how
/// soon searches reach targets.
[[nodiscard]] Result<void> Summarize(const SummaryRequest&);

/// All finished trials of one search on one problem, from one file.
struct Sample {
  std::string problem, search, file;
  std::vector<std::uint32_t> seeds = {};
  std::vector<double> best = {};      // of each trial
  std::vector<Progress> curves = {};  // of each trial, from files of curves only
  const StudyPlan* plan = nullptr;    // of its file
};

/// The problems of some samples, in their order.
[[nodiscard]] std::vector<std::string> ProblemsOf(const std::vector<Sample>&);
/// The samples of one problem, in their order.
[[nodiscard]] std::vector<const Sample*> OnProblem(const std::vector<Sample>&, const std::string& problem);

/// "start,1.5,2\n" with six digits
[[nodiscard]] std::string SummaryLine(const std::string& start, std::initializer_list<double> values);

/// How soon searches reach targets, as two tables. @param samples of curves
[[nodiscard]] std::string RunningTimes(const std::vector<Sample>& samples);

/// Writes one folder for each search, in the format that IOHanalyzer reads [Doerr et al. 2018].
[[nodiscard]] Result<void> WriteIoh(const std::string& folder, const std::vector<Sample>& samples);

}  // namespace gaitsmith::shell
