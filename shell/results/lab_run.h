// SPDX-License-Identifier: MIT
// Runs the lab: many searches for the open document's problem. Only their curves are kept, and the shown
// motion does not change. The host runs the trials one after another. The lab and a search never run at the
// same time.
#pragma once

#include "shell/results/lab.h"
#include "shell/results/search_run.h"
#include "shell/search/search_progress.h"
#include "shell/workspace/workspace.h"

namespace gaitsmith::shell {

class LabRun {
 public:
  LabRun(Workspace& workspace, SearchRun& search) : workspace_(workspace), search_(search) {}

  /// The settings of the next run, and the results so far.
  [[nodiscard]] Lab& Trials() { return trials_; }
  [[nodiscard]] const Lab& Trials() const { return trials_; }
  [[nodiscard]] bool Running() const { return trials_.Running(); }

  /// Runs the lab with these settings, after stopping a running one. Refused while a search runs.
  [[nodiscard]] Result<void> Start(const LabSettings&);
  /// Runs the lab with the settings on the panel; the notice explains a refusal.
  void Start();
  void Stop();
  void OnProgress(const SearchProgress&);
  void SaveCurves();

 private:
  void RunTrial();
  void End(LabState);

  Workspace& workspace_;
  SearchRun& search_;
  Lab trials_;
};

}  // namespace gaitsmith::shell
