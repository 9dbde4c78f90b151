// SPDX-License-Identifier: MIT
// A motion-synthesis problem: everything except the genome that determines a score.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/control/controller.h"
#include "core/rollout/body_shape.h"
#include "core/rollout/task.h"
#include "core/world/environment.h"

namespace gaitsmith {

/// A controller that takes over at a step. The whole state of the figure carries over, including joint rates.
struct Clip {
  int controller = 0;  // index into a list of controllers
  int start_step = 0;
};

/// What the figure does before the scored controller takes over.
struct Beginning {
  std::vector<Controller> controllers;
  std::vector<Clip> clips;  // sorted by start_step, the first at 0; if empty, the drawn pose is held
  int steps = 0;            // [0, kMaxSteps]
};

/// Another world in which a genome is tried, so that what a search finds needs nothing to be exact: neither
/// masses nor friction, nor that joints follow a decision at once.
struct TrialWorld {
  float friction = 1.0f;           // times that of the environment
  float slope_rad = 0.0f;          // added to that of the environment
  std::vector<float> masses = {};  // times that of each rod or node; empty: all as they are
  int delay_steps = 0;             // from a decision until the joints follow it, [0, kMostDelaySteps]
  int substeps = 1;                // times those of the problem

  bool operator==(const TrialWorld&) const = default;
};
inline constexpr int kMostDelaySteps = 8;
inline constexpr int kMostSubsteps = 64;

struct Problem {
  Figure figure;  // must be valid
  Environment environment;
  StartState start;
  std::vector<Push> pushes;  // sorted by step
  Task task;
  SenseSpec senses;
  int rules = 10;  // a bank's rules, a network's hidden nodes or a trajectory's knots, [1, kMaxRules]
  ControllerKind kind = ControllerKind::kRules;
  /// Where the controller takes over. If empty, it starts the motion. With several beginnings the controller
  /// is scored from each of them, and its score is the mean: this finds robust controllers [Fukunaga 1994,
  /// section 6].
  std::vector<Beginning> beginnings = {};
  /// Worlds in which the controller is scored as well, and its score is the mean. Terms and traits are means
  /// too; hashes are those of the problem's own world.
  std::vector<TrialWorld> worlds = {};
  int delay_steps = 0;     // from a decision until the joints follow it
  int substeps = 1;        // of the plant in each step of the controller, a power of two up to kMostSubsteps
  bool traits = false;     // whether evaluations measure how motions look
  bool all_terms = false;  // whether they measure the further terms that have no weight, too
  int model = 1;           // version of the physical model, which chooses the plant, [1, kModelVersion]
  /// The bodies that genomes may have, of which `figure` is the unchanged one. Nothing: all have that.
  std::optional<BodyRange> bodies = {};

  /// The shape of the genomes that the search tries: controllers, and bodies if they may change.
  [[nodiscard]] ControllerShape Shape() const;
  /// The shape of the controllers alone.
  [[nodiscard]] ControllerShape ShapeFor(const PortCount& ports) const {
    return {kind, rules, senses.kind, ports};
  }
  /// The same problem in one of its worlds.
  [[nodiscard]] Problem In(const TrialWorld&) const;
  /// The problem of all genomes that have the body of this one, in which only controllers differ.
  [[nodiscard]] Problem WithBodyOf(std::span<const Gene> genome) const;
};

}  // namespace gaitsmith
