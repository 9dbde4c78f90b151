// SPDX-License-Identifier: MIT
#include "core/springs/lattice.h"

#include <algorithm>

namespace gaitsmith {

namespace {

int SubstepsFor(const Figure& figure) {
  const float turned = FastestVibration(figure) * kStep * kStep;  // squared radians in a step
  int substeps = 1;
  while (turned > static_cast<float>(substeps * substeps)) substeps *= 2;
  return substeps;
}

}  // namespace

Lattice::Lattice(const Figure& figure)
    : nodes(figure.nodes.size()), links(figure.springs.size()), substeps(SubstepsFor(figure)) {
  float x = 0.0f, y = 0.0f;
  for (std::size_t i = 0; i < nodes; ++i) {
    const Node& node = figure.nodes[i];
    mass_kg[i] = node.mass_kg;
    inverse_kg[i] = 1.0f / node.mass_kg;
    total_kg += node.mass_kg;
    x += node.mass_kg * node.x_m;
    y += node.mass_kg * node.y_m;
    if (node.y_m > figure.nodes[head].y_m) head = i;
  }
  for (std::size_t i = 0; i < nodes; ++i) {
    drawn_x[i] = figure.nodes[i].x_m - x / total_kg;
    drawn_y[i] = figure.nodes[i].y_m - y / total_kg;
    drawn_kgm2 += mass_kg[i] * (drawn_x[i] * drawn_x[i] + drawn_y[i] * drawn_y[i]);
  }
  for (std::size_t i = 0; i < links; ++i) {
    const Spring& spring = figure.springs[i];
    Link& one = link[i];
    one.from = static_cast<std::size_t>(spring.from);
    one.to = static_cast<std::size_t>(spring.to);
    one.drawn_m = DrawnLength(figure, spring);
    one.rest = spring.rest;
    one.stiffness_npm = spring.stiffness_npm;
    one.damping_nspm = spring.damping_nspm;
    one.reduced_kg = 1.0f / (inverse_kg[one.from] + inverse_kg[one.to]);
    one.muscle = -1;
    longest_m = std::max(longest_m, one.drawn_m);
    if (!spring.IsMuscle()) continue;
    one.muscle = static_cast<int>(muscles);
    muscle[muscles++] = {i, spring.min_rest, spring.max_rest};
  }
}

Ports PortsOf(const Lattice& lattice) {
  Ports ports;
  ports.muscles = true;
  for (std::size_t j = 0; j < lattice.muscles; ++j)
    ports.actuator_range.push_back({lattice.muscle[j].least, lattice.muscle[j].greatest});
  ports.contacts = static_cast<int>(lattice.nodes);
  ports.mass_kg = lattice.total_kg;
  ports.length_m = lattice.longest_m;
  return ports;
}

}  // namespace gaitsmith
