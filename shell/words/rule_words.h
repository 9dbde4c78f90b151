// SPDX-License-Identifier: MIT
// A rule and the moment it was chosen in, in plain words with units. The choice itself is core's.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/control/rule_choice.h"
#include "core/rollout/figure_senses.h"
#include "core/rollout/motion.h"

namespace gaitsmith::shell {

/// A frame of a motion at which a bank chose.
struct RuleMoment {
  const Controller& controller;
  const Skeleton& bones;
  std::vector<float> senses;  // normalised
  RuleChoice choice;
  bool begins;  // nothing was felt yet: a bank begins with its first rule
};

/// @return nothing when another clip than this one is in charge, or its controller has no rules
[[nodiscard]] std::optional<RuleMoment> MomentOf(const Controller& controller, const Motion& motion, int clip,
                                                 int frame);

/// "−31°", "12 N", "0.83 m", "−0.30 m/s", "0.42 s"
[[nodiscard]] std::string QuantityWords(SenseQuantity, float value);
/// The sense as a person names it, and what it reads: "height at 0.83 m".
[[nodiscard]] std::string SenseWords(const RuleMoment&, int sense);
/// Why this rule acts, or why it does not.
[[nodiscard]] std::string WhyWords(const RuleMoment&, int rule);

}  // namespace gaitsmith::shell
