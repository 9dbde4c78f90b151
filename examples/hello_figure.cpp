// SPDX-License-Identifier: MIT
// The smallest program that uses core: a figure of two rods learns to travel.
#include <cstdio>

#include "core/document/document.h"
#include "core/rollout/evaluator.h"

int main() {
  using namespace gaitsmith;
  Document document;
  document.figure = {"Tail", {Rod{.rest_rad = 0.3f}, Rod{.parent = 0, .rest_rad = -0.6f}}};
  document.search.evaluations = 500;

  const Evaluator evaluator(ProblemOf(document));
  const auto search = MakeSearch(document.search, SpaceOf(document));
  while (!search->Done()) {
    std::vector<float> fitness;
    for (const Evaluation& one : evaluator.Evaluate(search->Ask(40))) fitness.push_back(one.fitness);
    search->Tell(fitness);
  }
  std::printf("moved %.2f m in %g s\n", static_cast<double>(search->BestFitness()), 5.0);
  return search->BestFitness() > 0.0f ? 0 : 1;
}
