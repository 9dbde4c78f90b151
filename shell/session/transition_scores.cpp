// SPDX-License-Identifier: MIT
#include "shell/session/transition_scores.h"

#include <algorithm>
#include <cmath>

#include "core/document/binary.h"

namespace gaitsmith::shell {

Takeover VerdictOn(float share) {
  return share >= 0.8f ? Takeover::kGood : share >= 0.5f ? Takeover::kFair : Takeover::kPoor;
}

void TransitionScores::Begin(const Document& document, int clip) {
  Clear();
  request_ = TransitionRequest(document, clip);
  key_ = EncodeBinary(request_);
  steps_ = TransitionSteps(document, clip);
  order_ = CoarseFirst(static_cast<int>(steps_.size()));
  shares_.assign(steps_.size(), std::nullopt);
  state_ = State::kWaiting;
}

void TransitionScores::Clear() {
  request_ = {};
  key_.clear();
  steps_.clear();
  order_.clear();
  shares_.clear();
  known_ = 0;
  best_ = -1;
  state_ = State::kDone;
}

bool TransitionScores::IsOf(const Document& document, int clip) const {
  if (TransitionSteps(document, clip) != steps_) return false;
  return steps_.empty() || EncodeBinary(TransitionRequest(document, clip)) == key_;
}

int TransitionScores::Start() {
  state_ = State::kRunning;
  return ++generation_;
}

bool TransitionScores::Take(const TransitionPart& part) {
  if (state_ != State::kRunning || part.generation != generation_) return false;
  const auto first = static_cast<std::size_t>(std::max(0, part.first));
  if (part.first < 0 || first > order_.size() || part.scores.size() > order_.size() - first) return false;
  for (std::size_t i = 0; i < part.scores.size(); ++i) {
    const int index = order_[first + i];
    auto& share = shares_[static_cast<std::size_t>(index)];
    if (share) continue;
    const float score = part.scores[i];
    share = std::isfinite(score) ? ShareOfUsual(score, part.usual) : kVoidScore;
    ++known_;
    if (*share <= kVoidScore) continue;  // broke physics: not a moment to choose
    const auto best = Share(best_);
    if (!best || *share > *best || (*share == *best && index < best_)) best_ = index;
  }
  if (known_ == static_cast<int>(steps_.size())) state_ = State::kDone;
  return true;
}

bool TransitionScores::Fail(int generation) {
  if (state_ != State::kRunning || generation != generation_) return false;
  state_ = State::kFailed;
  return true;
}

std::optional<float> TransitionScores::Share(int index) const {
  if (index < 0) return std::nullopt;
  return shares_[static_cast<std::size_t>(index)];
}

int TransitionScores::NearestGood(int step) const {
  int nearest = -1;
  const auto far = [&](int index) { return std::abs(steps_[static_cast<std::size_t>(index)] - step); };
  for (int i = 0; i < static_cast<int>(steps_.size()); ++i) {
    const auto share = Share(i);
    if (!share || VerdictOn(*share) != Takeover::kGood) continue;
    if (nearest < 0 || far(i) < far(nearest)) nearest = i;
  }
  return nearest;
}

int TransitionScores::Nearest(int step) const {
  const int last = static_cast<int>(steps_.size()) - 1;
  const float index = static_cast<float>(step - steps_.front()) / static_cast<float>(kMomentSpacing);
  return std::clamp(static_cast<int>(std::lround(index)), 0, last);
}

}  // namespace gaitsmith::shell
