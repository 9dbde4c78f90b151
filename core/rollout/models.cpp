// SPDX-License-Identifier: MIT
#include "core/rollout/models.h"

namespace gaitsmith {

Ports PortsOf(const Figure& figure) {
  return figure.HasSprings() ? PortsOf(Lattice(figure)) : PortsOf(Skeleton(figure));
}

PortCount CountPorts(int model, const Figure& figure) {
  return WithPlantOf(model, [&]<template <int> class PlantOf>() { return PlantOf<1>::CountPorts(figure); });
}

}  // namespace gaitsmith
