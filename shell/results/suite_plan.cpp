// SPDX-License-Identifier: MIT
#include "shell/results/suite_plan.h"

#include <algorithm>

#include "core/document/style_weights.h"
#include "shell/results/search_queue.h"

namespace gaitsmith::shell {

int SuiteChoice::Searches() const {
  const auto count = [](const auto& chosen) { return static_cast<int>(std::ranges::count(chosen, true)); };
  return count(senses) * count(tasks) * count(styles);
}

std::vector<Document> SuiteOf(const Document& document, const SuiteChoice& choice) {
  Document base = SearchOf(document);
  base.search.start = -1;  // a controller to start from fits at most one combination
  base.controllers.clear();
  std::vector<Document> suite;
  suite.reserve(static_cast<std::size_t>(choice.Searches()));
  for (std::size_t s = 0; s < kSuiteSenses.size(); ++s) {
    for (std::size_t t = 0; t < kSuiteTasks.size(); ++t) {
      for (std::size_t y = 0; y < kSuiteStyles.size(); ++y) {
        if (!choice.senses[s] || !choice.tasks[t] || !choice.styles[y]) continue;
        Document one = base;
        one.senses.kind = kSuiteSenses[s];
        const bool timer = one.senses.kind == SenseKind::kTimer;
        if (one.kind == (timer ? ControllerKind::kNetwork : ControllerKind::kTrajectory))
          one.kind = ControllerKind::kRules;
        one.task.kind = kSuiteTasks[t];
        const auto term = static_cast<std::size_t>(kSuiteStyles[y].term);
        one.task.weights = {};
        one.task.weights[term] = kSuiteStyles[y].units * UsualWeights(one)[term];
        suite.push_back(std::move(one));
      }
    }
  }
  return suite;
}

}  // namespace gaitsmith::shell
