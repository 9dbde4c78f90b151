// SPDX-License-Identifier: MIT
// One searching thread, which brings its own crew.
#include "shell/host_native.h"

#include <filesystem>
#include <fstream>

#include "shell/language.h"

namespace gaitsmith::shell {

NativeHost::~NativeHost() { StopSearch(); }

int NativeHost::MaxWorkers() const { return Cores(); }

void NativeHost::StartSearch(const Document& document, int workers) {
  StopSearch();
  control_ = std::make_unique<SearchControl>();
  searcher_ = std::jthread([this, control = control_.get(), problem = ProblemOf(document),
                            settings = document.search, start = SpaceOf(document).start, workers] {
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
  control_.reset();
  const std::lock_guard lock(mutex_);
  latest_.reset();
}

std::optional<SearchProgress> NativeHost::TakeProgress() {
  const std::lock_guard lock(mutex_);
  return std::exchange(latest_, std::nullopt);
}

std::string NativeHost::WindowTitle() const {
  return TrTitle(title_) + " — Gaitsmith" + (status_.empty() ? "" : " — " + status_);
}

}  // namespace gaitsmith::shell
