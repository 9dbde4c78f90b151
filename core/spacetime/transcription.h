// SPDX-License-Identifier: MIT
// A plan as a nonlinear program. Coefficients of forces are multiples of the edges of friction's cone, at
// least 0, so forces lie in it at every instant.
#pragma once

#include "core/spacetime/nonlinear_program.h"
#include "core/spacetime/plan_conditions.h"

namespace gaitsmith {

class Transcription final : public NonlinearProgram {
 public:
  /// As PlanConditions. The layout must outlive this.
  Transcription(const PlanScene&, const PlanLayout&, const Eigen::VectorXd& guess, bool elastic = false);

  [[nodiscard]] int Variables() const override { return static_cast<int>(lower_.size()); }
  [[nodiscard]] int Equations() const override { return equations_; }
  [[nodiscard]] const Eigen::VectorXd& Lower() const override { return lower_; }
  [[nodiscard]] const Eigen::VectorXd& Upper() const override { return upper_; }
  [[nodiscard]] const Eigen::VectorXd& Reach() const override { return reach_; }
  [[nodiscard]] Values ValuesAt(const Eigen::VectorXd& x) const override;
  void SlopesAt(const Eigen::VectorXd& x, const Eigen::VectorXd& multipliers, Slopes& out) const override;

  /// All variables from the layout's unknowns: the others follow from them.
  [[nodiscard]] Eigen::VectorXd Completed(const Eigen::VectorXd& unknowns) const;

  /// By how much an elastic solution misses each part of the plan, in longest rods or radians.
  /// The greatest first.
  [[nodiscard]] std::vector<PlanMiss> MissesOf(const Eigen::VectorXd& x) const;

 private:
  template <bool kSlopes>
  struct Pass;
  template <bool kSlopes>
  void Go(Pass<kSlopes>& pass) const;

  const PlanLayout& layout_;
  PlanConditions conditions_;
  bool elastic_;
  double smoothness_;
  RodModel::Matrix torques_;  // of joints that can turn, as sums over rods (rods, rods)
  Eigen::VectorXd lower_, upper_, reach_;
  int equations_ = 0;
};

}  // namespace gaitsmith
