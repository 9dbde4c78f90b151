// SPDX-License-Identifier: MIT
// The document's plan at work: it is carried out again shortly after each change, in the background, and the
// motion relaxes on the stage meanwhile.
#pragma once

#include <optional>
#include <string>

#include "core/document/planning.h"
#include "shell/results/search_run.h"
#include "shell/workspace/workspace.h"

namespace gaitsmith::shell {

class PlanRun {
 public:
  PlanRun(Workspace& workspace, const SearchRun& search) : workspace_(workspace), search_(search) {}

  /// Called by the host. Reports of earlier generations are ignored.
  void OnReport(int generation, PlanReport report);
  /// The worker died, or cannot be started.
  void OnFailed(int generation);

 private:
  Workspace& workspace_;
  const SearchRun& search_;
  int generation_ = 0;
};

}  // namespace gaitsmith::shell
