// SPDX-License-Identifier: MIT
// The shown moment in plain words, for people who cannot see the stage.
#pragma once

#include <string>

#include "shell/session/session.h"

namespace gaitsmith::shell {

/// "Paused at 2.31 s, 1.84 m to the right. Rule 3 acts." Short enough to be announced at every step.
[[nodiscard]] std::string MomentWords(const Session&);
/// Describes the whole motion: distance, full turns, how it ends. Then the shown moment: distance, ground
/// contacts, the active rule with its reason, and the score.
[[nodiscard]] std::string DescriptionOf(const Session&);

}  // namespace gaitsmith::shell
