// SPDX-License-Identifier: MIT
// The moment on the stage in plain words, for whoever does not see it.
#pragma once

#include <string>

#include "shell/session/session.h"

namespace gaitsmith::shell {

/// "Paused at 2.31 s, 1.84 m to the right. Rule 3 acts." Short enough to be said at every step.
[[nodiscard]] std::string MomentWords(const Session&);
/// Who is there and how far it came, what touches the ground, which rule acts and why, and what it is worth.
[[nodiscard]] std::string DescriptionOf(const Session&);

}  // namespace gaitsmith::shell
