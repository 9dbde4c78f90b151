// SPDX-License-Identifier: MIT
#include "core/planning/plan_recorder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "core/control/sense_table.h"
#include "core/planning/plan_playback.h"
#include "core/rollout/models.h"
#include "core/rollout/motion_recorder.h"

namespace gaitsmith {

namespace {

/// Of the figure about its centre of mass, in the middle between two instants.
double AngularMomentum(const Skeleton& bones, const PlannedMotion::Instant& before,
                       const PlannedMotion::Instant& now, double step_s) {
  double momentum = 0.0;
  for (int rod = 0; rod < bones.rods; ++rod) {
    const Skeleton::Limb& limb = bones.limbs[static_cast<std::size_t>(rod)];
    const auto start = static_cast<std::size_t>(limb.start), end = static_cast<std::size_t>(rod) + 1;
    const auto arm = [&](const PlannedMotion::Instant& at) {
      return std::array{0.5 * (at.endpoints[start].x + at.endpoints[end].x) - at.centre.x,
                        0.5 * (at.endpoints[start].y + at.endpoints[end].y) - at.centre.y};
    };
    const auto from = arm(before), to = arm(now);
    // The cross product of the mean arm and its velocity.
    const double swept = (from[0] * to[1] - from[1] * to[0]) / step_s;
    const double turned = (now.direction_rad[static_cast<std::size_t>(rod)] -
                           before.direction_rad[static_cast<std::size_t>(rod)]) /
                          step_s;
    momentum += static_cast<double>(limb.mass_kg) * swept + static_cast<double>(limb.inertia_kgm2) * turned;
  }
  return momentum;
}

class PlanRecorder final : public MotionRecorder {
 public:
  explicit PlanRecorder(const PlannedMotion& planned) : planned_(planned) {}

  [[nodiscard]] int Model() const override { return 0; }  // of no simulation
  [[nodiscard]] int Rewind(int) override { return 0; }

  void Record(const Script& script, Motion::Log& log) override {
    const double start_rad = static_cast<double>(planned_.Scene().skeleton.start_angle_rad);
    log.ports = CountPorts(script.model, script.figure);
    log.senses = SenseCount(SenseKind::kSight, log.ports);
    Terms terms;
    double first_x = 0.0, first_turn = 0.0;
    PlannedMotion::Instant before{};
    for (int frame = 0; frame <= script.steps; ++frame) {
      const double step_s = static_cast<double>(script.step_s);
      const PlannedMotion::Instant at = planned_.At(frame * step_s);
      const double turn = at.direction_rad[0] - start_rad;
      if (frame == 0) {
        first_x = at.centre.x;
        first_turn = turn;
        before = at;
        terms.start_height_m = static_cast<float>(at.centre.y);
      }
      Motion::Frame& snapshot = log.frames.emplace_back();
      snapshot.x_m = at.centre.x;
      snapshot.y_m = static_cast<float>(at.centre.y);
      snapshot.velocity_x_mps = static_cast<float>((at.centre.x - before.centre.x) / step_s);
      snapshot.velocity_y_mps = static_cast<float>((at.centre.y - before.centre.y) / step_s);
      snapshot.angular_momentum =
          static_cast<float>(AngularMomentum(planned_.Scene().skeleton, before, at, step_s));
      snapshot.turn_rad = at.direction_rad[0];
      snapshot.clip = snapshot.rule = -1;
      terms.travel_m = static_cast<float>(at.centre.x - first_x);
      terms.max_cm_height_m = std::max(terms.max_cm_height_m, snapshot.y_m);
      terms.rotations = static_cast<float>(std::abs(turn - first_turn) / (2.0 * kPi));
      log.terms.push_back(terms);
      for (std::size_t k = 0; k < at.endpoints.size(); ++k) {
        log.endpoints.push_back({static_cast<float>(at.endpoints[k].x - at.centre.x),
                                 static_cast<float>(at.endpoints[k].y - at.centre.y)});
        log.forces.push_back({static_cast<float>(at.forces[k].x), static_cast<float>(at.forces[k].y)});
      }
      for (std::size_t j = 0; j < at.angle_rad.size(); ++j) {
        log.angles.push_back(static_cast<float>(at.angle_rad[j]));
        log.rates.push_back(static_cast<float>((at.angle_rad[j] - before.angle_rad[j]) / step_s));
      }
      log.felt.insert(log.felt.end(), static_cast<std::size_t>(log.senses), 0.0f);
      before = at;
    }
  }

 private:
  const PlannedMotion& planned_;
};

}  // namespace

Motion RecordPlanned(const Document& document, const PlannedMotion& planned) {
  return {std::make_unique<PlanRecorder>(planned), ScriptOf(document)};
}

Result<Motion> RecordPlanned(const Document& document) {
  if (document.plan.solved.unknowns.empty())
    return Fail(ErrorCode::kMissing, "plan", "has no planned motion yet");
  return RecordPlanned(document, SolvedMotion(document));
}

}  // namespace gaitsmith
