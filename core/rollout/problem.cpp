// SPDX-License-Identifier: MIT
#include "core/rollout/problem.h"

#include "core/rollout/models.h"

namespace gaitsmith {

ControllerShape Problem::Shape() const {
  const ControllerShape controllers = ShapeFor(CountPorts(model, figure));
  return bodies ? controllers.WithBody(BodyShape(*bodies, figure).Genes()) : controllers;
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
