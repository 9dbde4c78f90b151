// SPDX-License-Identifier: MIT
#include "shell/session/teacher.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/document/style_weights.h"
#include "shell/words/language.h"

namespace gaitsmith::shell {
namespace {

// Within what a document may hold.
WayPoint Bounded(WayPoint point) {
  constexpr float kFar = 10'000.0f;
  return {point.step, std::clamp(point.x_m, -kFar, kFar), std::clamp(point.y_m, 0.0f, kFar)};
}

/// A number of points at equal distances along a line.
std::vector<WayPoint> Evenly(const std::vector<WayPoint>& drawn, std::size_t count) {
  std::vector<float> along(drawn.size(), 0.0f);
  for (std::size_t i = 1; i < drawn.size(); ++i)
    along[i] = along[i - 1] + std::hypot(drawn[i].x_m - drawn[i - 1].x_m, drawn[i].y_m - drawn[i - 1].y_m);
  std::vector<WayPoint> points;
  std::size_t next = 1;
  for (std::size_t i = 0; i < count; ++i) {
    const float at = along.back() * static_cast<float>(i) / static_cast<float>(count - 1);
    while (next + 1 < drawn.size() && along[next] < at) ++next;
    const float piece = along[next] - along[next - 1];
    const float share = piece > 0.0f ? std::clamp((at - along[next - 1]) / piece, 0.0f, 1.0f) : 0.0f;
    const WayPoint &from = drawn[next - 1], &to = drawn[next];
    points.push_back({0, from.x_m + share * (to.x_m - from.x_m), from.y_m + share * (to.y_m - from.y_m)});
  }
  return points;
}

}  // namespace

void Teacher::Take(Tool tool) {
  if (tool == Tool::kPose && workspace_.Doc().figure.HasSprings()) return;  // it has no joints to pose
  in_hand_ = tool;
  if (tool == Tool::kNone) return;
  ground_.Draw(false);
  Playback& player = workspace_.Player();
  player.Play(false);
  if (tool == Tool::kWay) return player.Seek(0.0);
  if (Shown().pose_rad.empty()) ShowPoseNow();
  player.SeekFrame(static_cast<double>(Shown().pose_step) * static_cast<double>(kStep));
}

void Teacher::Show(Demonstration shown) {
  workspace_.Set([&](Document& d) {
    std::swap(d.task.shown, shown);
    for (std::size_t term = kFreeTerms; term < kWorkTerms; ++term) {
      const bool can = CanMeasure(d.task, static_cast<StyleTerm>(term));
      if (can == CanMeasure(workspace_.Doc().task, static_cast<StyleTerm>(term))) continue;
      d.task.weights[term] = can ? UsualWeights(d)[term] : 0.0f;
    }
  });
}

void Teacher::ShowWay(const std::vector<WayPoint>& drawn) {
  Demonstration shown = Shown();
  shown.way =
      Evenly(drawn, std::min(kDrawnPoints, static_cast<std::size_t>(workspace_.Doc().task.duration_steps)));
  const auto last = static_cast<int>(shown.way.size()) - 1;
  for (int i = 0; i <= last; ++i) {
    WayPoint& point = shown.way[static_cast<std::size_t>(i)];
    point.step = last == 0 ? 0 : workspace_.Doc().task.duration_steps * i / last;
    point = Bounded(point);
  }
  Show(std::move(shown));
}

void Teacher::AddPlaceNow() {
  const Playback& player = workspace_.Player();
  const Motion::Frame& now = player.Shown().At(player.Frame());
  Demonstration shown = Shown();
  const auto at = std::ranges::lower_bound(shown.way, player.Frame(), {}, &WayPoint::step);
  const WayPoint place = Bounded({player.Frame(), static_cast<float>(now.x_m), now.y_m});
  if (at != shown.way.end() && at->step == place.step) {
    *at = place;
  } else if (shown.way.size() == kMaxWayPoints) {
    return workspace_.Say(Tr("A way has at most {1} points.", std::to_string(kMaxWayPoints)));
  } else {
    shown.way.insert(at, place);
  }
  Show(std::move(shown));
}

void Teacher::MovePoint(std::size_t index, WayPoint point) {
  Demonstration shown = Shown();
  const int least = index == 0 ? 0 : shown.way[index - 1].step + 1;
  const int most = index + 1 == shown.way.size() ? kMaxSteps : shown.way[index + 1].step - 1;
  point.step = std::clamp(point.step, least, most);
  shown.way[index] = Bounded(point);
  Show(std::move(shown));
}

void Teacher::RemovePoint(std::size_t index) {
  Demonstration shown = Shown();
  shown.way.erase(shown.way.begin() + static_cast<std::ptrdiff_t>(index));
  Show(std::move(shown));
}

void Teacher::ForgetWay() {
  if (in_hand_ == Tool::kWay) PutAway();
  Demonstration shown = Shown();
  shown.way.clear();
  Show(std::move(shown));
}

void Teacher::ShowPoseNow() {
  const Playback& player = workspace_.Player();
  const Motion& motion = player.Shown();
  Demonstration shown = Shown();
  const int frame = player.Frame();
  shown.pose_step = std::clamp(frame, 1, workspace_.Doc().task.duration_steps);
  const double turn = motion.At(frame).turn_rad;
  shown.pose_turn_rad = static_cast<float>(WithoutWholeTurns(turn));
  shown.pose_rad.clear();
  for (int joint = 0; joint < workspace_.Doc().figure.Joints(); ++joint)
    shown.pose_rad.push_back(motion.AngleRad(frame, joint));
  Show(std::move(shown));
}

void Teacher::TurnJoint(std::size_t joint, float angle_rad) {
  Demonstration shown = Shown();
  shown.pose_rad[joint] = angle_rad;
  Show(std::move(shown));
}

void Teacher::TurnWhole(float turn_rad) {
  Demonstration shown = Shown();
  shown.pose_turn_rad = static_cast<float>(WithoutWholeTurns(static_cast<double>(turn_rad)));
  Show(std::move(shown));
}

void Teacher::ForgetPose() {
  if (in_hand_ == Tool::kPose) PutAway();
  Demonstration shown = Shown();
  shown.pose_rad.clear();
  shown.pose_step = Demonstration{}.pose_step;
  shown.pose_turn_rad = 0.0f;
  Show(std::move(shown));
}

void Teacher::Follow(bool opened) {
  const bool gone = in_hand_ == Tool::kPose && Shown().pose_rad.empty();
  if (opened || gone) PutAway();
}

}  // namespace gaitsmith::shell
