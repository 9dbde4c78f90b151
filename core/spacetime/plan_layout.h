// SPDX-License-Identifier: MIT
// The unknowns of a plan, and where each is in the list of all: splines over time for the centre of mass and
// for the absolute directions of the rods, forces of standing endpoints as splines two degrees lower,
// impulses of landings, and places where endpoints stand. Units: the figure's mass, its longest rod, standard
// gravity.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "core/spacetime/plan_ground.h"
#include "core/spacetime/planned_motion.h"
#include "core/spacetime/rod_moments.h"
#include "core/spacetime/spline_space.h"

namespace gaitsmith {

/// An instant of a plan, and which unknowns matter in it.
struct PlanInstant {
  int phase = 0;
  double time = 0.0;
  double weight = 0.0;                     // in an integral over time
  std::array<SplineShares, 3> position{};  // of value, rate and acceleration in a curve's coefficients
  SplineShares force{};                    // in a force's coefficients
  bool impulsive = false;                  // a landing: jumps of rates for accelerations, impulses for forces
};

struct PlanLayout {
  struct Point {
    double x, y;
  };

  PlanLayout(const PlanScene&, const PlanGrid&);

  /// A stretch of time in which the same endpoints stand.
  struct Phase {
    int first_step, last_step;
    int first_piece = 0, pieces = 0;
    bool lands = false;           // an endpoint begins to stand at its beginning, which is not the start
    std::vector<int> stances{};   // of the plan
    std::vector<int> contacts{};  // their endpoints
    std::vector<int> forces{};    // first unknown of each; two for each coefficient
    std::vector<int> impulses{};  // first of two unknowns of each, if the phase lands
  };

  RodModel model;
  PlanGround ground;
  double length_m, mass_kg, time_s;  // units
  double friction;
  double gravity_x, gravity_y;
  double start_x, start_y;  // of the centre of mass
  double start_rate_x, start_rate_y, start_spin;
  std::vector<double> start_direction;  // of each rod
  std::vector<Phase> phases;
  std::vector<double> breaks;  // of the pieces
  SplineSpace positions, forces;
  std::vector<int> stance_place;    // unknown x of each stance; -1: it stands from the start
  std::vector<Point> stance_start;  // where those stand; of the others only y counts
  int unknowns;

  /// First coefficient of a curve: 0 and 1 are the centre of mass, 2 + i the direction of rod i.
  [[nodiscard]] int Curve(int curve) const { return curve * positions.Size(); }
  [[nodiscard]] int Curves() const { return 2 + model.rods; }
  [[nodiscard]] double TimeOf(int step) const { return step * step_; }
  /// @return the piece of a time; at a break the later one
  [[nodiscard]] int PieceAt(double time) const;
  [[nodiscard]] PlanInstant At(int piece, double time) const;
  [[nodiscard]] PlanInstant Landing(int phase) const;
  /// First of two unknowns for each share of the force on a contact of the instant's phase.
  [[nodiscard]] int ForceUnknown(const PlanInstant&, std::size_t contact) const;

  /// What the unknowns say of an instant.
  [[nodiscard]] double ValueOf(const Eigen::VectorXd& x, int curve, const SplineShares&) const;
  /// For RodMoments of the phase's contacts.
  [[nodiscard]] RodMoments::Numbers NumbersAt(const Eigen::VectorXd& x, const PlanInstant&) const;
  /// Where an endpoint is, or, beyond their number, the middle of a rod.
  [[nodiscard]] Point EndpointAt(const Eigen::VectorXd& x, const PlanInstant&, int endpoint) const;

 private:
  double step_;
};

}  // namespace gaitsmith
