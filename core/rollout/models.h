// SPDX-License-Identifier: MIT
// The physical models that documents can name, and their plants.
#pragma once

#include "core/physics/figure_plant.h"
#include "core/physics/strength_plant.h"
#include "core/rollout/plant.h"
#include "core/springs/spring_plant.h"

namespace gaitsmith {

template <template <int> class... PlantsOf>
struct PlantList {
  static constexpr int kSize = sizeof...(PlantsOf);
};

/// The plants of all models, in the order of their numbers, which begin at 1.
#ifdef GAITSMITH_FIRST_MODEL
using Plants = PlantList<FigurePlant>;  // of the small engine, which simulates shipped motions only
#else
using Plants = PlantList<FigurePlant, StrengthPlant, SpringPlant>;
#endif

/// The latest physical model. Documents record theirs: a later model gets a new number, and the others stay.
inline constexpr int kModelVersion = Plants::kSize;

/// The model of figures of springs, and of no others.
inline constexpr int kSpringModel = SpringPlant<1>::kModel;

template <class Call, template <int> class First, template <int> class... Rest>
auto WithPlantOf(int model, Call& call, PlantList<First, Rest...> /*plants*/) {
  static_assert(Plant<First<1>>);
  static_assert(First<1>::kModel + int{sizeof...(Rest)} == kModelVersion, "a plant is not in its place");
  if constexpr (sizeof...(Rest) > 0) {
    if (model != First<1>::kModel) return WithPlantOf(model, call, PlantList<Rest...>());
  }
  return call.template operator()<First>();
}

/// Calls back with the plant of a model as a template argument. Motions and evaluators do this once, when
/// they are created, so that no step has to check the model.
/// @param model [1, kModelVersion]
/// @param call  a generic lambda, [&]<template <int> class PlantOf>() {…}
template <class Call>
auto WithPlantOf(int model, Call call) {
  return WithPlantOf(model, call, Plants());
}

/// A figure's connections, in the skeleton's order, or the figure's.
[[nodiscard]] Ports PortsOf(const Figure&);

/// The connections of a figure in a model.
[[nodiscard]] PortCount CountPorts(int model, const Figure&);

}  // namespace gaitsmith
