// SPDX-License-Identifier: MIT
#include "core/kinematics/limb_pairs.h"

#include <catch_amalgamated.hpp>
#include <cmath>

#include "tests/scene.h"

namespace gaitsmith::test {

namespace {

int Paired(const LimbPairs& pairs) {
  int paired = 0;
  for (std::size_t rod = 0; rod < pairs.rod.size(); ++rod)
    paired += pairs.rod[rod] != static_cast<int>(rod) ? 1 : 0;
  return paired;
}

}  // namespace

TEST_CASE("limb pairs: a biped's legs, a horse's two pairs, no two of a star's arms", "[kinematics]") {
  const auto pairs_of = [](const char* name) { return LimbPairsOf(Skeleton(ShippedFigure(name))); };
  CHECK(Paired(pairs_of("beryl-biped")) >= 4);
  CHECK(Paired(pairs_of("horse")) >= 8);
  CHECK_FALSE(pairs_of("mr-star-man").any);
  CHECK_FALSE(pairs_of("hopper").any);
}

TEST_CASE("limb pairs: each is the other's partner, and limbs that differ have none", "[kinematics]") {
  for (const std::string& name : ShippedFigureFiles()) {
    INFO(name);
    const Skeleton bones(ShippedFigure(name));
    const LimbPairs pairs = LimbPairsOf(bones);
    for (std::size_t rod = 0; rod < static_cast<std::size_t>(bones.rods); ++rod) {
      const auto partner = static_cast<std::size_t>(pairs.rod[rod]);
      CHECK(pairs.rod[partner] == static_cast<int>(rod));
      CHECK(bones.limbs[rod].length_m == bones.limbs[partner].length_m);
      CHECK(bones.limbs[rod].mass_kg == bones.limbs[partner].mass_kg);
    }
  }
  Figure biped = ShippedFigure("beryl-biped");
  REQUIRE(LimbPairsOf(Skeleton(biped)).any);
  for (Rod& rod : biped.rods) {
    if (rod.parent != kNoParent) rod.length_m += 0.01f * static_cast<float>(&rod - biped.rods.data());
  }
  CHECK_FALSE(LimbPairsOf(Skeleton(biped)).any);
}

TEST_CASE("limb pairs: exchanged limbs are where their partners were, and twice is once more the same",
          "[kinematics]") {
  const Skeleton bones(ShippedFigure("horse"));
  const LimbPairs pairs = LimbPairsOf(bones);
  Posture posture{.x_m = 1.0, .y_m = 0.8, .direction_rad = 0.2, .angle_rad = {}};
  for (int j = 0; j < bones.joints; ++j) posture.angle_rad.push_back(0.1 * j);
  const Posture exchanged = Exchanged(bones, pairs, posture), back = Exchanged(bones, pairs, exchanged);
  const std::vector<WorldPoint> before = EndpointsOf(bones, posture), after = EndpointsOf(bones, exchanged);
  for (std::size_t k = 0; k < before.size(); ++k) {
    const auto partner = static_cast<std::size_t>(pairs.endpoint[k]);
    CHECK(std::abs(after[k].x_m - before[partner].x_m) < 1e-12);
    CHECK(std::abs(after[k].y_m - before[partner].y_m) < 1e-12);
  }
  for (std::size_t j = 0; j < posture.angle_rad.size(); ++j)
    CHECK(std::abs(back.angle_rad[j] - posture.angle_rad[j]) < 1e-12);
}

}  // namespace gaitsmith::test
