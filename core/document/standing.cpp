// SPDX-License-Identifier: MIT
#include "core/document/standing.h"

namespace gaitsmith {

void BeginWithQuickSearch(SearchSettings& search) {
  search.algorithm = Algorithm::kPoseCycle;
  search.evaluations = kQuickEvaluations;
}

Document Standing(const Figure& figure) {
  constexpr std::uint32_t kSeed = 4;  // its ostrich runs as birds do, without diving or crawling
  Document document;
  document.title = figure.name;
  SetFigure(figure, document);
  document.task = {.kind = TaskKind::kTravelRight, .duration_steps = 800};
  document.duration_steps = document.task.duration_steps;
  document.search.seed = kSeed;
  BeginWithQuickSearch(document.search);
  return document;
}

}  // namespace gaitsmith
