// SPDX-License-Identifier: MIT
// The state of W figures of springs side by side (model 3): what carries over from step to step, and what is
// measured over the motion. Plain data.
#pragma once

#include <array>

#include "core/numeric/lane.h"
#include "core/physics/constants.h"

namespace gaitsmith {

template <int W>
struct LatticeState {
  using L = Lane<W>;
  using F = typename L::F;
  using I = typename L::I;
  using D = typename L::D;
  using Points = std::array<F, kMaxPoints>;
  using Muscles = std::array<F, kMaxMuscles>;

  // Carried over.
  D distance_m{};  // of the centre of mass along the ground
  D place_m{};     // the same, wherever measuring began
  F height_m{};    // of the centre of mass above the ground line
  // Of the nodes, from the centre of mass: high above the ground numbers would be too coarse for stiff
  // springs [m].
  Points x{}, y{};
  // Half a substep before the positions (leapfrog) [m/s].
  Points velocity_x{}, velocity_y{};
  Muscles rest{}, rest_rate{};  // lengths without force, over the drawn ones; [1/s]
  D turn_rad{};                 // of the best-fitting rotation, whole turns included
  Points normal{}, tangent{};   // impulses of the ground in the last step [N s]

  // Of the last step.
  Muscles length{}, length_rate{};  // present lengths over the drawn ones; [1/s]
  Muscles rest_change{};
  Muscles pulled_m{};  // length beyond its rest, the sum over the substeps
  Muscles work_j{};    // of each muscle on its spring
  F cosine{}, sine{};  // of turn_rad
  F centre_velocity_x{}, centre_velocity_y{};
  F normal_work_j{}, friction_work_j{}, friction_gain_j{}, lifting_work_j{};

  // Measured over the motion.
  F start_height_m{}, greatest_height_m{}, slip_m{};
  I broken{};  // lanes whose motion is void
};

/// Copies one figure's state into every lane. Measuring starts from there. A void motion stays void.
template <int W>
void SpreadState(const LatticeState<1>& one, LatticeState<W>& all) {
  using L = Lane<W>;
  const auto spread = [](const auto& from, auto& to) {
    for (std::size_t i = 0; i < from.size(); ++i) to[i] = L::Splat(from[i][0]);
  };
  all = {};
  all.place_m = one.place_m[0] - typename L::D{};
  all.turn_rad = one.turn_rad[0] - typename L::D{};
  spread(one.x, all.x);
  spread(one.y, all.y);
  spread(one.velocity_x, all.velocity_x);
  spread(one.velocity_y, all.velocity_y);
  spread(one.rest, all.rest);
  spread(one.rest_rate, all.rest_rate);
  spread(one.normal, all.normal);
  spread(one.tangent, all.tangent);
  spread(one.length, all.length);
  spread(one.length_rate, all.length_rate);
  all.cosine = L::Splat(one.cosine[0]);
  all.sine = L::Splat(one.sine[0]);
  all.centre_velocity_x = L::Splat(one.centre_velocity_x[0]);
  all.centre_velocity_y = L::Splat(one.centre_velocity_y[0]);
  all.height_m = all.start_height_m = all.greatest_height_m = L::Splat(one.height_m[0]);
  if (one.broken[0] != 0) all.broken = ~typename L::I{};
}

}  // namespace gaitsmith
