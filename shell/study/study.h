// SPDX-License-Identifier: MIT
// A study that can be run: its plan, and the problems and searches that the plan names. The command line's
// `compare` and the page's lab run the same one, so that they find, and write, the same.
#pragma once

#include "core/document/document.h"
#include "shell/study/study_file.h"

namespace gaitsmith::shell {

struct Study {
  StudyPlan plan;
  /// Each document holds its problem alone, and the controller to start from if its search asks for one.
  std::vector<Document> problems;
  std::vector<SearchSettings> searches;  // but for `seed` and `start`
};

/// What a trial needs of a document. Names, the motion shown and its view decide nothing.
[[nodiscard]] Document OnlyProblem(const Document&);

/// The document that a trial's search is for. @param problem, search indices in the study
[[nodiscard]] Document TrialDocument(const Study&, std::size_t problem, std::size_t search,
                                     std::uint32_t seed);

/// For StudyPlan::fingerprint, once all else is there.
[[nodiscard]] std::string FingerprintOf(const Study&);

}  // namespace gaitsmith::shell
