// SPDX-License-Identifier: MIT
#include "core/spacetime/newton_system.h"

#include <algorithm>
#include <cmath>

namespace gaitsmith {

namespace {

/// b: a trace of freedom in every equation, so that equations that follow from others do no harm. It vanishes
/// from the solution, where multipliers no longer change.
constexpr double kGive = 1e-9;
/// a is never less, for variables that nothing depends on.
constexpr double kLeastConvexity = 1e-10, kFirstConvexity = 1e-4, kMostConvexity = 1e12;
constexpr int kRefinements = 3;

}  // namespace

void NewtonSystem::Fill(const SparseEntries& hessian, double hessian_share, const SparseEntries& jacobian) {
  const int size = variables_ + equations_;
  if (slot_.empty()) {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(static_cast<std::size_t>(size) + hessian.places.size() + jacobian.places.size());
    for (int i = 0; i < size; ++i) entries.emplace_back(i, i, 0.0);
    for (const auto& [row, column] : hessian.places) entries.emplace_back(row, column, 0.0);
    for (const auto& [row, column] : jacobian.places) entries.emplace_back(variables_ + row, column, 0.0);
    matrix_.resize(size, size);
    matrix_.setFromTriplets(entries.begin(), entries.end());
    slot_.reserve(entries.size());
    const int* const rows = matrix_.innerIndexPtr();
    const int* const starts = matrix_.outerIndexPtr();
    for (const auto& entry : entries) {
      const int* const found = std::lower_bound(rows + starts[entry.col()], rows + starts[entry.col() + 1],
                                                static_cast<int>(entry.row()));
      slot_.push_back(static_cast<int>(found - rows));
    }
    factors_.analyzePattern(matrix_);
  }
  filled_ = Eigen::VectorXd::Zero(matrix_.nonZeros());
  auto slot = slot_.begin() + size;
  for (const double value : hessian.values) filled_[*slot++] += hessian_share * value;
  for (const double value : jacobian.values) filled_[*slot++] += value;
}

NewtonSystem::Outcome NewtonSystem::Try(const Eigen::VectorXd& diagonal, double convexity) {
  Eigen::Map<Eigen::VectorXd> values(matrix_.valuePtr(), matrix_.nonZeros());
  values = filled_;
  for (int i = 0; i < variables_; ++i)
    values[slot_[static_cast<std::size_t>(i)]] += diagonal[i] + std::max(convexity, kLeastConvexity);
  for (int i = variables_; i < variables_ + equations_; ++i)
    values[slot_[static_cast<std::size_t>(i)]] -= kGive;
  factors_.factorize(matrix_);
  if (factors_.info() != Eigen::Success) return Outcome::kSingular;
  const Eigen::VectorXd pivots = factors_.vectorD();
  int positive = 0;
  for (const double pivot : pivots) {
    if (!std::isfinite(pivot) || pivot == 0.0) return Outcome::kSingular;
    positive += pivot > 0.0 ? 1 : 0;
  }
  return positive == variables_ ? Outcome::kRight : Outcome::kTooFewPositive;
}

bool NewtonSystem::Factor(const SparseEntries& hessian, const SparseEntries& jacobian,
                          const Eigen::VectorXd& diagonal) {
  Fill(hessian, 1.0, jacobian);
  if (Try(diagonal, 0.0) == Outcome::kRight) return true;
  double convexity =
      last_convexity_ == 0.0 ? kFirstConvexity : std::max(kLeastConvexity, last_convexity_ / 3.0);
  while (convexity < kMostConvexity) {
    if (Try(diagonal, convexity) == Outcome::kRight) {
      last_convexity_ = convexity;
      return true;
    }
    convexity *= last_convexity_ == 0.0 ? 100.0 : 8.0;
  }
  return false;
}

bool NewtonSystem::FactorLeast(const SparseEntries& hessian, const SparseEntries& jacobian, double weight) {
  Fill(hessian, 0.0, jacobian);
  return Try(Eigen::VectorXd::Constant(variables_, weight), 0.0) == Outcome::kRight;
}

Eigen::VectorXd NewtonSystem::Solve(const Eigen::VectorXd& right) const {
  Eigen::VectorXd solution = factors_.solve(right);
  // The factors have no pivoting: correct what rounding left.
  for (int i = 0; i < kRefinements; ++i) {
    const Eigen::VectorXd off = right - matrix_.selfadjointView<Eigen::Lower>() * solution;
    if (off.lpNorm<Eigen::Infinity>() <= 1e-13 * right.lpNorm<Eigen::Infinity>()) break;
    solution += factors_.solve(off);
  }
  return solution;
}

}  // namespace gaitsmith
