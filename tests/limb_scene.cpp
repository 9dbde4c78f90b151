// SPDX-License-Identifier: MIT
#include "tests/limb_scene.h"

#include <catch_amalgamated.hpp>
#include <string>

#include "core/numeric/random.h"

namespace gaitsmith::test {

Figure RandomTree(std::uint64_t seed, int rods, float strength, float stiffness) {
  RandomStream random(seed, 78, static_cast<std::uint64_t>(rods));
  const auto between = [&](double low, double high) {
    return static_cast<float>(low + (high - low) * random.Uniform());
  };
  Figure figure;
  figure.name = "tree " + std::to_string(seed);
  for (int i = 0; i < rods; ++i) {
    Rod rod;
    rod.length_m = between(0.3, 1.2);
    rod.mass_kg = between(0.2, 2.0);
    rod.rest_rad = between(-3.0, 3.0);
    rod.min_rad = -1.5f;
    rod.max_rad = 1.5f;
    rod.strength = strength;
    rod.stiffness = stiffness;
    if (i > 0) {
      rod.parent = static_cast<int>(random.Below(static_cast<std::uint32_t>(i)));
      rod.parent_end = random.Chance(0.5) ? RodEnd::kStart : RodEnd::kEnd;
    }
    figure.rods.push_back(rod);
  }
  REQUIRE(Validate(figure));
  return figure;
}

}  // namespace gaitsmith::test
