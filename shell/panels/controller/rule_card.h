// SPDX-License-Identifier: MIT
// A rule as a card: its target pose, its time constant as a clock, and a bar for each sense that it heeds
// with the present value in it.
#pragma once

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

inline constexpr float kCardHeight = 88.0f;

/// The pose a rule pulls the joints to, one angle for each joint.
[[nodiscard]] std::vector<float> TargetPose(const Controller&, const Skeleton&, int rule);

/// Share of a bar at which a normalised sense stands. Physical intervals may end a quarter outside of [0, 1];
/// the bar shows all of it.
[[nodiscard]] float ShareOnBar(const SenseSpec&, float sense);

/// An interval on its bar and, in [0, 1], the present value; below 0 none is drawn.
struct StimulusBar {
  float low, high, value;

  [[nodiscard]] bool Holds() const { return value >= low && value <= high; }
};
void DrawStimulusBar(Ui&, const ImRect&, const StimulusBar&, ImU32 colour);

/// A clock of one second, of which this many seconds have run.
void DrawClock(Ui&, ImVec2 centre, float radius, float seconds, ImU32 colour);

/// @param open its editor is open
[[nodiscard]] Touch DrawRuleCard(Ui&, const Session&, const Controller&, int rule, bool open, const ImRect&);

}  // namespace gaitsmith::shell
