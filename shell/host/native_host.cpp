// SPDX-License-Identifier: MIT
// A search thread, which starts its own helpers, and threads for the transition map and the plan.
#include "shell/host/native_host.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "core/document/transition.h"
#include "shell/words/language.h"

namespace gaitsmith::shell {

NativeHost::~NativeHost() {
  StopSearch();
  StopTransitionMap();
  StopPlan();
}

int NativeHost::MaxWorkers() const { return Cores(); }

void NativeHost::StartSearch(const Document& document, int workers) {
  StopSearch();
  {
    const std::lock_guard lock(mutex_);
    latest_.reset();
  }
  control_ = std::make_unique<SearchControl>();
  searcher_ = std::jthread([this, control = control_.get(), problem = ProblemOf(document),
                            settings = document.search, start = StartOf(document), workers] {
    RunParallelSearch(
        problem, settings, workers, *control,
        [this](const SearchProgress& progress) {
          const std::lock_guard lock(mutex_);
          latest_ = progress;
        },
        start);
  });
}

void NativeHost::StartTrial(const Document& document, int workers, const TrialWords& trial) {
  status_ = Tr("Lab: trial {1} of {2}, {3}", trial.finished + 1, trial.total, trial.words);
  StartSearch(document, workers);
}

void NativeHost::SaveText(const std::string& name, const std::string& text) {
  std::filesystem::path path = name;
  std::error_code fault;
  for (int number = 2; std::filesystem::exists(path, fault); ++number) {
    path = std::filesystem::path(name).stem().string() + "-" + std::to_string(number) +
           std::filesystem::path(name).extension().string();
  }
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  status_ = Tr(file.good() ? "Saved as {1}." : "Cannot write {1}.", path.string());
}

void NativeHost::PauseSearch() {
  if (control_) control_->Pause(true);
}

void NativeHost::ResumeSearch() {
  if (control_) control_->Pause(false);
}

void NativeHost::StopSearch() {
  if (control_) control_->Cancel();
  if (searcher_.joinable()) searcher_.join();
  control_.reset();  // its last report is not taken yet
}

void NativeHost::StartTransitionMap(const Document& request, int generation) {
  StopTransitionMap();
  mapper_ = std::jthread([this, request, generation](const std::stop_token& stop) {
    constexpr int kPart = 16;  // moments per part, about a hundredth of a second
    const TransitionMap map = TransitionMapOf(request);
    for (int first = 0; first < map.Count() && !stop.stop_requested(); first += kPart) {
      TransitionPart part{.generation = generation,
                          .first = first,
                          .usual = map.UsualScore(),
                          .scores = map.Scores(first, std::min(kPart, map.Count() - first))};
      const std::lock_guard lock(mutex_);
      transitions_.push_back(std::move(part));
    }
  });
}

void NativeHost::StopTransitionMap() {
  mapper_ = {};  // requests a stop and waits for it
  const std::lock_guard lock(mutex_);
  transitions_.clear();
}

std::vector<TransitionPart> NativeHost::TakeTransitions() {
  const std::lock_guard lock(mutex_);
  return std::exchange(transitions_, {});
}

void NativeHost::StartPlan(const Document& document, int generation) {
  StopPlan();
  planner_ = std::jthread([this, document, generation](const std::stop_token& stop) {
    CarryOutPlan(document, kFinePlan, [&](const PlanReport& report) {
      if (stop.stop_requested()) return false;
      const std::lock_guard lock(mutex_);
      // Nobody sees an iteration that a later one follows before the next frame.
      if (!plan_updates_.empty() && plan_updates_.back().report.stage == PlanReport::Stage::kRelaxing)
        plan_updates_.pop_back();
      plan_updates_.push_back({.generation = generation, .report = report});
      return true;
    });
  });
}

void NativeHost::StopPlan() {
  planner_ = {};  // requests a stop and waits for it: an iteration
  const std::lock_guard lock(mutex_);
  plan_updates_.clear();
}

std::vector<PlanUpdate> NativeHost::TakePlanUpdates() {
  const std::lock_guard lock(mutex_);
  return std::exchange(plan_updates_, {});
}

std::optional<SearchProgress> NativeHost::TakeProgress() {
  const std::lock_guard lock(mutex_);
  return std::exchange(latest_, std::nullopt);
}

std::string NativeHost::WindowTitle() const {
  return TrTitle(title_) + " — Gaitsmith" + (status_.empty() ? "" : " — " + status_);
}

}  // namespace gaitsmith::shell
