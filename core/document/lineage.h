// SPDX-License-Identifier: MIT
// The line of picks behind a bred motion: whom a person chose, round by round, as a tree. Children are not
// kept: they follow from their round and those before it (core/breeding/litter.h).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/control/controller.h"
#include "core/rollout/task.h"

namespace gaitsmith {

inline constexpr int kMaxFounders = 16;
inline constexpr int kMaxBreedRounds = 128;
/// Children of a round.
inline constexpr int kLitter = 9;

/// One round: which motions became parents, and what was wished of their children.
struct BreedRound {
  std::string name;         // that a person gave, or empty
  int parent = -1;          // the round whose children were picked, before this one; -1: the founders
  std::uint32_t picks = 1;  // bit i: child i of that round, or founder i; at least one
  std::uint32_t seed = 1;
  float difference = 0.3f;        // BreedWish::difference, [0, 1]
  bool keep_goal = false;         // BreedWish::keep_goal
  std::uint32_t kept_rules = 0;   // bit i: rule i stays as in the first parent
  std::uint32_t kept_joints = 0;  // bit i: the targets of joint i stay
  Task task;                      // what children become better at
};

struct Lineage {
  std::vector<Controller> founders;  // all of one kind, with the same senses and number of rules
  std::vector<BreedRound> rounds;    // empty only if there are no founders
  int shown = 0;                     // the round whose children a person looks at
};

}  // namespace gaitsmith
