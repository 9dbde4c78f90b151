// SPDX-License-Identifier: MIT
#include "core/planning/plan_recorder.h"

#include <utility>
#include <vector>

#include "core/kinematics/kinematic_recorder.h"
#include "core/planning/plan_playback.h"

namespace gaitsmith {

Motion RecordPlanned(const Document& document, const PlannedMotion& planned) {
  std::vector<KinematicFrame> frames;
  const Script script = ScriptOf(document);
  frames.reserve(static_cast<std::size_t>(script.steps) + 1);
  for (int step = 0; step <= script.steps; ++step) {
    PlannedMotion::Instant at = planned.At(step * static_cast<double>(script.step_s));
    KinematicFrame& frame =
        frames.emplace_back(KinematicFrame{.posture = {.x_m = at.centre.x,
                                                       .y_m = at.centre.y,
                                                       .direction_rad = at.direction_rad[0],
                                                       .angle_rad = std::move(at.angle_rad)},
                                           .forces = {}});
    frame.forces.reserve(at.forces.size());
    for (const PlannedMotion::Vector& force : at.forces)
      frame.forces.push_back({static_cast<float>(force.x), static_cast<float>(force.y)});
  }
  return RecordKinematic(script, frames);
}

Result<Motion> RecordPlanned(const Document& document) {
  if (document.plan.solved.unknowns.empty())
    return Fail(ErrorCode::kMissing, "plan", "has no planned motion yet");
  return RecordPlanned(document, SolvedMotion(document));
}

}  // namespace gaitsmith
