// SPDX-License-Identifier: MIT
// The box that explains why a rule is active or not: a sentence, and the senses it uses with the present
// values.
#pragma once

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

/// The explained rule and moment.
struct RuleWhyState {
  int pointed_at = -1;  // rule under the pointer or the focus; -1: the active rule
  int frame = 0;        // the explained frame; during playback it changes slowly enough to read
  double since_s = 0.0;
  std::uint64_t hash = 0;  // hash of that frame's motion
};

/// The box's row. Its height is constant, so that the cards below do not jump.
[[nodiscard]] ImRect RuleWhyRow(Ui&);
/// @param controller the shown controller, with rules
void DrawRuleWhy(Ui&, const ImRect& box, const Session&, const Controller& controller, RuleWhyState&);

}  // namespace gaitsmith::shell
