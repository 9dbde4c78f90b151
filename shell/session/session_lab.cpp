// SPDX-License-Identifier: MIT
// A session's lab: its trials are run by whoever runs searches, one after another, and the shown motion
// stays.
#include "shell/session/session.h"
#include "shell/words/algorithm_words.h"
#include "shell/words/language.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {

Result<void> Session::StartLab(const LabSettings& settings) {
  if (Searching()) {
    return Fail(ErrorCode::kStructure, "", TrLater("A search is running: stop it first, or let it end"));
  }
  Lab next = lab;
  next.settings = settings;
  if (const auto begun = next.Begin(document_); !begun) return begun;
  StopLab();
  lab = std::move(next);
  notice.clear();
  EndSearch();
  RunTrial();
  return {};
}

void Session::StartLab() {
  if (const auto started = StartLab(lab.settings); !started)
    Say(Tr("The lab cannot start: {1}.", TrError(started.error())));
}

void Session::RunTrial() {
  const Lab::Trial trial = lab.Now();
  host_.StartTrial(trial.document, workers,
                   {.words = Tr("{1}, seed {2}", WordsOf(trial.algorithm).name, std::to_string(trial.seed)),
                    .finished = lab.Finished(),
                    .total = lab.Total()});
}

void Session::StopLab() {
  if (!lab.Running()) return;
  host_.StopSearch();
  EndLab(LabState::kStopped);
}

void Session::EndLab(LabState state) {
  lab.End(state);
  host_.LabEnded();
  const std::string finished = Grouped(lab.Finished()), total = Grouped(lab.Total());
  if (lab.State() == LabState::kFailed) {
    Say(Tr("The lab failed after {1} of {2} trials.", finished, total));
  } else {
    host_.Status(Tr(
        lab.State() == LabState::kDone ? "Lab done: {1} of {2} trials." : "Lab stopped: {1} of {2} trials.",
        finished, total));
  }
}

void Session::OnTrialProgress(const SearchProgress& progress) {
  switch (progress.state) {
    case SearchState::kDone:
      lab.Finish(progress.curve);
      if (lab.Running()) {
        RunTrial();
      } else {
        EndLab(LabState::kDone);
      }
      break;
    case SearchState::kStopped:
      EndLab(LabState::kStopped);
      break;
    case SearchState::kFailed:
      EndLab(LabState::kFailed);
      break;
    default:
      break;
  }
}

void Session::SaveLabCurves() { host_.SaveText(lab.Label() + "-curves.csv", lab.Csv()); }

}  // namespace gaitsmith::shell
