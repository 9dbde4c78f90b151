// SPDX-License-Identifier: MIT
// Why a bank chose a rule: the numbers of Bank::Choose, for display.
#pragma once

#include <span>
#include <vector>

#include "core/control/controller.h"

namespace gaitsmith {

/// How well a rule matched the senses. Its depth is the least value, over the senses it uses, of 1 - |S -
/// mid| / half-width: 1 in the middle of its stimulus, 0 on the border, negative outside.
struct RuleStanding {
  float off = 0.0f;         // 1 - depth, as the bank computes it
  int decisive_sense = -1;  // the sense with the least depth; -1: the rule uses none and always matches
  int cares = 0;            // number of senses that the rule uses

  [[nodiscard]] float Depth() const { return 1.0f - off; }
  [[nodiscard]] bool Holds() const { return off <= 1.0f; }
};

struct RuleChoice {
  int rule = 0;        // the active rule
  bool holds = false;  // true if its stimulus contains the senses; false if no rule matches and it stays
  int runner_up = -1;  // rule with the next greatest depth, the first of equals; -1 for one rule
  std::vector<RuleStanding> standings;  // one for each rule
};

/// @param controller a controller of rules, for a plant with these ports
/// @param senses     normalised, SenseCount() of them
/// @param present    the rule active so far
[[nodiscard]] RuleChoice ChoiceOf(const Controller& controller, const PortCount& ports,
                                  std::span<const float> senses, int present);

}  // namespace gaitsmith
