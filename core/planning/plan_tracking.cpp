// SPDX-License-Identifier: MIT
#include "core/planning/plan_tracking.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "core/control/rule_edit.h"
#include "core/numeric/scalar_math.h"
#include "core/physics/joint_response.h"
#include "core/planning/plan_recorder.h"
#include "core/rollout/models.h"

namespace gaitsmith {

namespace {

constexpr float kFastestS = 0.04f;  // plans move joints faster than most searches may
constexpr int kTaus = 12;           // that are tried for a rule
constexpr float kMargin = 0.06f;    // by which a box is wider than the planned senses, normalised
constexpr int kWayPoints = 16;
// Weights: a centimetre beside the way costs as much as a metre of travel brings. With the usual weights the
// figure jumps three times as far as planned.
constexpr float kOnWay = 100.0f, kInPose = 10.0f;

/// The planned motion as a rule should imitate it.
class Imitation {
 public:
  Imitation(const Motion& planned, Controller& controller)
      : planned_(planned),
        controller_(controller),
        ports_(PortsOf(planned.Bones())),
        joints_(static_cast<std::size_t>(planned.Bones().joints)) {}

  /// Sets a rule that acts from one frame to another.
  void SetRule(int rule, int first, int last) {
    RuleEdit edit(controller_, ports_.Count(), rule);
    const float tau_s = BestTau(first, last);
    edit.SetTau(tau_s);
    for (std::size_t joint = 0; joint < joints_.size(); ++joint) {
      const Skeleton::Limb& limb = planned_.Bones().limbs[joint + 1];
      const double target = Target(joint, first, last, tau_s);
      edit.SetTarget(static_cast<int>(joint), static_cast<float>(target), limb.min_rad, limb.max_rad);
      for (int frame = first; frame < last; ++frame)
        joints_[joint].Advance(target, static_cast<double>(tau_s));
    }
    for (int sense = 0; sense < SenseCount(controller_.senses.kind, ports_.Count()); ++sense)
      SetInterval(edit, sense, first, last);
  }

 private:
  [[nodiscard]] double Wanted(std::size_t joint, int frame) const {
    return static_cast<double>(planned_.AngleRad(frame, static_cast<int>(joint)));
  }
  [[nodiscard]] double Target(std::size_t joint, int first, int last, float tau_s) const {
    const Skeleton::Limb& limb = planned_.Bones().limbs[joint + 1];
    const double target = joints_[joint].TargetFor(
        Wanted(joint, last), (last - first) * static_cast<double>(kStep), static_cast<double>(tau_s));
    return std::clamp(target, static_cast<double>(limb.min_rad), static_cast<double>(limb.max_rad));
  }
  /// The time constant with which the joints come nearest to the planned angles.
  [[nodiscard]] float BestTau(int first, int last) const {
    const auto low = static_cast<double>(controller_.senses.tau_min_s),
               high = static_cast<double>(controller_.senses.tau_max_s);
    float best_s = controller_.senses.tau_min_s;
    double least = -1.0;
    for (int i = 0; i < kTaus; ++i) {
      const auto tau_s = static_cast<float>(low * Exp(Log(high / low) * i / (kTaus - 1)));
      double squares = 0.0;
      for (std::size_t joint = 0; joint < joints_.size(); ++joint) {
        const double target = Target(joint, first, last, tau_s);
        FreeJoint joint_after = joints_[joint];
        for (int frame = first + 1; frame <= last; ++frame) {
          joint_after.Advance(target, static_cast<double>(tau_s));
          const double gap = joint_after.angle_rad - Wanted(joint, frame);
          squares += gap * gap;
        }
      }
      if (least >= 0.0 && squares >= least) continue;
      least = squares;
      best_s = tau_s;
    }
    return best_s;
  }
  void SetInterval(RuleEdit& edit, int sense, int first, int last) {
    const SenseScale scale = ScaleOf(controller_.senses, ports_, sense);
    if (scale.quantity == SenseQuantity::kTime) {
      const auto period = static_cast<float>(controller_.senses.period_steps);
      edit.SetInterval(sense, static_cast<float>(first) / period, static_cast<float>(last) / period);
      return;
    }
    if (!Sensed(scale.quantity) || scale.at_one <= scale.at_zero) return edit.SetCares(sense, false);
    const auto felt = [&](int frame) {
      const float reading = scale.quantity == SenseQuantity::kAngle    ? planned_.AngleRad(frame, sense)
                            : scale.quantity == SenseQuantity::kHeight ? planned_.At(frame).y_m
                                                                       : planned_.At(frame).velocity_y_mps;
      return (reading - scale.at_zero) / (scale.at_one - scale.at_zero);
    };
    // Around where its share begins, so that the next rule is nearer where it ends.
    const float middle = felt(first);
    float half = 0.0f;
    for (int frame = first; frame <= last; ++frame) half = std::max(half, std::abs(felt(frame) - middle));
    edit.SetInterval(sense, std::clamp(middle - half - kMargin, kEdgeLow, kEdgeHigh),
                     std::clamp(middle + half + kMargin, kEdgeLow, kEdgeHigh));
  }
  /// Forces peak within single steps, and a planned motion sees no ground: rules look at neither.
  static bool Sensed(SenseQuantity quantity) {
    return quantity == SenseQuantity::kAngle || quantity == SenseQuantity::kHeight ||
           quantity == SenseQuantity::kVelocity;
  }

