// SPDX-License-Identifier: MIT
// A smooth function to make small, subject to equations and to bounds on its variables. An inequality is an
// equation with a bounded variable of its own.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace gaitsmith {

/// Entries of a sparse matrix in the order in which they were added. Several may have the same place.
struct SparseEntries {
  struct Mark {
    int row, column;
  };
  std::vector<Mark> places;
  std::vector<double> values;

  void Clear() {
    places.clear();
    values.clear();
  }
  void Add(int row, int column, double value) {
    places.push_back({row, column});
    values.push_back(value);
  }
};

class NonlinearProgram {
 public:
  virtual ~NonlinearProgram() = default;

  [[nodiscard]] virtual int Variables() const = 0;
  [[nodiscard]] virtual int Equations() const = 0;
  /// Infinite where there is none; a variable's lower bound is below its upper one. (variables)
  [[nodiscard]] virtual const Eigen::VectorXd& Lower() const = 0;
  [[nodiscard]] virtual const Eigen::VectorXd& Upper() const = 0;
  /// No step may change a variable by more than this. Infinite where any step may. (variables)
  [[nodiscard]] virtual const Eigen::VectorXd& Reach() const = 0;

  struct Values {
    double objective = 0.0;
    Eigen::VectorXd equations;  // 0 where they hold
  };
  [[nodiscard]] virtual Values ValuesAt(const Eigen::VectorXd& x) const = 0;

  struct Slopes {
    Eigen::VectorXd gradient;  // of the objective
    SparseEntries jacobian;    // (equations, variables)
    SparseEntries hessian;     // of objective + multipliers . equations, lower triangle
  };
  /// The places of all entries are the same in every call.
  virtual void SlopesAt(const Eigen::VectorXd& x, const Eigen::VectorXd& multipliers, Slopes& out) const = 0;
};

}  // namespace gaitsmith
