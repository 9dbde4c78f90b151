// SPDX-License-Identifier: MIT
// Ctrl-C and kill as a request to stop at a good moment.
#pragma once

namespace gaitsmith::shell {

/// From now on the first SIGINT or SIGTERM only asks to stop; a second one ends the program.
void CatchInterruption();

/// Whether one has come. From any thread.
[[nodiscard]] bool Interrupted();

}  // namespace gaitsmith::shell
