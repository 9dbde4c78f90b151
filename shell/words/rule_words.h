// SPDX-License-Identifier: MIT
// Explains in words which rule was chosen at a moment, and why. Core makes the choice.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/control/rule_choice.h"
#include "core/control/sense_table.h"
#include "core/rollout/motion.h"

namespace gaitsmith::shell {

/// A frame of a motion at which a bank chose a rule.
struct RuleMoment {
  const Controller& controller;
  const Ports& ports;
  std::vector<float> senses;  // normalised
  RuleChoice choice;
  bool begins;  // first step: no senses yet, so the first rule is active
};

/// @return nothing if another clip is active or its controller has no rules
[[nodiscard]] std::optional<RuleMoment> MomentOf(const Controller& controller, const Motion& motion, int clip,
                                                 int frame);

/// "−31°", "12 N", "0.83 m", "−0.30 m/s", "0.42 s", "80 %"
[[nodiscard]] std::string QuantityWords(SenseQuantity, float value);
/// A sense's name and value: "height at 0.83 m".
[[nodiscard]] std::string SenseWords(const RuleMoment&, int sense);
/// Why this rule is active, or why it is not.
[[nodiscard]] std::string WhyWords(const RuleMoment&, int rule);

}  // namespace gaitsmith::shell
