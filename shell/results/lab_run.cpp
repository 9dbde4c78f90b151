// SPDX-License-Identifier: MIT
#include "shell/results/lab_run.h"

#include <utility>

#include "shell/words/algorithm_words.h"
#include "shell/words/language.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {

Result<void> LabRun::Start(const LabSettings& settings) {
  if (search_.Running()) {
    return Fail(ErrorCode::kStructure, "", TrLater("A search is running: stop it first, or let it end"));
  }
  Lab next = trials_;
  next.settings = settings;
  if (const auto begun = next.Begin(workspace_.Doc()); !begun) return begun;
  Stop();
  trials_ = std::move(next);
  workspace_.Notice().clear();
  search_.Forget();
  RunTrial();
  return {};
}

void LabRun::Start() {
  if (const auto started = Start(trials_.settings); !started)
    workspace_.Say(Tr("The lab cannot start: {1}.", TrError(started.error())));
}

void LabRun::RunTrial() {
  const Lab::Trial trial = trials_.Now();
  workspace_.TheHost().StartTrial(
      trial.document, search_.Workers(),
      {.words = Tr("{1}, seed {2}", AlgorithmName(trial.algorithm), std::to_string(trial.seed)),
       .finished = trials_.Finished(),
       .total = trials_.Total()});
}

void LabRun::Stop() {
  if (!trials_.Running()) return;
  workspace_.TheHost().StopSearch();
  End(LabState::kStopped);
}

void LabRun::End(LabState state) {
  trials_.End(state);
  workspace_.TheHost().LabEnded();
  const std::string finished = Grouped(trials_.Finished()), total = Grouped(trials_.Total());
  if (trials_.State() == LabState::kFailed) {
    workspace_.Say(Tr("The lab failed after {1} of {2} trials.", finished, total));
  } else {
    workspace_.TheHost().Status(Tr(trials_.State() == LabState::kDone ? "Lab done: {1} of {2} trials."
                                                                      : "Lab stopped: {1} of {2} trials.",
                                   finished, total));
  }
}

void LabRun::OnProgress(const SearchProgress& progress) {
  switch (progress.state) {
    case SearchState::kDone:
      trials_.Finish(progress.curve);
      if (trials_.Running()) {
        RunTrial();
      } else {
        End(LabState::kDone);
      }
      break;
    case SearchState::kStopped:
      End(LabState::kStopped);
      break;
    case SearchState::kFailed:
      End(LabState::kFailed);
      break;
    default:
      break;
  }
}

void LabRun::SaveCurves() { workspace_.TheHost().SaveText(trials_.Label() + "-curves.csv", trials_.Csv()); }

}  // namespace gaitsmith::shell
