// SPDX-License-Identifier: MIT
// The moments of rods against Lagrange's equations with the energy of the rods added up one by one, and their
// derivatives against differences.
#include "core/spacetime/rod_moments.h"

#include <catch_amalgamated.hpp>
#include <cmath>

#include "core/numeric/random.h"
#include "tests/scene.h"

namespace gaitsmith::test {

namespace {

using Catch::Matchers::WithinAbs;

/// Kinetic energy without that of the centre of mass, from the speeds of the rods' middles.
double InnerEnergy(const Skeleton& skeleton, const Eigen::VectorXd& direction, const Eigen::VectorXd& rate) {
  const double length = static_cast<double>(skeleton.longest_rod_m),
               mass = static_cast<double>(skeleton.mass_kg);
  std::vector<Eigen::Vector2d> end(static_cast<std::size_t>(skeleton.endpoints), Eigen::Vector2d::Zero());
  std::vector<Eigen::Vector2d> middle;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  double turning = 0.0;
  for (int i = 0; i < skeleton.rods; ++i) {
    const Skeleton::Limb& limb = skeleton.limbs[static_cast<std::size_t>(i)];
    const double l = static_cast<double>(limb.length_m) / length,
                 m = static_cast<double>(limb.mass_kg) / mass;
    const Eigen::Vector2d speed =
        l * rate[i] * Eigen::Vector2d(-std::sin(direction[i]), std::cos(direction[i]));
    const Eigen::Vector2d start = end[static_cast<std::size_t>(limb.start)];
    end[static_cast<std::size_t>(i) + 1] = start + speed;
    middle.push_back(start + 0.5 * speed);
    mean += m * middle.back();
    turning += 0.5 * m * l * l / 12.0 * rate[i] * rate[i];
  }
  for (int i = 0; i < skeleton.rods; ++i) {
    const double m = static_cast<double>(skeleton.limbs[static_cast<std::size_t>(i)].mass_kg) / mass;
    turning += 0.5 * m * (middle[static_cast<std::size_t>(i)] - mean).squaredNorm();
  }
  return turning;
}

RodMoments::Numbers SomeNumbers(int count, std::uint64_t seed) {
  RandomStream random(seed, 1, 1);
  RodMoments::Numbers numbers(count);
  for (int i = 0; i < count; ++i) numbers[i] = 4.0 * random.Uniform() - 2.0;
  return numbers;
}

}  // namespace

TEST_CASE("a rod's moment is what Lagrange's equations say", "[spacetime]") {
  const Skeleton skeleton(ShippedFigure("beryl-biped"));
  const RodModel model(skeleton);
  const int n = model.rods;
  RodMoments moments(model, {});
  const RodMoments::Numbers numbers = SomeNumbers(3 * n, 5);
  moments.Set(numbers);
  const Eigen::VectorXd at = numbers.head(n), rate = numbers.segment(n, n), acceleration = numbers.tail(n);
  constexpr double kH = 1e-4;
  // d/dt dT/d(rate) - dT/d(direction), by differences along the motion.
  const auto momentum = [&](double t, int j) {
    const Eigen::VectorXd then = at + t * rate + 0.5 * t * t * acceleration, speed = rate + t * acceleration;
    Eigen::VectorXd more = speed, less = speed;
    more[j] += 0.5;
    less[j] -= 0.5;
    return InnerEnergy(skeleton, then, more) - InnerEnergy(skeleton, then, less);  // exact: T is a quadratic
  };
  for (int j = 0; j < n; ++j) {
    Eigen::VectorXd more = at, less = at;
    more[j] += kH;
    less[j] -= kH;
    const double force = (momentum(kH, j) - momentum(-kH, j)) / (2 * kH) -
                         (InnerEnergy(skeleton, more, rate) - InnerEnergy(skeleton, less, rate)) / (2 * kH);
    CHECK_THAT(moments.Values()[j], WithinAbs(force, 1e-6));
  }
}

TEST_CASE("the derivatives of rods' moments are those of their values", "[spacetime]") {
  const RodModel model(Skeleton(ShippedFigure("mr-star-man")));
  const std::vector<int> contacts{1, 4};
  RodMoments moments(model, contacts);
  const int count = moments.Count();
  const RodMoments::Numbers numbers = SomeNumbers(count, 6);
  const RodModel::Vector weight = SomeNumbers(model.rods, 7);
  moments.Set(numbers);
  RodMoments::Jacobian jacobian, more_jacobian, less_jacobian;
  moments.FillJacobian(jacobian);
  RodMoments::Hessian hessian = RodMoments::Hessian::Zero(count, count);
  moments.AddHessian(weight, hessian);
  constexpr double kH = 1e-5;
  for (int i = 0; i < count; ++i) {
    RodMoments::Numbers more = numbers, less = numbers;
    more[i] += kH;
    less[i] -= kH;
    moments.Set(more);
    const RodModel::Vector more_values = moments.Values();
    moments.FillJacobian(more_jacobian);
    moments.Set(less);
    moments.FillJacobian(less_jacobian);
    CHECK(((more_values - moments.Values()) / (2 * kH) - jacobian.col(i)).lpNorm<Eigen::Infinity>() < 1e-8);
    const Eigen::VectorXd bend = (more_jacobian - less_jacobian).transpose() * weight / (2 * kH);
    CHECK((bend - hessian.col(i)).lpNorm<Eigen::Infinity>() < 1e-8);
  }
}

}  // namespace gaitsmith::test
