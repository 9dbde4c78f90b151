// SPDX-License-Identifier: MIT
// Figures of springs for tests, and what they measure of them.
#pragma once

#include <cmath>
#include <vector>

#include "core/springs/spring_plant.h"

namespace gaitsmith {

/// Two masses on the x axis.
inline Figure Pair(float stiffness, float damping, float left_kg = 1.0f, float right_kg = 1.0f) {
  Figure figure;
  figure.name = "Pair";
  figure.nodes = {{0.0f, 0.0f, left_kg}, {1.0f, 0.0f, right_kg}};
  figure.springs = {{.from = 0, .to = 1, .stiffness_npm = stiffness, .damping_nspm = damping}};
  return figure;
}

/// A square with both diagonals; its upper and lower sides are muscles.
inline Figure Box(float stiffness = 2000.0f, float damping = 2.0f) {
  Figure figure;
  figure.name = "Box";
  figure.nodes = {{0.0f, 0.0f, 0.5f}, {0.4f, 0.0f, 0.6f}, {0.4f, 0.3f, 0.4f}, {0.0f, 0.3f, 0.5f}};
  for (const auto& [from, to] : {std::pair(0, 1), {1, 2}, {2, 3}, {3, 0}, {0, 2}, {1, 3}}) {
    figure.springs.push_back({.from = from, .to = to, .stiffness_npm = stiffness, .damping_nspm = damping});
  }
  for (const std::size_t muscle : {0U, 2U}) {
    figure.springs[muscle].min_rest = 0.7f;
    figure.springs[muscle].max_rest = 1.3f;
  }
  return figure;
}

/// A plate of six nodes on four legs, whose eight springs are muscles.
inline Figure Table(float stiffness = 2000.0f, float damping = 4.0f) {
  Figure figure;
  figure.name = "Table";
  figure.nodes = {{0.0f, 0.5f, 0.3f},  {0.5f, 0.5f, 0.3f},  {1.0f, 0.5f, 0.3f},  {0.0f, 0.75f, 0.3f},
                  {0.5f, 0.75f, 0.3f}, {1.0f, 0.75f, 0.3f}, {-0.1f, 0.0f, 0.1f}, {0.15f, 0.0f, 0.1f},
                  {0.85f, 0.0f, 0.1f}, {1.1f, 0.0f, 0.1f}};
  const auto add = [&](int from, int to) {
    figure.springs.push_back({.from = from, .to = to, .stiffness_npm = stiffness, .damping_nspm = damping});
  };
  for (const auto& [from, to] :
       {std::pair(0, 1), {1, 2}, {3, 4}, {4, 5}, {0, 3}, {1, 4}, {2, 5}, {0, 4}, {1, 3}, {1, 5}, {2, 4}})
    add(from, to);
  for (const auto& [from, to] : {std::pair(6, 0), {6, 1}, {7, 0}, {7, 1}, {8, 1}, {8, 2}, {9, 1}, {9, 2}}) {
    add(from, to);
    figure.springs.back().min_rest = 0.6f;
    figure.springs.back().max_rest = 1.3f;
  }
  return figure;
}

/// No gravity, and the ground far below.
inline Environment Space() { return {.gravity_mps2 = 0.0f}; }
inline StartState Afloat() { return {.drop_height_m = 50.0f}; }

/// All muscles at one rest.
template <int W = 1>
ActuatorTargets<W> AllAt(float rest, float tau_s = 0.1f, float step_s = kStep) {
  ActuatorTargets<W> targets{};
  for (std::size_t j = 0; j < kMaxActuators; ++j) {
    targets.target[j] = Lane<W>::Splat(rest);
    targets.decay[j] = Lane<W>::Splat(static_cast<float>(Exp(-static_cast<double>(step_s / tau_s))));
    targets.inverse_tau[j] = Lane<W>::Splat(1.0f / tau_s);
  }
  return targets;
}

struct SpringTotals {
  double momentum_x = 0.0, momentum_y = 0.0;
  double angular_momentum = 0.0;  // about the centre of mass
  double kinetic_j = 0.0, springs_j = 0.0;

  [[nodiscard]] double Energy() const { return kinetic_j + springs_j; }
};

/// Velocities are those of the positions' time: springs, without damping, and gravity give them the half
/// substep that the state's lack. @param lane of the state
template <int W>
SpringTotals TotalsOf(const Lattice& body, const LatticeState<W>& s, double gravity_mps2 = 0.0, int lane = 0,
                      double substep_s = 0.0) {
  if (substep_s == 0.0) substep_s = static_cast<double>(kStep) / body.substeps;
  std::vector<double> x(body.nodes), y(body.nodes), vx(body.nodes), vy(body.nodes);
  for (std::size_t k = 0; k < body.nodes; ++k) {
    x[k] = static_cast<double>(s.x[k][lane]);
    y[k] = static_cast<double>(s.y[k][lane]);
    vx[k] = static_cast<double>(s.velocity_x[k][lane]);
    vy[k] = static_cast<double>(s.velocity_y[k][lane]) - 0.5 * substep_s * gravity_mps2;
  }
  SpringTotals sum;
  for (std::size_t i = 0; i < body.links; ++i) {
    const Lattice::Link& link = body.link[i];
    const std::size_t a = link.from, b = link.to;
    const double dx = x[b] - x[a], dy = y[b] - y[a], length = std::sqrt(dx * dx + dy * dy);
    const float rest = link.muscle < 0 ? link.rest : s.rest[static_cast<std::size_t>(link.muscle)][lane];
    const double beyond = length - static_cast<double>(rest * link.drawn_m);
    sum.springs_j += 0.5 * static_cast<double>(link.stiffness_npm) * beyond * beyond;
    const double impulse = 0.5 * substep_s * static_cast<double>(link.stiffness_npm) * beyond;
    vx[a] += impulse * dx / length / static_cast<double>(body.mass_kg[a]);
    vy[a] += impulse * dy / length / static_cast<double>(body.mass_kg[a]);
    vx[b] -= impulse * dx / length / static_cast<double>(body.mass_kg[b]);
    vy[b] -= impulse * dy / length / static_cast<double>(body.mass_kg[b]);
  }
  for (std::size_t k = 0; k < body.nodes; ++k) {
    const auto m = static_cast<double>(body.mass_kg[k]);
    sum.momentum_x += m * vx[k];
    sum.momentum_y += m * vy[k];
    sum.angular_momentum += m * (x[k] * vy[k] - y[k] * vx[k]);
    sum.kinetic_j += 0.5 * m * (vx[k] * vx[k] + vy[k] * vy[k]);
  }
  return sum;
}

}  // namespace gaitsmith
