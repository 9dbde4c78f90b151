// SPDX-License-Identifier: MIT
#include "core/rollout/demonstration.h"

#include <algorithm>

#include "core/numeric/scalar_math.h"

namespace gaitsmith {

Demonstration::Demonstration() = default;
Demonstration::Demonstration(const Demonstration&) = default;
Demonstration::Demonstration(Demonstration&&) noexcept = default;
Demonstration& Demonstration::operator=(const Demonstration&) = default;
Demonstration& Demonstration::operator=(Demonstration&&) noexcept = default;
Demonstration::~Demonstration() = default;
bool Demonstration::operator==(const Demonstration&) const = default;

std::array<double, 2> Demonstration::WayAt(int step) const {
  const auto next = std::ranges::upper_bound(way, step, {}, &WayPoint::step);
  const WayPoint& to = next == way.end() ? way.back() : *next;
  const WayPoint& from = next == way.begin() ? to : *std::prev(next);
  const double share =
      from.step >= to.step ? 0.0 : static_cast<double>(step - from.step) / (to.step - from.step);
  const auto between = [&](float a, float b) {
    return static_cast<double>(a) + share * (static_cast<double>(b) - static_cast<double>(a));
  };
  return {between(from.x_m, to.x_m), between(from.y_m, to.y_m)};
}

double WithoutWholeTurns(double turn_rad) {
  const double whole = 2.0 * kPi;
  return turn_rad - whole * std::floor(turn_rad / whole + 0.5);
}

void DemonstrationMeter::AddGap(double x_m, double y_m) {
  const auto [way_x, way_y] = shown_->WayAt(step_);
  const double x = x_m - way_x, y = y_m - way_y;
  way_gaps_m_ += std::sqrt(x * x + y * y);  // a root is the same on every machine, std::hypot is not
  ++way_steps_;
}

}  // namespace gaitsmith
