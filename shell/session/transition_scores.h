// SPDX-License-Identifier: MIT
// The transition map of the selected clip, as far as it is known: how well the clip would do if it took over
// at other moments.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/document/transition.h"

namespace gaitsmith::shell {

/// What a host has worked out of a map.
struct TransitionPart {
  int generation = 0;
  int first = 0;  // place of the first score, as of TransitionMap::Scores
  float usual = 0.0f;
  std::vector<float> scores;
};

class TransitionScores {
 public:
  /// There is a map to be worked out, of which nothing is known yet. @param clip has TransitionSteps
  void Begin(const Document&, int clip);
  /// There is none.
  void Clear();
  /// Whether it is the map that the clip of the document has. @param clip any number
  [[nodiscard]] bool IsOf(const Document&, int clip) const;

  /// The host works at it from now on. @return the generation by which its answers are known
  int Start();
  [[nodiscard]] const Document& Request() const { return request_; }
  /// @return false: it belongs to another map, or to none
  bool Take(const TransitionPart&);
  /// Nothing more will become known. @return false: that is said of another map
  bool Fail(int generation);

  [[nodiscard]] bool Any() const { return !steps_.empty(); }
  [[nodiscard]] bool Waits() const { return Any() && state_ == State::kWaiting; }
  [[nodiscard]] bool UnderWay() const { return state_ == State::kRunning; }
  [[nodiscard]] bool Failed() const { return state_ == State::kFailed; }
  [[nodiscard]] int Known() const { return known_; }
  /// Steps at which the clip could take over, ascending, kMomentSpacing apart.
  [[nodiscard]] const std::vector<int>& Steps() const { return steps_; }
  /// Of the usual score, as of ShareOfUsual; nothing where it is not known yet. @param index of Steps()
  [[nodiscard]] std::optional<float> Share(int index) const;
  /// Index of the greatest share, the first of several; -1: nothing is known.
  [[nodiscard]] int Best() const { return best_; }
  /// Index of the moment nearest to a step. @param step any; there are moments
  [[nodiscard]] int Nearest(int step) const;

 private:
  enum class State { kWaiting, kRunning, kDone, kFailed };

  Document request_;
  std::vector<std::uint8_t> key_;  // the request as bytes; empty: none
  int generation_ = 0;             // of the newest start
  State state_ = State::kDone;
  std::vector<int> steps_;
  std::vector<int> order_;  // index of each place
  std::vector<std::optional<float>> shares_;
  int known_ = 0;
  int best_ = -1;
};

}  // namespace gaitsmith::shell
