// SPDX-License-Identifier: MIT
// The known part of the selected clip's transition map: the scores if the clip took over at other moments.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/document/transition.h"

namespace gaitsmith::shell {

/// A part of a map, computed by the host.
struct TransitionPart {
  int generation = 0;
  int first = 0;  // place of the first score in the order of TransitionMap::Scores
  float usual = 0.0f;
  std::vector<float> scores;
};

/// How well a clip takes over: what it then scores, as a share of its usual score (ShareOfUsual).
enum class Takeover { kGood, kFair, kPoor };
/// The one verdict: of the map, of a clip's warning, and of moments to snap to.
[[nodiscard]] Takeover VerdictOn(float share);

class TransitionScores {
 public:
  /// Starts an empty map. @param clip has TransitionSteps
  void Begin(const Document&, int clip);
  /// Removes the map.
  void Clear();
  /// Whether this is the map of the document's clip. @param clip any number
  [[nodiscard]] bool IsOf(const Document&, int clip) const;

  /// Call when the host starts to compute the map. @return the generation that marks its answers
  int Start();
  [[nodiscard]] const Document& Request() const { return request_; }
  /// Adds a part. @return false: it belongs to another map
  bool Take(const TransitionPart&);
  /// No more parts will arrive. @return false: the failure is of another map
  bool Fail(int generation);

  [[nodiscard]] bool Any() const { return !steps_.empty(); }
  [[nodiscard]] bool Waits() const { return Any() && state_ == State::kWaiting; }
  [[nodiscard]] bool UnderWay() const { return state_ == State::kRunning; }
  [[nodiscard]] bool Failed() const { return state_ == State::kFailed; }
  [[nodiscard]] int Known() const { return known_; }
  /// Steps at which the clip could take over, ascending, kMomentSpacing apart.
  [[nodiscard]] const std::vector<int>& Steps() const { return steps_; }
  /// The share of the usual score (ShareOfUsual); nothing if it is not known yet. @param index of Steps()
  [[nodiscard]] std::optional<float> Share(int index) const;
  /// Index of the greatest share, the first of equal ones; -1: none is known.
  [[nodiscard]] int Best() const { return best_; }
  /// Index of the good moment nearest to a step, the earlier of two; -1: none is known. @param step any
  [[nodiscard]] int NearestGood(int step) const;
  /// Index of the moment nearest to a step. Steps() must not be empty. @param step any
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
