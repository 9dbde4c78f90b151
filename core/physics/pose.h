// SPDX-License-Identifier: MIT
// Where every part of W figures is, given their joint angles, and how that shape changes. Positions are in
// the root frame, relative to the centre of mass.
#pragma once

#include <array>

#include "core/numeric/lane.h"
#include "core/numeric/scalar_math.h"
#include "core/physics/skeleton.h"

namespace gaitsmith {

/// Positions in the root frame, in which the root rod points along +x, relative to the centre of mass of the
/// whole figure.
template <int W>
struct Pose {
  using F = typename Lane<W>::F;
  std::array<F, kMaxEndpoints> endpoint_x;  // [m] (endpoints)
  std::array<F, kMaxEndpoints> endpoint_y;
  std::array<F, kMaxRods> middle_x;  // of each rod [m] (rods)
  std::array<F, kMaxRods> middle_y;
};

/// Forward kinematics, parents first.
/// @param angle_rad joint angles relative to rest, skeleton.joints of them
template <int W>
void PoseFigure(const Skeleton& skeleton, const std::array<typename Lane<W>::F, kMaxJoints>& angle_rad,
                Pose<W>& pose) {
  using F = typename Lane<W>::F;
  std::array<F, kMaxRods> along_x, along_y;  // unit vector along each rod
  along_x[0] = Lane<W>::Splat(1.0f);
  along_y[0] = F{};
  pose.endpoint_x[0] = F{};
  pose.endpoint_y[0] = F{};
  F weighted_x{}, weighted_y{};
  for (std::size_t rod = 0; rod < static_cast<std::size_t>(skeleton.rods); ++rod) {
    const Skeleton::Limb& limb = skeleton.limbs[rod];
    if (rod > 0) {
      F sine, cosine;
      SinCos<W>(angle_rad[rod - 1] + limb.rest_rad, sine, cosine);
      const auto parent = static_cast<std::size_t>(limb.parent);
      along_x[rod] = along_x[parent] * cosine - along_y[parent] * sine;
      along_y[rod] = along_y[parent] * cosine + along_x[parent] * sine;
    }
    const auto start = static_cast<std::size_t>(limb.start);
    pose.endpoint_x[rod + 1] = pose.endpoint_x[start] + limb.length_m * along_x[rod];
    pose.endpoint_y[rod + 1] = pose.endpoint_y[start] + limb.length_m * along_y[rod];
    pose.middle_x[rod] = 0.5f * (pose.endpoint_x[start] + pose.endpoint_x[rod + 1]);
    pose.middle_y[rod] = 0.5f * (pose.endpoint_y[start] + pose.endpoint_y[rod + 1]);
    weighted_x += limb.mass_kg * pose.middle_x[rod];
    weighted_y += limb.mass_kg * pose.middle_y[rod];
  }
  const float inverse_mass = 1.0f / skeleton.mass_kg;
  const F centre_x = weighted_x * inverse_mass;
  const F centre_y = weighted_y * inverse_mass;
  for (std::size_t k = 0; k < static_cast<std::size_t>(skeleton.endpoints); ++k) {
    pose.endpoint_x[k] -= centre_x;
    pose.endpoint_y[k] -= centre_y;
  }
  for (std::size_t rod = 0; rod < static_cast<std::size_t>(skeleton.rods); ++rod) {
    pose.middle_x[rod] -= centre_x;
    pose.middle_y[rod] -= centre_y;
  }
}

/// The inertia and momentum of the changing shape at mid-step.
template <int W>
struct Shape {
  using F = typename Lane<W>::F;
  F inertia;   // J, about the centre of mass [kg m^2]
  F momentum;  // H, angular momentum of the joints' motion with the root held still [kg m^2/s]
};

/// J and H from the poses before and after a step: r = (r0 + r1) / 2, u = (r1 - r0) / h.
/// @param joint_turn change of each joint angle in the step [rad]
template <int W>
Shape<W> MeasureShape(const Skeleton& skeleton, const Pose<W>& before, const Pose<W>& after,
                      const std::array<typename Lane<W>::F, kMaxJoints>& joint_turn, float inverse_step) {
  using F = typename Lane<W>::F;
  std::array<F, kMaxRods> turn;  // turn of each rod relative to the root in this step [rad]
  turn[0] = F{};
  F inertia{}, swept{};
  for (std::size_t rod = 0; rod < static_cast<std::size_t>(skeleton.rods); ++rod) {
    const Skeleton::Limb& limb = skeleton.limbs[rod];
    if (rod > 0) turn[rod] = turn[static_cast<std::size_t>(limb.parent)] + joint_turn[rod - 1];
    const F r_x = 0.5f * (before.middle_x[rod] + after.middle_x[rod]);
    const F r_y = 0.5f * (before.middle_y[rod] + after.middle_y[rod]);
    const F moved_x = after.middle_x[rod] - before.middle_x[rod];
    const F moved_y = after.middle_y[rod] - before.middle_y[rod];
    inertia += limb.mass_kg * (r_x * r_x + r_y * r_y) + limb.inertia_kgm2;
    swept += limb.mass_kg * (r_x * moved_y - r_y * moved_x) + limb.inertia_kgm2 * turn[rod];
  }
  return {inertia, swept * inverse_step};
}

}  // namespace gaitsmith
