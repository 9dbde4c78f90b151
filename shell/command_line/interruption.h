// SPDX-License-Identifier: MIT
// SIGINT (Ctrl-C) and SIGTERM as a request to stop cleanly.
#pragma once

namespace gaitsmith::shell {

/// Installs handlers: the first signal only requests a stop, the second one ends the program.
void CatchInterruption();

/// Whether a stop was requested. Callable from any thread.
[[nodiscard]] bool Interrupted();

}  // namespace gaitsmith::shell
