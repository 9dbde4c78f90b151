// SPDX-License-Identifier: MIT
// The Search panel: how far the search has come, how to look for a better motion, what waits, what was found.
#pragma once

#include "shell/session.h"
#include "shell/widgets.h"

namespace gaitsmith::shell {

/// Which sections are open, and how the results are sorted.
struct SearchPanelState {
  bool settings = true;
  bool variation = false;
  bool queue = true;
  bool found = true;
  FoundMotions::Order order = FoundMotions::Order::kNewest;
};

void DrawSearchPanel(Ui&, Session&, SearchPanelState&);

}  // namespace gaitsmith::shell
