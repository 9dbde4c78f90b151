// SPDX-License-Identifier: MIT
// Grounds that are chosen by name.
#include "core/world/ground_preset.h"

#include <algorithm>
#include <catch_amalgamated.hpp>
#include <cmath>

#include "core/world/terrain.h"
#include "tests/scene.h"

namespace gaitsmith {

namespace {

constexpr GroundPreset kEach[] = {GroundPreset::kLevel, GroundPreset::kStepUp, GroundPreset::kStairs,
                                  GroundPreset::kRamp,  GroundPreset::kGap,    GroundPreset::kHurdles,
                                  GroundPreset::kRubble};

}  // namespace

TEST_CASE("ground presets: all are valid, known again, and level where the figure starts", "[terrain]") {
  static_assert(std::size(kEach) == kGroundPresets);
  for (const GroundPreset preset : kEach) {
    CAPTURE(kGroundPresetNames[static_cast<std::size_t>(preset)]);
    const std::vector<Corner> ground = GroundOf(preset);
    REQUIRE(Validate(ground));
    CHECK(ground.empty() == (preset == GroundPreset::kLevel));
    CHECK(PresetOf(ground) == KnownGround{preset});
    for (const Corner& corner : ground) CHECK(std::abs(corner.x_m) >= kLevelStart);
    const Terrain terrain(ground);
    CHECK(terrain.HeightAt(0.0) == 0.0);
    for (const double x : {-1.99, 1.99}) CHECK(std::abs(terrain.HeightAt(x)) < 1e-12);
  }
}

TEST_CASE("ground presets: every shipped figure starts on their level part", "[terrain]") {
  for (const std::string& name : gaitsmith::test::ShippedFigureFiles()) {
    Document document;
    document.figure = gaitsmith::test::ShippedFigure(name);
    const Motion motion = Simulate(document);
    CAPTURE(name);
    for (int k = 0; k < motion.Bones().endpoints; ++k) CHECK(std::abs(motion.Endpoint(0, k).x) < kLevelStart);
  }
}

TEST_CASE("ground presets: the step is 0.3 m high, and stairs, ramp and hurdles end as low as they began",
          "[terrain]") {
  for (const double x : {3.0, -3.0})
    CHECK(Terrain(GroundOf(GroundPreset::kStepUp)).HeightAt(x) == Catch::Approx(0.3));
  for (const GroundPreset preset : {GroundPreset::kStairs, GroundPreset::kRamp, GroundPreset::kHurdles,
                                    GroundPreset::kGap, GroundPreset::kRubble}) {
    const Terrain terrain(GroundOf(preset));
    CHECK(terrain.HeightAt(100.0) == 0.0);
    CHECK(terrain.HeightAt(-100.0) == 0.0);
  }
  CHECK(Terrain(GroundOf(GroundPreset::kGap)).HeightAt(2.25) == Catch::Approx(-1.0));
}

TEST_CASE("ground presets: each seed has a rubble of its own, the same every time", "[terrain]") {
  for (std::uint32_t seed = 1; seed <= kMostRubble; ++seed) {
    const std::vector<Corner> ground = GroundOf(GroundPreset::kRubble, seed);
    CAPTURE(seed);
    REQUIRE(Validate(ground));
    for (const Corner& corner : ground) {
      CHECK(corner.y_m >= 0.0f);
      CHECK(corner.y_m <= 0.15f);
    }
    CHECK(ground.back().x_m == 22.0f);
    if (seed > 1) CHECK(ground != GroundOf(GroundPreset::kRubble, seed - 1));
  }
  CHECK(PresetOf(GroundOf(GroundPreset::kRubble, 7)) == KnownGround{GroundPreset::kRubble, 7});
  std::vector<Corner> changed = GroundOf(GroundPreset::kRubble, 7);
  changed.back().y_m = 1.0f;
  CHECK_FALSE(PresetOf(changed));
  // Pinned, so that a name means the same ground in every version.
  const std::vector<Corner> first = GroundOf(GroundPreset::kRubble, 1);
  float sum_m = 0.0f;
  for (const Corner& corner : first) sum_m += corner.y_m;
  CHECK(first.size() == 58);
  CHECK(sum_m == Catch::Approx(3.69f));
}

}  // namespace gaitsmith
