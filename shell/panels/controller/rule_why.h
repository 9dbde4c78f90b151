// SPDX-License-Identifier: MIT
// The box that says why a rule acts or does not: a sentence, and the senses it heeds with the present values.
#pragma once

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

/// Which rule is explained, and when.
struct RuleWhyState {
  int pointed_at = -1;  // by the pointer or the keyboard; -1: the active one
  int frame = 0;        // explained; while the motion plays it changes slowly enough to be read
  double since_s = 0.0;
  std::uint64_t hash = 0;  // of the motion that the frame is of
};

/// Its room, always of the same height, so that the cards below it do not jump.
[[nodiscard]] ImRect RuleWhyRow(Ui&);
/// @param controller the shown one, of rules
void DrawRuleWhy(Ui&, const ImRect& box, const Session&, const Controller& controller, RuleWhyState&);

}  // namespace gaitsmith::shell
