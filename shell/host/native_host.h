// SPDX-License-Identifier: MIT
// The desktop host: searches run on threads of this process.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "core/planning/planning.h"
#include "shell/search/parallel_search.h"
#include "shell/session/transition_scores.h"
#include "shell/workspace/host.h"

namespace gaitsmith::shell {

/// How the plan that was started with this generation is getting on.
struct PlanUpdate {
  int generation = 0;
  PlanReport report;
};

class NativeHost final : public Host {
 public:
  ~NativeHost() override;

  [[nodiscard]] int MaxWorkers() const override;
  void StartSearch(const Document& document, int workers) override;
  void StartTrial(const Document& document, int workers, const TrialWords& trial) override;
  void PauseSearch() override;
  void ResumeSearch() override;
  void StopSearch() override;
  void StartTransitionMap(const Document& request, int generation) override;
  void StopTransitionMap() override;
  void StartPlan(const Document& document, int generation) override;
  void StopPlan() override;
  void Status(const std::string& sentence) override { status_ = sentence; }
  /// Saves into the working directory, without overwriting a file.
  void SaveText(const std::string& name, const std::string& text) override;
  void DocumentChanged(const std::string& title) override { title_ = title; }

  /// The newest report since the last call, if any.
  [[nodiscard]] std::optional<SearchProgress> TakeProgress();
  /// Parts of the transition map that arrived since the last call.
  [[nodiscard]] std::vector<TransitionPart> TakeTransitions();
  /// Reports of the plan since the last call: every stage, and the newest motion that relaxes.
  [[nodiscard]] std::vector<PlanUpdate> TakePlanUpdates();
  /// "Mr. Star-Man — Gaitsmith", for the window's frame.
  [[nodiscard]] std::string WindowTitle() const;

 private:
  std::mutex mutex_;
  std::optional<SearchProgress> latest_;     // guarded by mutex_
  std::vector<TransitionPart> transitions_;  // guarded by mutex_
  std::vector<PlanUpdate> plan_updates_;     // guarded by mutex_
  std::unique_ptr<SearchControl> control_;
  std::jthread searcher_;
  std::jthread mapper_;
  std::jthread planner_;
  std::string status_;
  std::string title_;
};

}  // namespace gaitsmith::shell
