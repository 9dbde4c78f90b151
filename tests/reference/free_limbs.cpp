// SPDX-License-Identifier: MIT
#include "tests/reference/free_limbs.h"

#include <Eigen/Dense>
#include <cmath>
#include <vector>

namespace gaitsmith::test {

FreeLimbs::Vector FreeLimbs::Place(const LimbState<1>& s) const {
  Vector place(bones_.rods);
  place[0] = s.turn_rad[0];
  for (int i = 1; i < bones_.rods; ++i)
    place[i] = static_cast<double>(s.angle_rad[static_cast<std::size_t>(i) - 1][0]);
  return place;
}

FreeLimbs::Vector FreeLimbs::Momenta(const LimbState<1>& s) const {
  Vector momenta(bones_.rods);
  momenta[0] = static_cast<double>(s.angular_momentum[0]);
  for (int i = 1; i < bones_.rods; ++i)
    momenta[i] = static_cast<double>(s.momentum[static_cast<std::size_t>(i)][0]);
  return momenta;
}

FreeLimbs::Matrix FreeLimbs::Mass(const Vector& place) const {
  const auto n = static_cast<Eigen::Index>(bones_.rods);
  std::vector<Eigen::Vector2d> end(static_cast<std::size_t>(n) + 1, Eigen::Vector2d::Zero());
  std::vector<Eigen::Vector2d> middle(static_cast<std::size_t>(n));
  std::vector<double> direction(static_cast<std::size_t>(n));
  for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
    const Skeleton::Limb& limb = bones_.limbs[i];
    direction[i] = place[static_cast<Eigen::Index>(i)];
    if (i > 0)
      direction[i] += direction[static_cast<std::size_t>(limb.parent)] + static_cast<double>(limb.rest_rad);
    const Eigen::Vector2d along =
        static_cast<double>(limb.length_m) * Eigen::Vector2d(std::cos(direction[i]), std::sin(direction[i]));
    const Eigen::Vector2d& start = end[static_cast<std::size_t>(limb.start)];
    middle[i] = start + 0.5 * along;
    end[i + 1] = start + along;
  }
  // How the middle of each rod moves with each coordinate: 2 rows for each rod. And whether it turns.
  Matrix moves = Matrix::Zero(2 * n, n), turns = Matrix::Zero(n, n);
  double mass = 0.0;
  Matrix mean = Matrix::Zero(2, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Skeleton::Limb& limb = bones_.limbs[static_cast<std::size_t>(i)];
    for (Eigen::Index j = i; j >= 0; j = bones_.limbs[static_cast<std::size_t>(j)].parent) {
      const auto pivot = static_cast<std::size_t>(bones_.limbs[static_cast<std::size_t>(j)].start);
      const Eigen::Vector2d arm = middle[static_cast<std::size_t>(i)] - end[pivot];
      moves.block<2, 1>(2 * i, j) = Eigen::Vector2d(-arm.y(), arm.x());
      turns(i, j) = 1.0;
    }
    mean += static_cast<double>(limb.mass_kg) * moves.middleRows(2 * i, 2);
    mass += static_cast<double>(limb.mass_kg);
  }
  Matrix sum = -mean.transpose() * mean / mass;
  for (Eigen::Index i = 0; i < n; ++i) {
    const Skeleton::Limb& limb = bones_.limbs[static_cast<std::size_t>(i)];
    const Matrix rows = moves.middleRows(2 * i, 2);
    const double m = static_cast<double>(limb.mass_kg), l = static_cast<double>(limb.length_m);
    sum += m * rows.transpose() * rows + m * l * l / 12.0 * turns.row(i).transpose() * turns.row(i);
  }
  return sum;
}

FreeLimbs::Vector FreeLimbs::Bias(const Vector& place, const Vector& speed) const {
  constexpr double kApart = 1e-5;
  Vector bias(place.size());
  for (Eigen::Index j = 0; j < place.size(); ++j) {
    Vector one = place, other = place;
    one[j] -= kApart;
    other[j] += kApart;
    bias[j] = (KineticEnergy(other, speed) - KineticEnergy(one, speed)) / (2.0 * kApart);
  }
  return bias;
}

double FreeLimbs::Energy(const LimbState<1>& s, double gravity_mps2) const {
  const Vector momenta = Momenta(s);
  const double mass = static_cast<double>(bones_.mass_kg);
  const double x = static_cast<double>(s.velocity_x[0]), y = static_cast<double>(s.velocity_y[0]);
  return 0.5 * momenta.dot(Mass(Place(s)).ldlt().solve(momenta)) +
         mass * (0.5 * (x * x + y * y) + gravity_mps2 * static_cast<double>(s.height_m[0]));
}

FreeLimbs::Moment FreeLimbs::ChangeAt(const Moment& now) const {
  const Vector speed = Mass(now.place).ldlt().solve(now.momenta);
  return {speed, Bias(now.place, speed)};
}

FreeLimbs::Moment FreeLimbs::Fly(Moment now, double seconds, int steps) const {
  const double h = seconds / steps;
  const auto after = [](const Moment& from, const Moment& change, double time) {
    return Moment{from.place + time * change.place, from.momenta + time * change.momenta};
  };
  for (int step = 0; step < steps; ++step) {
    const Moment a = ChangeAt(now);
    const Moment b = ChangeAt(after(now, a, 0.5 * h));
    const Moment c = ChangeAt(after(now, b, 0.5 * h));
    const Moment d = ChangeAt(after(now, c, h));
    now.place += h / 6.0 * (a.place + 2.0 * b.place + 2.0 * c.place + d.place);
    now.momenta += h / 6.0 * (a.momenta + 2.0 * b.momenta + 2.0 * c.momenta + d.momenta);
  }
  return now;
}

}  // namespace gaitsmith::test
