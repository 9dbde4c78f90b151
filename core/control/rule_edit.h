// SPDX-License-Identifier: MIT
// One rule of a bank as a person reads and changes it. Every change lands on the genes' grid, and a rule that
// is not named keeps every bit.
#pragma once

#include "core/control/controller.h"

namespace gaitsmith {

/// What a rule wants of one sense, both ends normalised as the senses are.
struct Stimulus {
  bool cares;
  float low, high;  // of a sense that the rule does not care about: where intervals may end
};

/// A rule of a bank in a document's hands. The controller is one of rules; it and the figure are not kept
/// longer than this.
class RuleEdit {
 public:
  /// @param ports of the plant that the bank is for
  RuleEdit(Controller& controller, const PortCount& ports, int rule)
      : controller_(controller), shape_(controller.rules, controller.senses.kind, ports), rule_(rule) {}

  void SetTarget(int joint, float angle_rad, float min_rad, float max_rad) {
    controller_.genes[shape_.Target(rule_, joint)] = Encode(angle_rad, min_rad, max_rad);
  }
  void SetTau(float tau_s) { controller_.genes[shape_.Tau(rule_)] = EncodeTau(tau_s, controller_.senses); }

  /// The ends, in order. An interval over the whole grid would mean that the rule does not care, so the
  /// widest one stops a cell short of it.
  void SetInterval(int sense, float low, float high);
  /// From caring to not: the interval is forgotten. From not to caring: the middle half of what can be felt.
  void SetCares(int sense, bool cares);

 private:
  Controller& controller_;
  BankShape shape_;
  int rule_;
};

[[nodiscard]] Stimulus StimulusOf(const Controller&, const PortCount& ports, int rule, int sense);
[[nodiscard]] float TargetOf(const Controller&, const PortCount& ports, int rule, int joint, float min_rad,
                             float max_rad);
[[nodiscard]] float TauOf(const Controller&, const PortCount& ports, int rule);

/// Puts a copy of the rule behind it. It loses every tie against the original, so by itself it changes
/// nothing but the numbers of those that follow. @param controller with fewer than kMaxRules
void CopyRule(Controller& controller, const PortCount& ports, int rule);
/// @param controller with more than one rule
void DeleteRule(Controller& controller, const PortCount& ports, int rule);

}  // namespace gaitsmith
