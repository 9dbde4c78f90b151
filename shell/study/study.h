// SPDX-License-Identifier: MIT
// A study that can be run: its plan, and the problems and searches that the plan names. The command line's
// `compare` and the page's lab run the same study, with the same results and files.
#pragma once

#include "core/document/document.h"
#include "shell/study/study_file.h"

namespace gaitsmith::shell {

struct Study {
  StudyPlan plan;
  /// Each document holds only its problem, and a controller if its search starts from one.
  std::vector<Document> problems;
  std::vector<SearchSettings> searches;  // without `seed` and `start`
};

/// The parts of a document that a trial needs. Names, the shown motion and its view have no effect.
[[nodiscard]] Document OnlyProblem(const Document&);

/// The document that a trial's search is for. @param problem, search indices in the study
[[nodiscard]] Document TrialDocument(const Study&, std::size_t problem, std::size_t search,
                                     std::uint32_t seed);

/// The value of SwitchFile::fingerprint. @param documents whole ones, with their controllers
[[nodiscard]] std::string FingerprintOfSwitches(std::span<const std::string> labels,
                                                std::span<const Document> documents, int times, int length);

/// The value of StudyPlan::fingerprint. Call when all other members are set.
[[nodiscard]] std::string FingerprintOf(const Study&);

}  // namespace gaitsmith::shell
