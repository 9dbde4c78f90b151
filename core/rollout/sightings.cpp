// SPDX-License-Identifier: MIT
#include "core/rollout/sightings.h"

#include "core/rollout/beginning.h"
#include "core/rollout/models.h"

namespace gaitsmith {

std::vector<Sighting> SightingsOf(const Problem& searched, std::span<const Gene> genes, int count) {
  if (searched.kind != ControllerKind::kRules) return {};
  const Problem problem = searched.WithBodyOf(genes);
  return WithPlantOf(problem.model, [&]<template <int> class PlantOf>() {
    const typename PlantOf<1>::Body body(problem.figure);
    const Ports ports = PlantOf<1>::PortsOf(body);
    const ControllerShape shape = problem.ShapeFor(ports.Count());
    const Controllers<1> controllers =
        DecodeControllers<1>(shape, problem.senses, std::span(&genes, 1), ports, kStep);
    Rollout<PlantOf, 1> rollout(body, problem.environment, problem.start, problem.pushes);
    if (!problem.beginnings.empty()) {
      const Beginning& beginning = problem.beginnings.front();
      rollout.BeginAt(
          MomentsDuring<PlantOf>(beginning, problem, body, std::span(&beginning.steps, 1)).front());
    }
    rollout.Follow(controllers);
    const int start = rollout.StepNow();
    const auto senses = static_cast<std::size_t>(shape.Bank().senses);
    const Edges edges = EdgesOf(problem.senses.kind);
    std::vector<Sighting> sightings(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
      rollout.RunTo(start + problem.task.duration_steps * (i + 1) / count, kNothing, kNothing);
      Sighting& sighting = sightings[static_cast<std::size_t>(i)];
      sighting.rule = rollout.Control().rule[0];
      for (std::size_t sense = 0; sense < senses; ++sense) {
        sighting.senses.push_back(Encode(rollout.Control().senses[sense][0], edges.low, edges.high));
      }
    }
    return sightings;
  });
}

}  // namespace gaitsmith
