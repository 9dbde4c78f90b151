// SPDX-License-Identifier: MIT
#include "core/planning/planning.h"

#include <utility>

namespace gaitsmith {

Result<void> CanBePlanned(const Document& d) {
  if (d.figure.HasSprings())
    return Fail(ErrorCode::kStructure, "plan", "figures of springs have no keyframes");
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
  const auto take = [&](PlanAnswer answer) {
    report.cost = answer.cost;
    motion = std::move(answer.motion);
    report.document = WithSolution(document, *motion);
  };
  PlanAnswer coarse = SolvePlan(scene, {}, motion ? &*motion : nullptr, watch);
  if (!wanted) return;
  if (!coarse.motion) {
    report.document = document;
    report.misses = std::move(coarse.misses);
    static_cast<void>(tell(Stage::kRefused));
    return;
  }
  take(std::move(coarse));
  if (!tell(Stage::kCoarse)) return;
  // Where the finest does not converge, a lower degree may. What obeys the laws coarsely is good enough.
  for (const int degree : {fine.degree, 3}) {
    PlanAnswer answer = SolvePlan(scene, {degree, fine.pieces_per_second}, &*motion, watch);
    if (!wanted) return;
    if (!answer.motion) continue;
    take(std::move(answer));
    break;
  }
  report.document = WithSolution(document, *motion);
  if (!tell(Stage::kFine)) return;
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
