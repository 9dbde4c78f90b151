// SPDX-License-Identifier: MIT
// What must hold in a planned motion, at which instants, and which further variables that takes: by direct
// collocation [Hargraves 1987]. The equations of the centre of mass hold at as many instants as a force has
// coefficients, and so at every instant; that of the moment at the same instants.
#pragma once

#include <vector>

#include "core/spacetime/plan_layout.h"
#include "core/spacetime/plan_miss.h"

namespace gaitsmith {

struct PlanConditions {
  /// @param guess   unknowns of a first idea of the motion: it says which way up a rod lies
  /// @param elastic what the animator wants may be missed, at a cost: to find out what cannot be met
  PlanConditions(const PlanScene&, const PlanLayout&, const Eigen::VectorXd& guess, bool elastic);

  /// A standing endpoint keeps its place.
  struct Pin {
    PlanInstant at;
    int stance;
    bool x;  // whether also along the ground
  };
  /// A point in the air is above the ground.
  struct Clearance {
    PlanInstant at;
    int point;   // an endpoint, or beyond their number the middle of a rod
    int height;  // variable
  };
  /// A coefficient of a joint's angle is within the joint's limits.
  struct Limit {
    int joint, coefficient;
    int angle;  // variable; -1: a locked joint
  };
  /// A linear equation: the sum of a curve's shares, less those of another curve, is a value.
  struct Line {
    int curve, less;  // -1: none
    SplineShares shares;
    double value;
    int give = -1;  // first of two elastic variables: what is missed above and below
  };
  /// An endpoint is at a place.
  struct Aim {
    PlanInstant at;
    int endpoint;
    bool x;
    double value;
    int give = -1;
  };
  struct Give {
    PlanPart part;
    int first;  // of two variables
  };

  // Of all variables: the layout's unknowns, then those that conditions add.
  std::vector<double> lower, upper;
  std::vector<double> reach;  // see NonlinearProgram

  std::vector<PlanInstant> newton, quadrature;
  std::vector<Pin> pins;
  std::vector<Clearance> clearances;
  std::vector<Limit> limits;
  std::vector<Line> lines;
  std::vector<Aim> aims;
  std::vector<int> stance_give;  // first of four elastic variables of each stance: x, then y; -1: none
  std::vector<Give> gives;

 private:
  int AddVariable(double least, double most, double step);
  int AddGive(PlanPart part);
  void AddStart();
  void AddPhase(const Eigen::VectorXd& guess, std::size_t phase);
  void AddEquations(std::size_t phase);
  /// @param centres of the coefficients of a position that starts and ends with the phase
  void AddPins(const Eigen::VectorXd& guess, std::size_t phase, const std::vector<double>& centres);
  void AddClearances(std::size_t phase, const std::vector<double>& centres);
  /// Whether an endpoint stands in a phase; there may be no such phase.
  [[nodiscard]] bool Stands(std::size_t phase, int endpoint) const;
  void AddKeyframe(std::size_t keyframe);
  void AddLimits();

  const PlanScene& scene_;
  const PlanLayout& layout_;
  bool elastic_;
};

}  // namespace gaitsmith
