// SPDX-License-Identifier: MIT
// A motion-synthesis problem: everything that turns a genome into a score, but the genome.
#pragma once

#include <vector>

#include "core/control/controller.h"
#include "core/physics/environment.h"
#include "core/physics/figure.h"
#include "core/physics/task.h"

namespace gaitsmith {

struct Problem {
  Figure figure;  // valid
  Environment environment;
  StartState start;
  std::vector<Push> pushes;  // sorted by step
  Task task;
  SenseSpec senses;
  int rules = 10;  // or a network's hidden nodes, [1, kMaxRules]
  ControllerKind kind = ControllerKind::kRules;

  [[nodiscard]] ControllerShape Shape() const { return {kind, rules, senses.kind, figure.Rods()}; }
};

}  // namespace gaitsmith
