// SPDX-License-Identifier: MIT
#include "tests/limb_motion.h"

#include <cmath>

namespace gaitsmith::test {

double LimbMotion::Turned(int frame, int joint) const {
  return static_cast<double>(motion_.AngleRad(frame, joint)) -
         static_cast<double>(motion_.AngleRad(frame - 1, joint));
}

LimbMotion::Turning LimbMotion::InStep(int frame) const {
  const auto rods = static_cast<std::size_t>(body_.rods);
  const auto step_s = static_cast<double>(motion_.StepS());
  std::array<double, kMaxRods> direction{}, rate{};
  const double turned = motion_.At(frame).turn_rad - motion_.At(frame - 1).turn_rad;
  direction[0] = motion_.At(frame - 1).turn_rad + 0.5 * turned;
  rate[0] = turned / step_s;
  for (std::size_t a = 1; a < rods; ++a) {
    const auto joint = static_cast<int>(a) - 1;
    const auto parent = static_cast<std::size_t>(body_.limbs[a].parent);
    const double by = Turned(frame, joint);
    rate[a] = rate[parent] + by / step_s;
    direction[a] = direction[parent] + static_cast<double>(body_.limbs[a].rest_rad) +
                   static_cast<double>(motion_.AngleRad(frame - 1, joint)) + 0.5 * by;
  }
  Turning sum{};
  for (std::size_t j = 0; j < rods; ++j) {
    for (std::size_t k = 0; k < rods; ++k) {
      const double inertia =
          static_cast<double>(body_.coupling[j][k]) * std::cos(direction[j] - direction[k]);
      sum.energy_j += 0.5 * inertia * rate[j] * rate[k];
      sum.angular_momentum += inertia * rate[k];
      sum.of_all += std::abs(static_cast<double>(body_.coupling[j][k]) * rate[k]);
    }
  }
  return sum;
}

double LimbMotion::WholeInertia() const {
  double sum = 0.0;
  for (const auto& row : body_.coupling) {
    for (const float inertia : row) sum += std::abs(static_cast<double>(inertia));
  }
  return sum;
}

double LimbMotion::MostWork(int frame) const {
  double most = 0.0;
  for (int joint = 0; joint < body_.joints; ++joint) {
    const double way = 0.5 * std::abs(Turned(frame, joint) + Turned(frame - 1, joint));
    most += static_cast<double>(body_.torque_nm[static_cast<std::size_t>(joint) + 1]) * way;
  }
  return most;
}

}  // namespace gaitsmith::test
