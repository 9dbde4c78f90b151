// SPDX-License-Identifier: MIT
// One searching thread, which brings its own crew.
#include "shell/host_native.h"

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
  return title_ + " — Gaitsmith" + (status_.empty() ? "" : " — " + status_);
}

}  // namespace gaitsmith::shell
