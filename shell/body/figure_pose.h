// SPDX-License-Identifier: MIT
// Where a figure's endpoints are for given joint angles.
#pragma once

#include <span>
#include <vector>

#include "core/physics/skeleton.h"

namespace gaitsmith::shell {

/// A point of a figure [m], y upwards.
struct BodyPoint {
  float x = 0.0f, y = 0.0f;
};

/// A rod or a spring, between two endpoints or nodes.
struct Bar {
  int from, to;
};
[[nodiscard]] std::vector<Bar> BarsOf(const Skeleton&);
[[nodiscard]] std::vector<Bar> BarsOf(const Figure&);
/// What each actuator moves: the limb beyond a joint, or a muscle.
[[nodiscard]] std::vector<Bar> ActuatorBarsOf(const Figure&);

/// The figure's endpoints relative to its centre of mass, as it was drawn, for these joint angles: one per
/// joint, or none for the rest pose.
[[nodiscard]] std::vector<BodyPoint> DrawnEndpoints(const Skeleton&, std::span<const float> angle_rad);

/// Its endpoints or nodes in the drawn pose, relative to its centre of mass.
[[nodiscard]] std::vector<BodyPoint> DrawnEndpoints(const Figure&);

}  // namespace gaitsmith::shell
