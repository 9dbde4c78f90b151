// SPDX-License-Identifier: MIT
// What `gaitsmith synthesize` was asked for, as a document, and what becomes of it with the controller found.
#pragma once

#include "core/document/document.h"
#include "shell/command_line/arguments.h"

namespace gaitsmith::shell {

struct Request {
  Document document;  // valid; its search says what to look for
  int own;            // controllers of the document itself; behind them those that hand over
};
/// The document that the options describe, but for the controller to be found.
[[nodiscard]] Result<Request> ReadRequest(const Arguments&);

/// Puts the controller found in its place: as the only clip, or in place of the one that was repaired.
/// Controllers that were needed for the search alone go.
/// @param own as of the request
[[nodiscard]] Result<void> PutFound(const Controller& found, int own, Document&);

}  // namespace gaitsmith::shell
