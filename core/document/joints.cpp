// SPDX-License-Identifier: MIT
#include "core/document/joints.h"

#include <algorithm>

#include "core/physics/figure_plant.h"
#include "core/physics/strength_plant.h"

namespace gaitsmith {

bool HasLimitedJoints(const Document& document) { return document.model == StrengthPlant<1>::kModel; }

float JointStrength(const Document& document) {
  float most = 0.0f;
  for (const Rod& rod : document.figure.rods) {
    if (rod.parent != kNoParent) most = std::max(most, rod.strength);
  }
  return most;
}

float MassRatio(const Figure& figure) {
  const auto [least, most] = std::ranges::minmax(figure.rods, {}, &Rod::mass_kg);
  return most.mass_kg / least.mass_kg;
}

bool HasUnequalRods(const Document& document) {
  return HasLimitedJoints(document) && MassRatio(document.figure) > kMostMassRatio;
}

void FreeJoints(Document& document) { document.model = FigurePlant<1>::kModel; }

void LimitJoints(Document& document) { document.model = StrengthPlant<1>::kModel; }

void SetJointStrength(float strength, Document& document) {
  for (Rod& rod : document.figure.rods) {
    if (rod.parent != kNoParent) rod.strength = strength;
  }
}

}  // namespace gaitsmith
