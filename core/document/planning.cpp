// SPDX-License-Identifier: MIT
#include "core/document/planning.h"

#include <utility>

namespace gaitsmith {

Result<void> CanBePlanned(const Document& d) {
  if (d.plan.Empty()) return Fail(ErrorCode::kMissing, "plan", "has no keyframe");
  if (d.figure.Joints() == 0) return Fail(ErrorCode::kMissing, "figure", "has no joint that could move it");
  return CheckScene(SceneOf(d));
}

void CarryOutPlan(const Document& document, const PlanGrid& fine, const PlanListener& listener) {
  using Stage = PlanReport::Stage;
  const PlanScene scene = SceneOf(document);
  PlanReport report{.document = document};
  bool wanted = true;
  const auto tell = [&](Stage stage) {
    report.stage = stage;
    wanted = wanted && listener(report);
    return wanted;
  };
  const auto watch = [&](const PlannedMotion& motion, int) {
    ++report.iterations;
    report.document = WithSolution(document, motion);
    return tell(Stage::kRelaxing);
  };

  std::optional<PlannedMotion> motion;
  if (!document.plan.solved.unknowns.empty()) motion = SolvedMotion(document);
  for (const auto& [stage, grid] : {std::pair{Stage::kCoarse, PlanGrid{}}, std::pair{Stage::kFine, fine}}) {
    PlanAnswer answer = SolvePlan(scene, grid, motion ? &*motion : nullptr, watch);
    if (!wanted) return;
    report.cost = answer.cost;
    if (!answer.motion) {
      report.document = document;
      report.misses = std::move(answer.misses);
      static_cast<void>(tell(Stage::kRefused));
      return;
    }
    motion = std::move(answer.motion);
    report.document = WithSolution(document, *motion);
    if (!tell(stage)) return;
  }
  PlanPlayback playback = PlayPlan(document, *motion, [&](const PlannedMotion&, int) {
    ++report.iterations;
    return tell(Stage::kRelaxing);
  });
  if (!wanted) return;
  report.document = std::move(playback.document);
  report.played_miss_m = playback.miss_m;
  report.first_miss_m = playback.first_m;
  report.corrections = playback.corrections;
  static_cast<void>(tell(Stage::kPlayed));
}

}  // namespace gaitsmith
