// SPDX-License-Identifier: MIT
// The Search panel: how far the search has come, how to look for a better motion, what waits, what was found.
#pragma once

#include "shell/panels/search/found_list.h"
#include "shell/session/suite_plan.h"

namespace gaitsmith::shell {

/// Which sections are open, and what is chosen in them.
struct SearchPanelState {
  bool settings = true;
  bool variation = false;
  bool queue = true;
  bool found = true;
  bool elites = true;
  int elite_turns = 0;
  bool suite = false;
  SuiteChoice suite_of = {};
  FoundListState list = {};
};

void DrawSearchPanel(Ui&, Session&, SearchPanelState&);

}  // namespace gaitsmith::shell
