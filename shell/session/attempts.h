// SPDX-License-Identifier: MIT
// Attempts of the running search, played beside the best motion in time with it: what the computer tries
// while it learns. They stay for a few seconds after the search, then they are gone.
#pragma once

#include <list>

#include "core/document/document.h"
#include "shell/workspace/playback.h"

namespace gaitsmith::shell {

class Attempts {
 public:
  /// How many play at once.
  static constexpr std::size_t kMost = 6;

  /// Forgets those of the search before. @param searched  the document of the search that begins
  void Begin(const Document& searched);
  /// Adds an attempt, in place of the oldest. Does nothing if the last one is too recent to be seen.
  void Add(const Genome& genes, double now_s);
  /// The search has ended. @param now_s  time during which the motion played, above 0
  void End(double now_s);
  void Clear() { shown_.clear(); }
  /// Moves all to the shown moment, and removes them when their time is over.
  void Follow(double time_s, double now_s);

  [[nodiscard]] const std::list<Playback>& Shown() const { return shown_; }
  /// How clearly they are drawn, in [0, 1].
  [[nodiscard]] float Strength() const { return strength_; }

 private:
  Document searched_;
  std::list<Playback> shown_;
  double added_s_ = 0.0;
  double ended_s_ = 0.0;  // 0: the search runs
  float strength_ = 1.0f;
};

}  // namespace gaitsmith::shell
