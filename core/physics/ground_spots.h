// SPDX-License-Identifier: MIT
// Where one figure may touch drawn ground in a step: endpoints on faces, and rods on edges. Found along the
// whole way that its limbs go, so that nothing passes through a thin hurdle between two steps.
#pragma once

#include <array>
#include <cstddef>

#include "core/physics/limb_contacts.h"
#include "core/physics/mechanism.h"
#include "core/world/terrain.h"

namespace gaitsmith {

/// A place of a figure that may touch, and the line that it must stay above.
struct GroundSpot {
  int feature = 0;                         // which face, or below 0: which edge and rod
  int limb = 0;                            // the rod
  float along = 1.0f;                      // from its inner end (0) to its outer end (1)
  float normal_x = 0.0f, normal_y = 1.0f;  // out of the ground
  float gap_m = 0.0f;                      // distance from the line when the step begins

  [[nodiscard]] bool AtEnd() const { return along == 0.0f || along == 1.0f; }
};

/// Endpoints of a figure in the frame of the ground [m].
struct LimbPlaces {
  std::array<double, kMaxEndpoints> x, y;
};

/// The spots of one figure in one step.
struct GroundSpots {
  std::size_t count = 0;
  std::array<GroundSpot, kMaxTouches> spots;

  /// The spot of a feature, a new one if there is none yet; null if there are too many.
  GroundSpot* Of(int feature);
};

class SpotFinder {
 public:
  /// @param body, terrain must outlive the finder
  SpotFinder(const Mechanism& body, const Terrain& terrain) : body_(body), terrain_(terrain) {}

  /// Adds what may touch on the way from one place to another, and places spots on edges anew.
  /// @return whether something ends deeper in the ground than `sink_m`
  bool Look(const LimbPlaces& from, const LimbPlaces& to, double sink_m, GroundSpots& spots) const;

  /// How far above its line a spot is at given places, < 0 in the ground [m].
  [[nodiscard]] double Above(const GroundSpot& spot, const LimbPlaces& at) const;
  /// Whether an endpoint is deeper in the ground than this [m].
  [[nodiscard]] bool IsBuried(const LimbPlaces& at, double most_m) const;
  /// By how much a figure must be lifted to lie on the ground, and not in it; < 0 if it floats [m].
  [[nodiscard]] double LiftOf(const LimbPlaces& at) const;

 private:
  bool LookAtFaces(std::size_t endpoint, const LimbPlaces& from, const LimbPlaces& to, double sink_m,
                   GroundSpots& spots) const;
  bool LookAtEdges(std::size_t limb, const LimbPlaces& from, const LimbPlaces& to, double sink_m,
                   GroundSpots& spots) const;

  const Mechanism& body_;
  const Terrain& terrain_;
};

}  // namespace gaitsmith
