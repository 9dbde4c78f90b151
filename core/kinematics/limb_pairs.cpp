// SPDX-License-Identifier: MIT
#include "core/kinematics/limb_pairs.h"

#include <numeric>

namespace gaitsmith {

namespace {

/// Pairs the rods of two limbs, from these rods outwards. @return false if they differ
bool PairOff(const Skeleton& bones, int one, int other, LimbPairs& pairs) {
  const Skeleton::Limb &a = bones.limbs[static_cast<std::size_t>(one)],
                       &b = bones.limbs[static_cast<std::size_t>(other)];
  const bool both_at_the_end = (a.start == a.parent + 1) == (b.start == b.parent + 1);
  if (a.length_m != b.length_m || a.mass_kg != b.mass_kg || !both_at_the_end) return false;
  pairs.rod[static_cast<std::size_t>(one)] = other;
  pairs.rod[static_cast<std::size_t>(other)] = one;
  // The rods that hang on each, in walking order.
  int next_one = one, next_other = other;
  const auto next_child = [&bones](int of, int after) {
    for (int rod = after + 1; rod < bones.rods; ++rod) {
      if (bones.limbs[static_cast<std::size_t>(rod)].parent == of) return rod;
    }
    return bones.rods;
  };
  while (true) {
    next_one = next_child(one, next_one);
    next_other = next_child(other, next_other);
    if (next_one == bones.rods || next_other == bones.rods) return next_one == next_other;
    if (!PairOff(bones, next_one, next_other, pairs)) return false;
  }
}

}  // namespace

LimbPairs::LimbPairs() {
  std::iota(rod.begin(), rod.end(), 0);
  std::iota(endpoint.begin(), endpoint.end(), 0);
}

LimbPairs LimbPairsOf(const Skeleton& bones) {
  LimbPairs pairs;
  for (int one = 1; one < bones.rods; ++one) {
    if (pairs.rod[static_cast<std::size_t>(one)] != one) continue;
    int partners = 0;
    LimbPairs paired;
    for (int other = 1; other < bones.rods; ++other) {
      LimbPairs trial = pairs;
      const Skeleton::Limb &a = bones.limbs[static_cast<std::size_t>(one)],
                           &b = bones.limbs[static_cast<std::size_t>(other)];
      if (other == one || a.start != b.start || a.parent != b.parent) continue;
      if (!PairOff(bones, one, other, trial)) continue;
      ++partners;
      paired = trial;
    }
    // A star's arms are also like its root.
    const Skeleton::Limb &limb = bones.limbs[static_cast<std::size_t>(one)], &root = bones.limbs[0];
    const bool star = limb.start == 0 && limb.length_m == root.length_m && limb.mass_kg == root.mass_kg;
    if (partners == 1 && !star) pairs = paired;
  }
  for (int rod = 0; rod < bones.rods; ++rod) {
    pairs.endpoint[static_cast<std::size_t>(rod) + 1] = pairs.rod[static_cast<std::size_t>(rod)] + 1;
    pairs.any = pairs.any || pairs.rod[static_cast<std::size_t>(rod)] != rod;
  }
  return pairs;
}

Posture Exchanged(const Skeleton& bones, const LimbPairs& pairs, const Posture& posture) {
  Posture exchanged = posture;
  for (std::size_t rod = 1; rod < static_cast<std::size_t>(bones.rods); ++rod) {
    const auto partner = static_cast<std::size_t>(pairs.rod[rod]);
    // The limbs may be drawn in different directions.
    exchanged.angle_rad[rod - 1] = posture.angle_rad[partner - 1] +
                                   static_cast<double>(bones.limbs[partner].rest_rad) -
                                   static_cast<double>(bones.limbs[rod].rest_rad);
  }
  return exchanged;
}

}  // namespace gaitsmith
