// SPDX-License-Identifier: MIT
// What decides a controller's state: a clock, the physical senses, these and a look ahead, a network of
// sensors, or nothing but curves over time. The paper compares the first two. One row for each, read by the
// panel, titles, goals, scripts and the command line.
#pragma once

#include <array>
#include <string_view>

#include "core/document/document.h"
#include "shell/words/language.h"

namespace gaitsmith::shell {

enum class ControlMode { kTimer, kSenses, kSight, kNetwork, kCurves };

/// The texts are English, for Tr(). {1} is a number of rules, nodes or knots, {2} the timer's period in
/// seconds.
struct ControlModeRow {
  ControlMode mode;
  ControllerKind kind;
  SenseKind senses;
  std::string_view name;    // for scripts, goals and tables
  const char* label;        // on the panel's switch
  const char* explanation;  // below the switch
  const char* units;        // label of the number of rules, nodes or knots
  const char* words;        // in a goal: "decided by …"
  const char* short_words;  // in lists; {1} is the period
  const char* one_unit;     // a controller with one rule, node or knot
  const char* many_units;
};

/// In the order of the panel's switch.
inline constexpr std::array<ControlModeRow, 5> kControlModes = {{
    {ControlMode::kTimer, ControllerKind::kRules, SenseKind::kTimer, "timer", TrLater("Timer"),
     TrLater("Rules that follow a clock: a wind-up toy."), TrLater("Rules"), TrLater("timer"),
     TrLater("timer {1} s"), TrLater("{1} rule with timer {2} s"), TrLater("{1} rules with timer {2} s")},
    {ControlMode::kSenses, ControllerKind::kRules, SenseKind::kPhysical, "physical", TrLater("Senses"),
     TrLater("Rules that feel joints or muscles, contacts, height and rise."), TrLater("Rules"),
     TrLater("physical senses"), TrLater("physical"), TrLater("{1} rule with physical senses"),
     TrLater("{1} rules with physical senses")},
    {ControlMode::kSight, ControllerKind::kRules, SenseKind::kSight, "sight", TrLater("Sight"),
     TrLater("Senses, and a look ahead: how high the ground is there, and how far its next corner."),
     TrLater("Rules"), TrLater("sight"), TrLater("sight"), TrLater("{1} rule with sight"),
     TrLater("{1} rules with sight")},
    {ControlMode::kNetwork, ControllerKind::kNetwork, SenseKind::kPhysical, "network", TrLater("Network"),
     TrLater("Touch and angle sensors, hidden nodes and actuators, all connected."), TrLater("Hidden nodes"),
     TrLater("network"), TrLater("network"), TrLater("a network of {1} hidden node"),
     TrLater("a network of {1} hidden nodes")},
    {ControlMode::kCurves, ControllerKind::kTrajectory, SenseKind::kTimer, "trajectory", TrLater("Curves"),
     TrLater("A trajectory: each joint or muscle aims at a curve over time and senses nothing."),
     TrLater("Knots"), TrLater("trajectory"), TrLater("trajectory"), TrLater("a trajectory of {1} knot"),
     TrLater("a trajectory of {1} knots")},
}};

/// One column of the table, in its order.
template <class Value>
[[nodiscard]] constexpr auto ControlModeColumn(Value ControlModeRow::* column) {
  std::array<Value, kControlModes.size()> values;
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = kControlModes[i].*column;
  return values;
}

/// Whether a figure can be moved so: those of springs have no networks.
[[nodiscard]] bool CanMove(const ControlModeRow&, const Figure&);

/// @return the first row of the kind if it has no such senses
[[nodiscard]] const ControlModeRow& ControlModeOf(ControllerKind, SenseKind);
[[nodiscard]] const ControlModeRow& ControlModeOf(const Controller&);
/// The mode of the document's next search.
[[nodiscard]] const ControlModeRow& ControlModeOf(const Document&);
void SetControlMode(Document&, const ControlModeRow&);

/// The mode that a controller is compared with: physical senses for a timer or a trajectory, a timer for all
/// others.
[[nodiscard]] const ControlModeRow& ContrastTo(const Controller&);

}  // namespace gaitsmith::shell
