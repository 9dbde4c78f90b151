// SPDX-License-Identifier: MIT
#include "core/planning/plan_draft.h"

#include <algorithm>
#include <array>

#include "core/physics/pose.h"

namespace gaitsmith {

namespace {

/// As near to the ground as a plan lets an endpoint stand from the start [m per metre of the longest rod].
constexpr float kNearGround = 0.01f;
/// Shorter breaks between two contacts of an endpoint are closed; what stands more shortly does not count as
/// standing [steps].
constexpr int kShortBreak = 6, kShortStance = 8;

/// Endpoints in the drawn pose, from the centre of mass.
Pose<1> DrawnPose(const Skeleton& skeleton) {
  Pose<1> pose;
  PoseFigure<1>(skeleton, {}, pose);
  const SineCosine turned = SinCos(skeleton.start_angle_rad);
  for (std::size_t k = 0; k < static_cast<std::size_t>(skeleton.endpoints); ++k) {
    const float x = pose.endpoint_x[k][0], y = pose.endpoint_y[k][0];
    pose.endpoint_x[k][0] = x * turned.cosine - y * turned.sine;
    pose.endpoint_y[k][0] = x * turned.sine + y * turned.cosine;
  }
  return pose;
}

}  // namespace

std::vector<int> StandingAtStart(const Document& d) {
  const bool moves =
      d.start.velocity_x_mps != 0.0f || d.start.velocity_y_mps != 0.0f || d.start.spin_radps != 0.0f;
  const Skeleton skeleton(d.figure);
  if (moves || d.start.drop_height_m > kNearGround * skeleton.longest_rod_m) return {};
  const Pose<1> pose = DrawnPose(skeleton);
  float lowest = 0.0f;
  for (int k = 0; k < skeleton.endpoints; ++k)
    lowest = std::min(lowest, pose.endpoint_y[static_cast<std::size_t>(k)][0]);
  std::vector<int> standing;
  for (int k = 0; k < skeleton.endpoints; ++k) {
    if (pose.endpoint_y[static_cast<std::size_t>(k)][0] - lowest < kNearGround * skeleton.longest_rod_m)
      standing.push_back(k);
  }
  return standing;
}

Plan JumpPlan(const Document& d) {
  const Skeleton skeleton(d.figure);
  const Pose<1> pose = DrawnPose(skeleton);
  float lowest = 0.0f, highest = 0.0f;
  for (int k = 0; k < skeleton.endpoints; ++k) {
    lowest = std::min(lowest, pose.endpoint_y[static_cast<std::size_t>(k)][0]);
    highest = std::max(highest, pose.endpoint_y[static_cast<std::size_t>(k)][0]);
  }
  Plan plan;
  plan.steps = 200;
  constexpr int kUp = 75, kDown = 110;
  for (const int endpoint : StandingAtStart(d)) {
    plan.stances.push_back({endpoint, 0, kUp});
    plan.stances.push_back({endpoint, kDown, plan.steps});
  }
  Keyframe end{.step = plan.steps, .pose_rad = {}, .turned = true};
  end.pose_rad.assign(static_cast<std::size_t>(skeleton.joints), 0.0f);
  end.marks = {{.axes = MarkAxes::kAlong, .x_m = 0.25f * (highest - lowest)}};
  end.still = !plan.stances.empty();
  plan.keyframes = {std::move(end)};
  return plan;
}

std::vector<Stance> StancesOf(const Motion& motion, int steps) {
  std::vector<Stance> stances;
  const int last = std::min(steps, motion.Frames() - 1);
  for (int endpoint = 0; endpoint < motion.Bones().endpoints; ++endpoint) {
    std::vector<Stance> own;
    for (int frame = 1; frame <= last; ++frame) {
      if (!(motion.Force(frame, endpoint).y > 0.0f)) continue;
      // A force acts in the step that ends at its frame.
      if (!own.empty() && frame - 1 - own.back().last_step < kShortBreak)
        own.back().last_step = frame;
      else
        own.push_back({endpoint, frame - 1, frame});
    }
    for (const Stance& stance : own)
      if (stance.last_step - stance.first_step >= kShortStance) stances.push_back(stance);
  }
  std::ranges::sort(stances, [](const Stance& a, const Stance& b) {
    return std::array{a.first_step, a.endpoint} < std::array{b.first_step, b.endpoint};
  });
  if (stances.size() > kMaxStances) stances.resize(kMaxStances);
  return stances;
}

bool SameWishes(const Plan& a, const Plan& b) {
  return a.steps == b.steps && a.keyframes == b.keyframes && a.stances == b.stances &&
         a.smoothness == b.smoothness;
}

void DropStaleSolution(Document& d) {
  PlanSolution& solved = d.plan.solved;
  if (solved.unknowns.empty()) return;
  const auto needed =
      static_cast<std::size_t>(UnknownsOf(SceneOf(d), {solved.degree, solved.pieces_per_second}));
  if (solved.unknowns.size() != needed) solved = {};
}

}  // namespace gaitsmith