  const Motion& planned_;
  Controller& controller_;
  Ports ports_;
  std::vector<FreeJoint> joints_;  // where the joints are after the rules so far
};

/// The frames at which the rules' shares begin, and the end: joints turn as far in each share, and a figure
/// that only stands gets no rule of its own, since nothing would lead from there to the next.
std::vector<int> SharesOf(const Motion& planned, int steps, int rules) {
  constexpr double kIdleRad = 0.002;  // counted for each step in any case
  std::vector<double> turned = {0.0};
  for (int frame = 1; frame <= steps; ++frame) {
    double squares = 0.0;
    for (int joint = 0; joint < planned.Bones().joints; ++joint) {
      const auto turn =
          static_cast<double>(planned.AngleRad(frame, joint) - planned.AngleRad(frame - 1, joint));
      squares += turn * turn;
    }
    turned.push_back(turned.back() + std::sqrt(squares) + kIdleRad);
  }
  std::vector<int> begins = {0};
  for (int rule = 1; rule < rules; ++rule) {
    const double due = turned.back() * rule / rules;
    const auto at = static_cast<int>(std::ranges::lower_bound(turned, due) - turned.begin());
    begins.push_back(std::clamp(at, begins.back() + 1, steps - rules + rule));
  }
  begins.push_back(steps);
  return begins;
}

/// The way of the centre of mass and one pose, as if a person had shown them.
Demonstration ShownBy(const Motion& planned, const Plan& plan, int steps) {
  Demonstration shown;
  const int points = std::min(kWayPoints, steps);
  for (int i = 0; i <= points; ++i) {
    const int frame = steps * i / points;
    shown.way.push_back({frame, static_cast<float>(planned.At(frame).x_m - planned.At(0).x_m),
                         std::max(0.0f, planned.At(frame).y_m)});
  }
  for (int frame = 1; frame <= steps; ++frame)
    if (planned.At(frame).y_m > planned.At(shown.pose_step).y_m) shown.pose_step = frame;
  for (const Keyframe& keyframe : plan.keyframes)
    if (!keyframe.pose_rad.empty()) shown.pose_step = std::min(keyframe.step, steps);
  shown.pose_turn_rad = static_cast<float>(WithoutWholeTurns(planned.At(shown.pose_step).turn_rad));
  for (int joint = 0; joint < planned.Bones().joints; ++joint)
    shown.pose_rad.push_back(planned.AngleRad(shown.pose_step, joint));
  return shown;
}

}  // namespace

Result<Document> TrackPlan(const Document& document) {
  const auto planned = RecordPlanned(document);
  if (!planned) return std::unexpected(planned.error());
  const int steps = std::min(document.plan.steps, planned->Frames() - 1);
  Document tracked = document;
  tracked.kind = ControllerKind::kRules;
  SenseSpec& senses = tracked.senses;
  senses.period_steps = std::max(2, steps);
  senses.tau_min_s = std::min(senses.tau_min_s, kFastestS);
  const PortCount ports = CountPorts(document.model, document.figure);
  tracked.rules = std::min(document.rules, steps);
  const BankShape shape(tracked.rules, senses.kind, ports);
  Controller controller{"tracking", ControllerKind::kRules, senses, tracked.rules, Genome(shape.Genes())};
  Imitation imitation(*planned, controller);
  const std::vector<int> begins = SharesOf(*planned, steps, tracked.rules);
  for (std::size_t rule = 0; rule + 1 < begins.size(); ++rule)
    imitation.SetRule(static_cast<int>(rule), begins[rule], begins[rule + 1]);

  tracked.controllers = {std::move(controller)};
  tracked.timeline = {{.controller = 0, .start_step = 0}};
  tracked.search.start = 0;
  tracked.search.in_place_of = -1;
  tracked.search.handovers.clear();
  tracked.task.duration_steps = steps;
  tracked.task.shown = ShownBy(*planned, document.plan, steps);
  tracked.task.weights[static_cast<std::size_t>(StyleTerm::kOnWay)] = kOnWay;
  tracked.task.weights[static_cast<std::size_t>(StyleTerm::kInPose)] = kInPose;
  tracked.lineage = {};
  tracked.hash = {};
  return tracked;
}

}  // namespace gaitsmith
