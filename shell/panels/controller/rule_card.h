// SPDX-License-Identifier: MIT
// A rule as a card: its target pose, its time constant as a clock, and for each sense that it uses a bar with
// the present value.
#pragma once

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

inline constexpr float kCardHeight = 88.0f;

/// The pose that a rule pulls the joints to, one angle per joint [rad], or one length per muscle.
[[nodiscard]] std::vector<float> TargetPose(const Controller&, const Ports&, int rule);

/// The position of a normalised sense on its bar, [0, 1]. The bar shows [-0.25, 1.25] for physical senses,
/// whose intervals may extend outside [0, 1].
[[nodiscard]] float ShareOnBar(const SenseSpec&, float sense);

/// An interval on its bar and the present value in [0, 1]; a value below 0 is not drawn.
struct StimulusBar {
  float low, high, value;

  [[nodiscard]] bool Holds() const { return value >= low && value <= high; }
};
void DrawStimulusBar(Ui&, const ImRect&, const StimulusBar&, ImU32 colour);

/// A one-second clock face, filled up to `seconds`.
void DrawClock(Ui&, ImVec2 centre, float radius, float seconds, ImU32 colour);

/// @param open whether its editor is open
[[nodiscard]] Touch DrawRuleCard(Ui&, const Session&, const Controller&, int rule, bool open, const ImRect&);

}  // namespace gaitsmith::shell
