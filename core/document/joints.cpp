// SPDX-License-Identifier: MIT
#include "core/document/joints.h"

#include <algorithm>
#include <vector>

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
  if (figure.rods.empty()) return 1.0f;
  const auto [least, most] = std::ranges::minmax(figure.rods, {}, &Rod::mass_kg);
  return most.mass_kg / least.mass_kg;
}

bool HasUnequalRods(const Document& document) {
  return HasLimitedJoints(document) && MassRatio(document.figure) > kMostMassRatio;
}

void FreeJoints(Document& document) {
  if (!document.figure.HasSprings()) document.model = FigurePlant<1>::kModel;
}

void LimitJoints(Document& document) {
  if (!document.figure.HasSprings()) document.model = StrengthPlant<1>::kModel;
}

void SetJointStrength(float strength, Document& document) {
  for (std::vector<Rod>* rods : {&document.figure.rods, &document.drawn}) {
    for (Rod& rod : *rods) {
      if (rod.parent != kNoParent) rod.strength = strength;
    }
  }
}

bool SameJoints(const Document& a, const Document& b) {
  if (a.model != b.model) return false;
  const auto alike = [](const Rod& one, const Rod& other) {
    // The root has no joint.
    return one.parent == kNoParent || (one.strength == other.strength && one.stiffness == other.stiffness);
  };
  return !HasLimitedJoints(a) || std::ranges::equal(a.figure.rods, b.figure.rods, alike);
}

bool SameRods(const Document& a, const Document& b) {
  const auto alike = [](Rod one, const Rod& other) {
    one.strength = other.strength;
    one.stiffness = other.stiffness;
    return one == other;
  };
  return std::ranges::equal(a.figure.rods, b.figure.rods, alike) && a.figure.nodes == b.figure.nodes &&
         a.figure.springs == b.figure.springs;
}

}  // namespace gaitsmith
