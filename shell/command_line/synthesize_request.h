// SPDX-License-Identifier: MIT
// The document that `gaitsmith synthesize` searches, and the one it writes with the controller found.
#pragma once

#include "core/document/document.h"
#include "shell/command_line/arguments.h"

namespace gaitsmith::shell {

struct Request {
  Document document;  // valid; its search settings define the search
  int own;            // number of its own controllers; those of --handover follow them
};
/// Builds the document that the options describe, without the controller to be found.
[[nodiscard]] Result<Request> ReadRequest(const Arguments&);

/// Inserts the controller found, as the only clip or in place of the repaired one. Removes the controllers
/// that only the search needed.
/// @param own of the request
[[nodiscard]] Result<void> PutFound(const Controller& found, int own, Document&);

}  // namespace gaitsmith::shell
