// SPDX-License-Identifier: MIT
// Why a bank chose the rule it did: the numbers of Bank::Choose, for a person to read.
#pragma once

#include <span>
#include <vector>

#include "core/control/controller.h"

namespace gaitsmith {

/// How a rule stood to what was felt. Its depth is the least over the senses it cares about of
/// 1 - |S - mid| / half-width: 1 in the middle of its stimulus, 0 on the border, negative outside.
struct RuleStanding {
  float off = 0.0f;  // 1 - depth, as the bank computes it
  int decisive_sense =
      -1;         // the one that depth comes from; -1: the rule cares about nothing and holds always
  int cares = 0;  // senses it cares about

  [[nodiscard]] float Depth() const { return 1.0f - off; }
  [[nodiscard]] bool Holds() const { return off <= 1.0f; }
};

struct RuleChoice {
  int rule = 0;        // that acts
  bool holds = false;  // its stimulus holds what is felt; else no rule's does, and it stays on
  int runner_up = -1;  // the next deepest, of equals the first; -1: a bank of one rule
  std::vector<RuleStanding> standings;  // of all rules
};

/// @param controller of rules, for a plant with these ports
/// @param senses     normalised, SenseCount() of them
/// @param present    the rule that acted until now
[[nodiscard]] RuleChoice ChoiceOf(const Controller& controller, const PortCount& ports,
                                  std::span<const float> senses, int present);

}  // namespace gaitsmith
