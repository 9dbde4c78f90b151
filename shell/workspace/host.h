// SPDX-License-Identifier: MIT
// What the application needs from its host: the page (page_host.h) or the desktop (native_host.h).
#pragma once

#include <string>

#include "core/document/document.h"
#include "shell/search/search_progress.h"
#include "shell/words/language.h"

namespace gaitsmith::shell {

/// A trial of the lab, as the page shows it.
struct TrialWords {
  std::string words;  // "SPHC, seed 3"
  int finished = 0;   // number of trials before it
  int total = 0;
};

class Host {
 public:
  virtual ~Host() = default;

  /// Greatest useful number of workers.
  [[nodiscard]] virtual int MaxWorkers() const = 0;
  /// Runs the document's search, after stopping a running one. Progress arrives through
  /// Session::OnSearchProgress.
  virtual void StartSearch(const Document& document, int workers) = 0;
  /// Runs a search of the lab in the same way. The lab starts them one after another, and LabEnded follows
  /// the last.
  virtual void StartTrial(const Document& document, int workers, const TrialWords& trial) = 0;
  virtual void LabEnded() {}
  /// Runs a search of the queue in the same way.
  /// @param words its title, e.g. "Mr. Star-Man · travel, SPHC · seed 3"
  virtual void StartQueued(const Document& document, int workers, const std::string& words) {
    Status(Tr("Queue: {1}", words));
    StartSearch(document, workers);
  }
  /// Runs a search of Live in the same way, without a word about it.
  virtual void StartPreview(const Document& document, int workers) { StartSearch(document, workers); }
  virtual void PauseSearch() = 0;
  virtual void ResumeSearch() = 0;
  virtual void StopSearch() = 0;

  /// Computes a transition map in the background, after abandoning an unfinished one. Parts arrive through
  /// TransitionRun::OnScores, with the same generation.
  /// @param request of TransitionRequest
  virtual void StartTransitionMap(const Document& request, int generation) = 0;
  virtual void StopTransitionMap() = 0;

  /// Carries out a document's plan in the background, after abandoning an unfinished one. Reports arrive
  /// through PlanRun::OnReport, with the same generation.
  /// @param document for which CanBePlanned
  virtual void StartPlan(const Document& document, int generation) = 0;
  virtual void StopPlan() = 0;

  /// Shows one sentence in the status line, which screen readers announce.
  virtual void Status(const std::string& sentence) = 0;
  /// Saves a file for the user.
  virtual void SaveText(const std::string& name, const std::string& text) = 0;
  virtual void DocumentChanged(const std::string& title) = 0;
  /// Stores the text of a new or changed found motion for the next visit. An empty text removes it.
  virtual void StoreFound(const std::string& /*id*/, const std::string& /*text*/) {}
  /// Whether the host supports AskName.
  [[nodiscard]] virtual bool CanAskName() const { return false; }
  /// Asks the person for the name of a found motion and passes the answer to the results.
  /// @param name  its present name, or empty. @param usual  what is shown if the name is empty
  virtual void AskName(const std::string& /*id*/, const std::string& /*name*/, const std::string& /*usual*/) {
  }
  /// Whether the host supports LearnFrom.
  [[nodiscard]] virtual bool CanLearn() const { return false; }
  /// Learns that the person wants more, or less, like a found motion.
  virtual void LearnFrom(const std::string& /*id*/, bool /*more*/) {}
  /// Whether the host supports OpenDialog.
  [[nodiscard]] virtual bool HasDialogs() const { return false; }
  /// Opens a dialog of the host by its command, such as "document/share".
  virtual void OpenDialog(const std::string& /*command*/) {}
  /// This machine's clock, since 1970 [s]; 0: no clock.
  [[nodiscard]] virtual double NowS() const { return 0.0; }
  /// Called when the first frame is on the screen.
  virtual void FirstFrame() {}
  /// Moves the keyboard focus out of the canvas: +1 forwards (Tab), -1 backwards (Shift+Tab), 0 without a
  /// direction (Escape).
  virtual void LeaveCanvas(int /*direction*/) {}
};

}  // namespace gaitsmith::shell
