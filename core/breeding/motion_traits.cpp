// SPDX-License-Identifier: MIT
#include "core/breeding/motion_traits.h"

#include "core/rollout/evaluator.h"

namespace gaitsmith {

Result<Traits> MotionTraits(const Document& document) {
  if (document.timeline.empty()) return Fail(ErrorCode::kMissing, "timeline", "has no motion");
  const auto first = static_cast<std::size_t>(document.timeline.front().controller);
  const Controller& controller = document.controllers[first];
  Problem problem = ReplayProblem(document, controller);
  problem.traits = true;
  const Evaluation seen = Evaluator(problem).Evaluate(std::vector<Genome>{controller.genes}).front();
  if (!(seen.fitness > kVoidScore)) return Fail(ErrorCode::kOutOfRange, "timeline", "breaks physics");
  return seen.traits;
}

}  // namespace gaitsmith
