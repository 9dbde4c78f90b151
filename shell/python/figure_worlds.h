// SPDX-License-Identifier: MIT
// Figures whose joints follow targets from outside instead of a controller's, for reinforcement learning: the
// plants of the physical models, one for each world, because each has a clock, pushes and a start of its own.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/rollout/problem.h"

namespace gaitsmith::python {

enum class Observation {
  kSenses,  // what a controller of the problem senses, normalised
  kState,  // angles or lengths and their rates, turn and turn rate of the root, height and velocity, contacts
};

/// What one world did in a step.
struct WorldStep {
  double progress = 0.0;    // of the task's primary term
  bool terminated = false;  // physics broke: the motion is void
  bool truncated = false;   // the task's duration is over
};

class FigureWorlds {
 public:
  virtual ~FigureWorlds() = default;

  /// Places a world's figure at the start.
  /// @param velocity_x_mps, velocity_y_mps, spin_radps added to the problem's start
  virtual void Reset(std::size_t world, float velocity_x_mps, float velocity_y_mps, float spin_radps) = 0;
  /// Advances a world by some simulation steps with constant targets, or until it ends.
  /// @param targets of each joint relative to the drawn pose [rad], brought into its limits
  virtual WorldStep Step(std::size_t world, std::span<const float> targets, int steps) = 0;
  /// Writes a world's observation. Numbers of a figure whose physics broke that are not finite become 0.
  virtual void Observe(std::size_t world, std::span<float> observation) const = 0;
  /// How far the centre of mass has come since the start, to the right positive [m].
  [[nodiscard]] virtual double TravelOf(std::size_t world) const = 0;

  [[nodiscard]] virtual std::vector<std::array<float, 2>> JointLimits() const = 0;
  /// What an observation's numbers are, such as "theta_1".
  [[nodiscard]] virtual std::vector<std::string> Names() const = 0;
};

/// @param problem with one world, that begins at its start @param worlds >= 1
/// @param tau_s   with which joints approach their targets [s], > 0
[[nodiscard]] std::unique_ptr<FigureWorlds> MakeFigureWorlds(const Problem&, std::size_t worlds, Observation,
                                                             float tau_s);

}  // namespace gaitsmith::python
