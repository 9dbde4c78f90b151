// SPDX-License-Identifier: MIT
// What makes a motion of a figure of springs void, and what becomes of its numbers then.
#pragma once

#include <cmath>

#include "core/springs/drawn_floor.h"
#include "core/springs/lattice_state.h"
#include "core/world/terrain.h"

namespace gaitsmith {

/// A motion is void when a spring is longer than this many times its drawn length.
inline constexpr float kMostStretch = 10.0f;
/// A motion is void when nodes are deeper in drawn ground than this [m].
inline constexpr double kMostBuried = 0.02;

/// Whether a node is deep in drawn ground.
template <int W>
bool IsBuried(const Lattice& body, const Terrain& terrain, const LatticeState<W>& s, int lane) {
  if (terrain.Level()) return false;
  for (std::size_t k = 0; k < body.nodes; ++k) {
    const double x = s.place_m[lane] + static_cast<double>(s.x[k][lane]);
    const double y = static_cast<double>(s.height_m[lane]) + static_cast<double>(s.y[k][lane]) + kMostBuried;
    if (y >= terrain.HeightAt(x)) continue;
    // Right at a vertical face a node may be a rounding error to the wrong side.
    if (y < terrain.HeightAt(x - kBehindFace) && y < terrain.HeightAt(x + kBehindFace)) return true;
  }
  return false;
}

/// About the centre of mass [kg m^2/s].
template <int W>
float AngularMomentum(const Lattice& body, const LatticeState<W>& s, int lane) {
  using L = Lane<W>;
  float sum = 0.0f;
  for (std::size_t k = 0; k < body.nodes; ++k) {
    const float x = L::At(s.x[k], lane), y = L::At(s.y[k], lane);
    const float speed_x = L::At(s.velocity_x[k], lane) - L::At(s.centre_velocity_x, lane);
    const float speed_y = L::At(s.velocity_y[k], lane) - L::At(s.centre_velocity_y, lane);
    sum += body.mass_kg[k] * (x * speed_y - y * speed_x);
  }
  return sum;
}

template <int W>
bool IsFinite(const Lattice& body, const LatticeState<W>& s, int lane) {
  using F = typename Lane<W>::F;
  // A sum is finite only if all of its numbers are.
  double sum = s.distance_m[lane] + s.turn_rad[lane] + static_cast<double>(AngularMomentum<W>(body, s, lane));
  const auto add = [&](const F& number) { sum += static_cast<double>(Lane<W>::At(number, lane)); };
  for (std::size_t k = 0; k < body.nodes; ++k) {
    for (const F* number :
         {&s.x[k], &s.y[k], &s.velocity_x[k], &s.velocity_y[k], &s.normal[k], &s.tangent[k]})
      add(*number);
  }
  for (const F* number :
       {&s.slip_m, &s.normal_work_j, &s.friction_work_j, &s.friction_gain_j, &s.lifting_work_j})
    add(*number);
  for (std::size_t j = 0; j < body.muscles; ++j) {
    for (const F* number : {&s.length[j], &s.length_rate[j], &s.work_j[j]}) add(*number);
  }
  return std::isfinite(sum);
}

/// Lets a figure that is not finite rest where it was.
template <int W>
void RestAt(const Lattice& body, const LatticeState<W>& before, int lane, LatticeState<W>& s) {
  using L = Lane<W>;
  using F = typename L::F;
  using State = LatticeState<W>;
  const auto back = [lane](F& now, const F& then) { L::Put(now, lane, L::At(then, lane)); };
  const auto zero = [lane](F& now) { L::Put(now, lane, 0.0f); };
  for (std::size_t k = 0; k < body.nodes; ++k) {
    back(s.x[k], before.x[k]);
    back(s.y[k], before.y[k]);
    for (F* number : {&s.velocity_x[k], &s.velocity_y[k], &s.normal[k], &s.tangent[k]}) zero(*number);
  }
  for (std::size_t j = 0; j < body.muscles; ++j) {
    back(s.length[j], before.length[j]);
    zero(s.length_rate[j]);
    zero(s.work_j[j]);
  }
  s.distance_m[lane] = before.distance_m[lane];
  s.place_m[lane] = before.place_m[lane];
  s.turn_rad[lane] = before.turn_rad[lane];
  for (auto part :
       {&State::cosine, &State::sine, &State::height_m, &State::greatest_height_m, &State::slip_m})
    back(s.*part, before.*part);
  for (auto part : {&State::centre_velocity_x, &State::centre_velocity_y, &State::normal_work_j,
                    &State::friction_work_j, &State::friction_gain_j, &State::lifting_work_j})
    zero(s.*part);
}

/// Judges a step. @param stretch the greatest of all springs in it @param sum of all nodes' places and
/// velocities, somehow weighted @param before the step
template <int W>
void JudgeLattice(const Lattice& body, const Terrain& terrain, const typename Lane<W>::F& stretch,
                  const typename Lane<W>::F& sum, const LatticeState<W>& before, LatticeState<W>& s) {
  // A number less itself is nought only if it is finite.
  s.broken |= ~(stretch <= kMostStretch) | ~(sum - sum == typename Lane<W>::F{});
  for (int lane = 0; lane < W; ++lane) {
    if (IsBuried<W>(body, terrain, s, lane)) s.broken[lane] = -1;
    if (s.broken[lane] != 0 && !IsFinite<W>(body, s, lane)) RestAt<W>(body, before, lane, s);
  }
}

}  // namespace gaitsmith
