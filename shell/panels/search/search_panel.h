// SPDX-License-Identifier: MIT
// The Search panel: progress, settings, the queue and the results.
#pragma once

#include "shell/panels/search/elite_panel.h"
#include "shell/panels/search/found_list.h"
#include "shell/panels/search/front_panel.h"
#include "shell/panels/search/search_settings_form.h"
#include "shell/results/suite_plan.h"

namespace gaitsmith::shell {

/// The open sections and their choices.
struct SearchPanelState {
  bool settings = true;
  SearchFormState form = {};
  bool queue = true;
  bool found = true;
  bool elites = true;
  EliteMapState elite_map = {};
  bool front = true;
  FrontState front_map = {};
  bool suite = false;
  SuiteChoice suite_of = {};
  FoundListState list = {};
};

void DrawSearchPanel(Ui&, Session&, SearchPanelState&);

}  // namespace gaitsmith::shell
