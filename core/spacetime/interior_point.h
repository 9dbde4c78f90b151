// SPDX-License-Identifier: MIT
// A primal-dual interior-point method with a filter line search, after [Waechter 2006].
#pragma once

#include <functional>

#include "core/spacetime/nonlinear_program.h"

namespace gaitsmith {

struct InteriorPointSettings {
  double tolerance = 1e-6;  // of the equations and of the slopes, scaled as the program is
  double first_barrier = 0.1;
  int most_iterations = 300;
};

/// Where a solution stands. Given again, a changed program of the same shape is solved from there.
struct PrimalDual {
  Eigen::VectorXd x{};               // (variables)
  Eigen::VectorXd multipliers{};     // of the equations; empty: estimated
  Eigen::VectorXd lower{}, upper{};  // multipliers of the bounds, at least 0; empty: estimated
};

enum class SolveEnd {
  kSolved,
  kStuck,      // no step makes it better: most likely the equations cannot be met
  kTooLong,    // most_iterations
  kCancelled,  // by the caller
};

struct Solved {
  SolveEnd end;
  PrimalDual at;  // the last point, whatever the end
  int iterations = 0;
  double objective = 0.0;
  double violation = 0.0;  // greatest of the equations
};

/// @param start  x need not meet anything: it is pushed inside its bounds
/// @param watch  called before every iteration with the point; false cancels. May be empty
[[nodiscard]] Solved Minimize(const NonlinearProgram&, PrimalDual start, const InteriorPointSettings&,
                              const std::function<bool(const Eigen::VectorXd& x, int iteration)>& watch = {});

}  // namespace gaitsmith
