// SPDX-License-Identifier: MIT
// The linear system of each step of an interior-point method,
//   | H + D + a I   J^T  | | dx |   | r |
//   |      J        -b I | | dy | = | s |
// with a as small as makes it have the signs of a minimum [Waechter 2006, section 3.1].
#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include "core/spacetime/nonlinear_program.h"

namespace gaitsmith {

class NewtonSystem {
 public:
  NewtonSystem(int variables, int equations) : variables_(variables), equations_(equations) {}

  /// @param diagonal D of the bounds (variables)
  /// @return whether some a up to a limit gives the right signs
  [[nodiscard]] bool Factor(const SparseEntries& hessian, const SparseEntries& jacobian,
                            const Eigen::VectorXd& diagonal);
  /// As Factor, with I in place of H + D: the shortest step that meets the equations.
  [[nodiscard]] bool FactorLeast(const SparseEntries& hessian, const SparseEntries& jacobian, double weight);

  /// @param right (r, s) @return (dx, dy)
  [[nodiscard]] Eigen::VectorXd Solve(const Eigen::VectorXd& right) const;

 private:
  enum class Outcome { kRight, kTooFewPositive, kSingular };
  void Fill(const SparseEntries& hessian, double hessian_share, const SparseEntries& jacobian);
  Outcome Try(const Eigen::VectorXd& diagonal, double convexity);

  int variables_, equations_;
  Eigen::SparseMatrix<double> matrix_;  // lower triangle
  std::vector<int> slot_;               // in the matrix's values, of each entry: diagonal, hessian, jacobian
  Eigen::VectorXd filled_;              // the matrix's values without diagonals
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> factors_;
  double last_convexity_ = 0.0;
};

}  // namespace gaitsmith
