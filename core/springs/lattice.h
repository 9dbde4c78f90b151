// SPDX-License-Identifier: MIT
// A figure of point masses and springs, laid out for the simulation (model 3).
#pragma once

#include <array>
#include <cstddef>

#include "core/physics/figure.h"
#include "core/signal/ports.h"

namespace gaitsmith {

/// Nodes and springs keep the order of the figure. Contact k is node k, actuator j the j-th muscle.
struct Lattice {
  struct Link {
    std::size_t from, to;               // nodes
    float drawn_m;                      // distance of the nodes in the drawn pose
    float rest;                         // length without force, over the drawn one; of a muscle at first
    float stiffness_npm, damping_nspm;  // [N/m], [N s/m]
    float reduced_kg;                   // m M / (m + M) of its nodes
    int muscle;                         // index; -1 if it is none
  };
  struct Muscle {
    std::size_t link;
    float least, greatest;  // rest
  };

  /// @param figure must be valid and have nodes (see Validate)
  explicit Lattice(const Figure& figure);

  std::size_t nodes = 0, links = 0, muscles = 0;
  std::array<float, kMaxPoints> mass_kg{}, inverse_kg{};
  std::array<float, kMaxPoints> drawn_x{}, drawn_y{};  // from the centre of mass [m]
  std::array<Link, kMaxSprings> link{};
  std::array<Muscle, kMaxMuscles> muscle{};
  float total_kg = 0.0f;
  float longest_m = 0.0f;   // spring, as drawn
  float drawn_kgm2 = 0.0f;  // moment of inertia of the drawn pose
  std::size_t head = 0;     // highest node of the drawn pose, the first one if several are equally high
  /// Of a step of 0.01 s: a power of two. In each, the fastest vibration goes through at most one radian of
  /// its cycle. Leapfrog is stable up to two [Hairer Lubich Wanner 2003].
  int substeps = 1;
};

/// Muscles are the actuators, nodes the contacts.
[[nodiscard]] Ports PortsOf(const Lattice&);

}  // namespace gaitsmith
