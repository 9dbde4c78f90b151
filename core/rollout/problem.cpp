// SPDX-License-Identifier: MIT
#include "core/rollout/problem.h"

#include "core/rollout/models.h"

namespace gaitsmith {

ControllerShape Problem::Shape() const {
  const ControllerShape controllers = ShapeFor(CountPorts(model, figure));
  return bodies ? controllers.WithBody(BodyShape(*bodies, figure).Genes()) : controllers;
}

Problem Problem::In(const TrialWorld& world) const {
  Problem problem = *this;
  problem.worlds.clear();
  problem.environment.friction *= world.friction;
  problem.environment.slope_rad += world.slope_rad;
  problem.delay_steps += world.delay_steps;
  problem.substeps *= world.substeps;
  const auto weigh = [&](Figure& of) {
    for (std::size_t i = 0; i < world.masses.size(); ++i)
      (of.HasSprings() ? of.nodes[i].mass_kg : of.rods[i].mass_kg) *= world.masses[i];
  };
  weigh(problem.figure);
  if (problem.bodies) weigh(problem.bodies->drawn);
  return problem;
}

Problem Problem::WithBodyOf(std::span<const Gene> genome) const {
  Problem problem = *this;
  if (!bodies) return problem;
  const BodyShape shape(*bodies, figure);
  problem.figure = shape.FigureOf(genome.last(shape.Genes()));
  problem.bodies.reset();
  return problem;
}

}  // namespace gaitsmith
