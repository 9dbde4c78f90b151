// SPDX-License-Identifier: MIT
// The physical models that documents can name, and their plants.
#pragma once

#include "core/physics/figure_plant.h"
#include "core/rollout/plant.h"

namespace gaitsmith {

/// Calls back with the plant of a model as a template argument. Motions and evaluators do this once, when
/// they are created, so that no step has to check the model.
/// @param model [1, kModelVersion]
/// @param call  a generic lambda, [&]<template <int> class PlantOf>() {…}
template <class Call>
auto WithPlantOf(int model, Call call) {
  static_assert(Plant<FigurePlant<1>>);
  switch (model) {
    case FigurePlant<1>::kModel:
    default:
      return call.template operator()<FigurePlant>();
  }
}

/// The connections of a figure in a model.
[[nodiscard]] PortCount CountPorts(int model, const Figure&);

}  // namespace gaitsmith
