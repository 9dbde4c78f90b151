// SPDX-License-Identifier: MIT
// A motion that fulfils a plan: where every part of the figure is at any instant, and which forces and
// torques that takes.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/spacetime/plan.h"

namespace gaitsmith {

/// A figure, its world and a plan.
struct PlanScene {
  Skeleton skeleton;
  Environment environment;
  StartState start;
  Plan plan;  // valid
};

/// How finely a motion is described.
struct PlanGrid {
  int degree = 3;  // of positions, [3, 5]
  int pieces_per_second = 16;
};

/// How many numbers describe the motion of a plan.
[[nodiscard]] int UnknownsOf(const PlanScene&, const PlanGrid&);

class PlannedMotion {
 public:
  /// @param unknowns as many as the plan has with this grid (plan_layout.h)
  PlannedMotion(const PlanScene&, const PlanGrid&, std::span<const double> unknowns);
  PlannedMotion(PlannedMotion&&) noexcept;
  PlannedMotion& operator=(PlannedMotion&&) noexcept;
  ~PlannedMotion();

  struct Vector {
    double x, y;
  };
  struct Instant {
    Vector centre;                      // of mass [m]
    std::vector<Vector> endpoints;      // [m] (endpoints)
    std::vector<Vector> forces;         // of the ground [N] (endpoints)
    std::vector<double> direction_rad;  // of rods (rods)
    std::vector<double> angle_rad;      // of joints, relative to the drawn ones (joints)
    std::vector<double> torque_nm;      // of joints (joints)
    double moment_residual;             // what the equation of the moment misses [M g l]
    double force_residual;              // what that of the centre of mass misses [M g]
  };
  /// @param time_s [0, the motion's duration]
  [[nodiscard]] Instant At(double time_s) const;
  [[nodiscard]] double DurationS() const;
  /// At the ends of the pieces; between two of them everything is smooth.
  [[nodiscard]] std::vector<double> BreaksS() const;
  /// Of the ground on an endpoint that stands when one lands [N s].
  struct Blow {
    double time_s;
    int endpoint;
    Vector impulse;
  };
  [[nodiscard]] std::vector<Blow> Blows() const;

  [[nodiscard]] const PlanScene& Scene() const;
  [[nodiscard]] const PlanGrid& Grid() const;
  [[nodiscard]] std::span<const double> Unknowns() const;

 private:
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace gaitsmith
