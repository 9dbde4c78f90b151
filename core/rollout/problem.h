// SPDX-License-Identifier: MIT
// A motion-synthesis problem: everything that turns a genome into a score, but the genome.
#pragma once

#include <vector>

#include "core/control/controller.h"
#include "core/physics/environment.h"
#include "core/physics/figure.h"
#include "core/rollout/task.h"

namespace gaitsmith {

/// A controller that takes over at a step. The whole state of the figure, joint rates included, carries
/// across.
struct Clip {
  int controller = 0;  // index into a list of controllers
  int start_step = 0;
};

/// What the figure does before the controller that is scored takes over.
struct Beginning {
  std::vector<Controller> controllers;
  std::vector<Clip> clips;  // sorted by start_step, the first at 0; with none it holds its drawn pose
  int steps = 0;            // [0, kMaxSteps]
};

struct Problem {
  Figure figure;  // valid
  Environment environment;
  StartState start;
  std::vector<Push> pushes;  // sorted by step
  Task task;
  SenseSpec senses;
  int rules = 10;  // or a network's hidden nodes, [1, kMaxRules]
  ControllerKind kind = ControllerKind::kRules;
  /// Where the controller takes over; none: at the start. With several it is scored from each of them, and
  /// what counts is the mean: a robust controller [Fukunaga 1994, section 6].
  std::vector<Beginning> beginnings = {};
  int model = 1;  // version of the physical model, [1, kModelVersion]: which plant simulates

  /// Of the controllers that are searched for.
  [[nodiscard]] ControllerShape Shape() const;
  /// The same for a plant that no model names.
  [[nodiscard]] ControllerShape ShapeFor(const PortCount& ports) const {
    return {kind, rules, senses.kind, ports};
  }
};

}  // namespace gaitsmith
