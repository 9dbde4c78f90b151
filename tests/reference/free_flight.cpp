// SPDX-License-Identifier: MIT
#include "tests/reference/free_flight.h"

#include <cmath>

namespace gaitsmith::test {

FreeFlight::Shape FreeFlight::ShapeAt(const Angles& angle, const Angles& rate) const {
  const auto rods = static_cast<std::size_t>(bones_.rods);
  std::vector<double> direction(rods, 0.0), turning(rods, 0.0);
  std::vector<Eigen::Vector2d> end(rods + 1, Eigen::Vector2d::Zero()),
      end_velocity(rods + 1, Eigen::Vector2d::Zero());
  std::vector<Eigen::Vector2d> middle(rods), velocity(rods);
  Eigen::Vector2d centre = Eigen::Vector2d::Zero(), drift = Eigen::Vector2d::Zero();
  double mass = 0.0;
  for (std::size_t i = 0; i < rods; ++i) {
    const auto& limb = bones_.limbs[i];
    if (i > 0) {
      const auto parent = static_cast<std::size_t>(limb.parent);
      const double rest = static_cast<double>(limb.rest_rad);
      direction[i] = direction[parent] + rest + angle[i - 1];
      turning[i] = turning[parent] + rate[i - 1];
    }
    const auto start = static_cast<std::size_t>(limb.start);
    const double length = static_cast<double>(limb.length_m);
    const Eigen::Vector2d along(std::cos(direction[i]), std::sin(direction[i]));
    end[i + 1] = end[start] + length * along;
    end_velocity[i + 1] = end_velocity[start] + length * turning[i] * Eigen::Vector2d(-along.y(), along.x());
    middle[i] = 0.5 * (end[start] + end[i + 1]);
    velocity[i] = 0.5 * (end_velocity[start] + end_velocity[i + 1]);
    const double m = static_cast<double>(limb.mass_kg);
    mass += m;
    centre += m * middle[i];
    drift += m * velocity[i];
  }
  centre /= mass;
  drift /= mass;
  Shape shape{0.0, 0.0};
  for (std::size_t i = 0; i < rods; ++i) {
    const double m = static_cast<double>(bones_.limbs[i].mass_kg);
    const double own = static_cast<double>(bones_.limbs[i].inertia_kgm2);
    const Eigen::Vector2d r = middle[i] - centre, u = velocity[i] - drift;
    shape.inertia += m * r.squaredNorm() + own;
    shape.momentum += m * (r.x() * u.y() - r.y() * u.x()) + own * turning[i];
  }
  return shape;
}

double FreeFlight::Turn(const Angles& target, double tau_s, double momentum, double seconds) const {
  const auto spin_at = [&](double t) {
    Angles angle(target.size()), rate(target.size());
    for (std::size_t j = 0; j < target.size(); ++j) {
      // From rest at 0: theta = target (1 - (1 + t / tau) exp(-t / tau)).
      const double decay = std::exp(-t / tau_s);
      angle[j] = target[j] * (1.0 - (1.0 + t / tau_s) * decay);
      rate[j] = target[j] * t / (tau_s * tau_s) * decay;
    }
    const Shape shape = ShapeAt(angle, rate);
    return (momentum - shape.momentum) / shape.inertia;
  };
  // The right-hand side depends only on time, so Runge-Kutta equals Simpson's rule.
  const int steps = static_cast<int>(std::lround(seconds / 1e-4));
  const double h = seconds / steps;
  double turn = 0.0;
  for (int i = 0; i < steps; ++i) {
    turn += h / 6.0 * (spin_at(i * h) + 4.0 * spin_at((i + 0.5) * h) + spin_at((i + 1) * h));
  }
  return turn;
}

}  // namespace gaitsmith::test
