// SPDX-License-Identifier: MIT
// Reads and edits one rule of a bank in natural units. Every edit rounds to the genes' grid. Rules that are
// not edited keep every bit.
#pragma once

#include "core/control/controller.h"

namespace gaitsmith {

/// A rule's interval for one sense, normalised as the senses are.
struct Stimulus {
  bool cares;
  float low, high;  // without care, the limits for ends of intervals
};

/// Edits a rule of a bank in a document. The controller must be one of rules, and must outlive this object.
class RuleEdit {
 public:
  /// @param ports of the plant that the bank drives
  RuleEdit(Controller& controller, const PortCount& ports, int rule)
      : controller_(controller), shape_(controller.rules, controller.senses.kind, ports), rule_(rule) {}

  void SetTarget(int joint, float angle_rad, float min_rad, float max_rad) {
    controller_.genes[shape_.Target(rule_, joint)] = Encode(angle_rad, min_rad, max_rad);
  }
  void SetTau(float tau_s) { controller_.genes[shape_.Tau(rule_)] = EncodeTau(tau_s, controller_.senses); }

  /// Sets the ends of the interval, in any order. An interval over the whole grid would mean that the rule
  /// ignores the sense, so the widest one stops one cell short of it.
  void SetInterval(int sense, float low, float high);
  /// Sets whether the rule uses the sense. Turning it off drops the interval. Turning it on starts with the
  /// middle half of the range.
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

/// Inserts a copy of the rule after it. The copy loses every tie against the original, so the motion stays
/// the same. Only the numbers of the rules after it change. @param controller with fewer than kMaxRules rules
void CopyRule(Controller& controller, const PortCount& ports, int rule);
/// @param controller with at least two rules
void DeleteRule(Controller& controller, const PortCount& ports, int rule);

}  // namespace gaitsmith
