// SPDX-License-Identifier: MIT
#include "shell/session/plan_editor.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "core/planning/plan_playback.h"
#include "shell/words/language.h"

namespace gaitsmith::shell {

namespace {

constexpr int kStanceLength = 30;   // steps
constexpr int kShortestStance = 2;  // stance [steps]
constexpr int kShortestPlan = 20;

}  // namespace

const char* PlanEditor::WhyNot() const {
  const Figure& figure = workspace_.Doc().figure;
  if (figure.HasSprings()) return Tr("Keyframes are for figures of rods.");
  return figure.Joints() == 0 ? Tr("Keyframes need a figure with a joint.") : "";
}

bool PlanEditor::Begin() {
  if (Open()) return true;
  if (const std::string why_not = WhyNot(); !why_not.empty()) {
    workspace_.Say(why_not);
    return false;
  }
  return workspace_.Change([](Document& d) {
    d.plan = JumpPlan(d);
    if (d.timeline.empty()) d.duration_steps = d.plan.steps;
  });
}

bool PlanEditor::Change(const std::function<void(Plan&)>& edit) {
  return workspace_.Set([&](Document& d) {
    edit(d.plan);
    std::ranges::sort(d.plan.keyframes, {}, &Keyframe::step);
    d.plan.solved = {};  // of what was asked for before
  });
}

void PlanEditor::Choose(const Keyframe& keyframe) {
  const auto& keyframes = Shown().keyframes;
  const auto found = std::ranges::find(keyframes, keyframe);
  if (found != keyframes.end()) chosen_ = static_cast<int>(found - keyframes.begin());
}

bool PlanEditor::AddKeyframe() {
  if (Shown().keyframes.size() >= kMaxKeyframes) {
    workspace_.Say(Tr("A plan has at most {1} keyframes.", std::to_string(kMaxKeyframes)));
    return false;
  }
  const Playback& player = workspace_.Player();
  const Motion& motion = player.Shown();
  const int frame = std::clamp(player.Frame(), 1, std::min(Shown().steps, motion.Frames() - 1));
  const auto there = std::ranges::find(Shown().keyframes, frame, &Keyframe::step);
  if (there != Shown().keyframes.end()) {
    Choose(*there);
    workspace_.Say(Tr("There is a keyframe at this moment."));
    return false;
  }
  Keyframe keyframe{.step = frame, .turned = true};
  const Skeleton& bones = motion.Bones();
  // Of the plan, if there is a solved one: what is played differs a little, and could not be met.
  std::optional<PlannedMotion::Instant> planned;
  if (!Shown().solved.unknowns.empty())
    planned = SolvedMotion(workspace_.Doc()).At(frame * static_cast<double>(kStep));
  for (int joint = 0; joint < bones.joints; ++joint) {
    const Skeleton::Limb& limb = bones.limbs[static_cast<std::size_t>(joint) + 1];
    const float angle = planned ? static_cast<float>(planned->angle_rad[static_cast<std::size_t>(joint)])
                                : motion.AngleRad(frame, joint);
    keyframe.pose_rad.push_back(std::clamp(angle, limb.min_rad, limb.max_rad));
  }
  keyframe.turn_rad = static_cast<float>((planned ? planned->direction_rad[0] : motion.At(frame).turn_rad) -
                                         static_cast<double>(bones.start_angle_rad));
  const bool added = Change([&](Plan& plan) { plan.keyframes.push_back(keyframe); });
  if (added) Choose(keyframe);
  return added;
}

void PlanEditor::RemoveKeyframe(int keyframe) {
  Change([&](Plan& plan) { plan.keyframes.erase(plan.keyframes.begin() + keyframe); });
}

void PlanEditor::MoveKeyframe(int keyframe, int step) {
  const int to = std::clamp(step, 1, Shown().steps);
  Keyframe moved = Shown().keyframes[static_cast<std::size_t>(keyframe)];
  moved.step = to;
  Change([&](Plan& plan) { plan.keyframes[static_cast<std::size_t>(keyframe)].step = to; });
  Choose(moved);
}

void PlanEditor::MoveMark(int keyframe, int mark, float x_m, float y_m) {
  Mark moved = Shown().keyframes[static_cast<std::size_t>(keyframe)].marks[static_cast<std::size_t>(mark)];
  const Mark before = moved;
  if (moved.axes != MarkAxes::kUp) moved.x_m = x_m;
  if (moved.axes != MarkAxes::kAlong) moved.y_m = y_m;
  if (moved == before) return;
  Change([&](Plan& plan) {
    plan.keyframes[static_cast<std::size_t>(keyframe)].marks[static_cast<std::size_t>(mark)] = moved;
  });
}

void PlanEditor::AddStance(int endpoint) {
  if (Shown().stances.size() >= kMaxStances)
    return workspace_.Say(Tr("A plan has at most {1} times of standing.", std::to_string(kMaxStances)));
  Stance stance{endpoint, std::clamp(workspace_.Player().Frame(), 0, Shown().steps - kShortestStance), 0};
  stance.last_step = std::min(stance.first_step + kStanceLength, Shown().steps);
  for (const Stance& other : Shown().stances) {
    if (other.endpoint != endpoint) continue;
    if (other.first_step <= stance.first_step && stance.first_step <= other.last_step)
      return workspace_.Say(Tr("It already stands at this moment."));
    if (other.first_step > stance.first_step)
      stance.last_step = std::min(stance.last_step, other.first_step - 1);
  }
  if (stance.last_step - stance.first_step < kShortestStance)
    return workspace_.Say(Tr("It stands again too soon after this moment."));
  Change([&](Plan& plan) { plan.stances.push_back(stance); });
}

void PlanEditor::RemoveStance(int stance) {
  Change([&](Plan& plan) { plan.stances.erase(plan.stances.begin() + stance); });
}

void PlanEditor::MoveStance(int stance, bool last, int step) {
  const Stance& now = Shown().stances[static_cast<std::size_t>(stance)];
  int least = 0, most = Shown().steps;
  for (const Stance& other : Shown().stances) {
    if (other.endpoint != now.endpoint || other == now) continue;
    if (other.last_step < now.first_step) least = std::max(least, other.last_step + 1);
    if (other.first_step > now.last_step) most = std::min(most, other.first_step - 1);
  }
  if (last)
    least = now.first_step + kShortestStance;
  else
    most = now.last_step - kShortestStance;
  const int to = std::clamp(step, least, std::max(least, most));
  Change([&](Plan& plan) {
    Stance& moved = plan.stances[static_cast<std::size_t>(stance)];
    (last ? moved.last_step : moved.first_step) = to;
  });
}

void PlanEditor::TakeStances() {
  std::vector<Stance> stances = StancesOf(workspace_.Player().Shown(), Shown().steps);
  if (stances.empty()) return workspace_.Say(Tr("No endpoint stands long enough in the shown motion."));
  Change([&](Plan& plan) { plan.stances = std::move(stances); });
}

void PlanEditor::SetLength(int steps) {
  const int to = std::clamp(steps, kShortestPlan, kMaxPlanSteps);
  Change([&](Plan& plan) {
    const int before = std::exchange(plan.steps, to);
    for (Keyframe& keyframe : plan.keyframes)
      keyframe.step = keyframe.step == before ? to : std::min(keyframe.step, to);
    for (Stance& stance : plan.stances)
      stance.last_step = stance.last_step == before ? to : std::min(stance.last_step, to);
    std::erase_if(plan.stances,
                  [](const Stance& one) { return one.last_step - one.first_step < kShortestStance; });
  });
}

void PlanEditor::Clear() {
  workspace_.Set([](Document& d) { d.plan = {}; });
}

}  // namespace gaitsmith::shell
