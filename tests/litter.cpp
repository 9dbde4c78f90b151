// SPDX-License-Identifier: MIT
#include "tests/litter.h"

#include "core/rollout/evaluator.h"
#include "core/search/evaluation_score.h"

namespace gaitsmith::test {

std::vector<Brood::Member> ChildrenOf(const Document& nursery) {
  const auto brood = BroodOf(nursery);
  const Evaluator evaluator(NurseryProblem(nursery));
  while (!brood->Done()) {
    std::vector<Score> scores;
    for (const Evaluation& one : evaluator.Evaluate(brood->Ask(64))) scores.push_back(ScoreOf(one));
    brood->Tell(scores);
  }
  return brood->Children();
}

}  // namespace gaitsmith::test
