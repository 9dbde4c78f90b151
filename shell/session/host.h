// SPDX-License-Identifier: MIT
// What the application needs from what it runs in: the page (page_host.h) or the desktop
// (native_host.h).
#pragma once

#include <string>

#include "core/document/document.h"
#include "shell/search/search_progress.h"
#include "shell/words/language.h"

namespace gaitsmith::shell {

/// A trial of the lab as the page tells of it.
struct TrialWords {
  std::string words;  // "SPHC, seed 3"
  int finished = 0;   // trials before it
  int total = 0;
};

class Host {
 public:
  virtual ~Host() = default;

  /// Most workers that make sense here.
  [[nodiscard]] virtual int MaxWorkers() const = 0;
  /// Runs the document's search; a running one is stopped first. Progress comes through
  /// Session::OnSearchProgress.
  virtual void StartSearch(const Document& document, int workers) = 0;
  /// Runs a search of the lab in the same way, one after another. LabEnded follows the last.
  virtual void StartTrial(const Document& document, int workers, const TrialWords& trial) = 0;
  virtual void LabEnded() {}
  /// Runs a search of the queue in the same way.
  /// @param words what it is, e.g. "Mr. Star-Man · travel, SPHC · seed 3"
  virtual void StartQueued(const Document& document, int workers, const std::string& words) {
    Status(Tr("Queue: {1}", words));
    StartSearch(document, workers);
  }
  virtual void PauseSearch() = 0;
  virtual void ResumeSearch() = 0;
  virtual void StopSearch() = 0;

  /// Works out a transition map beside whatever else runs; one that is under way is given up. Parts come
  /// through TransitionRun::OnScores, with the same generation.
  /// @param request of TransitionRequest
  virtual void StartTransitionMap(const Document& request, int generation) = 0;
  virtual void StopTransitionMap() = 0;

  /// One sentence for the status line, spoken by screen readers.
  virtual void Status(const std::string& sentence) = 0;
  /// Gives the reader a file.
  virtual void SaveText(const std::string& name, const std::string& text) = 0;
  virtual void DocumentChanged(const std::string& title) = 0;
  /// A found motion is new or has changed: its text stands for it at the next visit. Empty: it has gone.
  virtual void StoreFound(const std::string& /*id*/, const std::string& /*text*/) {}
  /// Whether AskName can be answered.
  [[nodiscard]] virtual bool CanAskName() const { return false; }
  /// Asks the person for the name of a found motion; the answer goes to the results.
  /// @param name  that it has, or empty. @param usual  what stands in its place then
  virtual void AskName(const std::string& /*id*/, const std::string& /*name*/, const std::string& /*usual*/) {
  }
  /// Of this machine's clock, since 1970 [s]; 0: it has none.
  [[nodiscard]] virtual double NowS() const { return 0.0; }
  /// The first frame is on the screen.
  virtual void FirstFrame() {}
  /// The keyboard wants to leave the canvas: +1 forwards (Tab), -1 backwards (Shift+Tab), 0 just away
  /// (Escape).
  virtual void LeaveCanvas(int /*direction*/) {}
};

}  // namespace gaitsmith::shell
