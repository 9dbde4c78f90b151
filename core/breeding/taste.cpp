// SPDX-License-Identifier: MIT
#include "core/breeding/taste.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <vector>

#include "core/numeric/scalar_math.h"

namespace gaitsmith {

namespace {

constexpr auto kSize = static_cast<Eigen::Index>(kTraits);
using Vector = Eigen::Matrix<double, kSize, 1>;
using Matrix = Eigen::Matrix<double, kSize, kSize>;

constexpr int kMostSteps = 50;
constexpr double kSmallStep = 1e-9;
constexpr double kPrecision =
    1.0 / (static_cast<double>(Taste::kPriorDoubt) * static_cast<double>(Taste::kPriorDoubt));

double Logistic(double x) {
  const double e = Exp(-std::abs(x));
  return x >= 0.0 ? 1.0 / (1.0 + e) : e / (1.0 + e);
}

constexpr double kLeastUnit = 0.15;  // of a scale: smaller differences are not seen

/// How much of a scale counts as a plain difference, from what was compared: eyes adapt to what is shown, so
/// if all motions differ little in a trait, little is plain.
Vector Units(std::span<const Vector> differences) {
  Vector units = Vector::Ones();
  for (Eigen::Index i = 0; i < kSize; ++i) {
    double sum = 0.0;
    for (const Vector& one : differences) sum += one[i] * one[i];
    if (sum > 0.0)
      units[i] = std::clamp(std::sqrt(sum / static_cast<double>(differences.size())), kLeastUnit, 1.0);
  }
  return units;
}

/// In scales, at most 3: what differs more than plainly does not count for more and more.
Vector Difference(const Traits& first, const Traits& second) {
  Vector difference;
  for (std::size_t i = 0; i < kTraits; ++i) {
    const auto scaled = static_cast<double>((first[i] - second[i]) / kTraitTable[i].scale);
    difference[static_cast<Eigen::Index>(i)] = std::clamp(scaled, -3.0, 3.0);
  }
  return difference;
}

/// The share of a comparison that went to the first motion.
double ShareOfFirst(Verdict verdict) {
  return verdict == Verdict::kFirst ? 1.0 : verdict == Verdict::kSecond ? 0.0 : 0.5;
}

}  // namespace

Taste::Taste(std::span<const Comparison> comparisons) {
  std::vector<Vector> differences;
  differences.reserve(comparisons.size());
  for (const Comparison& one : comparisons) differences.push_back(Difference(one.first, one.second));
  const Vector units = Units(differences);
  for (Vector& one : differences) one = one.cwiseQuotient(units);

  // Newton's method on the logarithm of the posterior, which is concave.
  Vector weights = Vector::Zero();
  Matrix precision;
  for (int step = 0; step < kMostSteps; ++step) {
    Vector slope = -kPrecision * weights;
    precision = kPrecision * Matrix::Identity();
    for (std::size_t i = 0; i < differences.size(); ++i) {
      const double chance = Logistic(weights.dot(differences[i]));
      slope += (ShareOfFirst(comparisons[i].verdict) - chance) * differences[i];
      precision += chance * (1.0 - chance) * differences[i] * differences[i].transpose();
    }
    const Vector change = precision.llt().solve(slope);
    // Far from the maximum a whole step may overshoot.
    const double longest = change.cwiseAbs().maxCoeff();
    weights += longest > 1.0 ? Vector(change / longest) : change;
    if (longest < kSmallStep) break;
  }
  weights = weights.cwiseQuotient(units);
  const Matrix to_scales = units.cwiseInverse().asDiagonal();
  const Matrix covariance = to_scales * precision.llt().solve(Matrix::Identity()) * to_scales;
  for (std::size_t i = 0; i < kTraits; ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    weights_[i] = static_cast<float>(weights[at]);
    doubts_[i] = static_cast<float>(std::sqrt(covariance(at, at)));
    for (std::size_t j = 0; j < kTraits; ++j)
      covariance_[i][j] = static_cast<float>(covariance(at, static_cast<Eigen::Index>(j)));
  }
}

float Taste::ChanceOfFirst(const Traits& first, const Traits& second) const {
  double worth = 0.0;
  const Vector difference = Difference(first, second);
  for (std::size_t i = 0; i < kTraits; ++i)
    worth += static_cast<double>(weights_[i]) * difference[static_cast<Eigen::Index>(i)];
  return static_cast<float>(Logistic(worth));
}

float Taste::Telling(const Traits& first, const Traits& second) const {
  const Vector difference = Difference(first, second);
  double variance = 0.0;
  for (std::size_t i = 0; i < kTraits; ++i) {
    for (std::size_t j = 0; j < kTraits; ++j) {
      variance += difference[static_cast<Eigen::Index>(i)] * difference[static_cast<Eigen::Index>(j)] *
                  static_cast<double>(covariance_[i][j]);
    }
  }
  const auto chance = static_cast<double>(ChanceOfFirst(first, second));
  return static_cast<float>(0.5 * Log(1.0 + chance * (1.0 - chance) * std::max(0.0, variance)));
}

}  // namespace gaitsmith
