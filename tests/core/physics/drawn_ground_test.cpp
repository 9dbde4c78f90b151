// SPDX-License-Identifier: MIT
// Laws of drawn ground: nothing gets into it or through it, and straight ground is level ground.
#include <algorithm>
#include <array>
#include <catch_amalgamated.hpp>
#include <cmath>
#include <vector>

#include "core/numeric/random.h"
#include "core/physics/strength_plant.h"
#include "core/world/environment.h"
#include "tests/ground_depth.h"
#include "tests/limb_scene.h"
#include "tests/reference/free_limbs.h"

namespace gaitsmith::test {

namespace {

/// Random corners: slopes, steps, pits, and hurdles of two centimetres.
std::vector<Corner> RoughGround(RandomStream& random) {
  std::vector<Corner> ground;
  float x = -8.0f, y = 0.0f;
  while (x < 8.0f && ground.size() + 4 < kMaxCorners) {
    const double kind = random.Uniform();
    ground.push_back({x, y});
    if (kind < 0.2) {
      y = static_cast<float>(0.4 * random.Uniform() - 0.2);
      if (std::abs(y - ground.back().y_m) > 0.02f) ground.push_back({x, y});
    } else if (kind < 0.4) {
      const float top = y + static_cast<float>(0.05 + 0.4 * random.Uniform());
      ground.insert(ground.end(), {{x, top}, {x + 0.02f, top}, {x + 0.02f, y}});
      x += 0.02f;
    } else {
      y += static_cast<float>(0.3 * random.Uniform() - 0.15);
    }
    x += static_cast<float>(0.05 + 0.8 * random.Uniform());
  }
  ground.push_back({x, y});
  return ground;
}

double DeepestOf(const Mechanism& body, const Terrain& terrain, const LimbState<1>& s) {
  const LimbPlaces at = PlacesOf(s, static_cast<std::size_t>(body.endpoints), 0);
  double deepest = 0.0;
  for (std::size_t limb = 0; limb < static_cast<std::size_t>(body.rods); ++limb) {
    const auto a = static_cast<std::size_t>(body.limbs[limb].start);
    deepest = std::max(deepest, DepthOfRod(terrain, at.x[a], at.y[a], at.x[limb + 1], at.y[limb + 1]));
  }
  return deepest;
}

ActuatorTargets<1> Hold(const Mechanism& body) {
  return Towards<1>(std::vector<float>(static_cast<std::size_t>(body.joints), 0.0f), 0.1f);
}

}  // namespace

TEST_CASE("drawn ground: no rod gets into it, wherever figures fall", "[physics][ground][strength]") {
  const float strength = GENERATE(0.0f, 2.0f, 1000.0f);
  double deepest = 0.0, gained = 0.0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    RandomStream random(seed, 91, 0);
    const std::vector<Corner> ground = RoughGround(random);
    REQUIRE(Validate(std::span(ground)));
    const Terrain terrain{std::span(ground)};
    const Mechanism body(RandomTree(seed, 1 + static_cast<int>(seed % 8), strength));
    StrengthPlant<1> plant(body, {.friction = 0.7f, .ground = ground},
                           {.drop_height_m = 0.4f,
                            .velocity_x_mps = static_cast<float>(6.0 * random.Uniform() - 3.0),
                            .spin_radps = static_cast<float>(6.0 * random.Uniform() - 3.0)},
                           kStep);
    const FreeLimbs judge(body);
    const double unit = static_cast<double>(body.mass_kg * kStandardGravity * body.longest_rod_m);
    double energy = judge.Energy(plant.Save(), static_cast<double>(kStandardGravity));
    for (int step = 0; step < 300; ++step) {
      CAPTURE(strength, seed, step);
      plant.Step(step, Hold(body));
      REQUIRE_FALSE(plant.TermsOf(0).broke_physics);
      const double depth = DeepestOf(body, terrain, plant.Save());
      deepest = std::max(deepest, depth);
      REQUIRE(depth < 1e-4);
      const double now = judge.Energy(plant.Save(), static_cast<double>(kStandardGravity));
      if (strength == 0.0f) gained = std::max(gained, (now - energy) / unit);
      energy = now;
    }
  }
  CAPTURE(strength, deepest, gained);
  // Measured: 1.7e-6 m, and 1.6e-4 of M g L in a step.
  REQUIRE(gained < 1e-3);
}

TEST_CASE("drawn ground: nothing flies through a thin hurdle", "[physics][ground][strength]") {
  const float speed = GENERATE(5.0f, 20.0f, 60.0f);
  const int rods = GENERATE(1, 3);
  const std::vector<Corner> hurdle = {{3.0f, 0.0f}, {3.0f, 9.0f}, {3.01f, 9.0f}, {3.01f, 0.0f}};
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    CAPTURE(speed, rods, seed);
    const Mechanism body(RandomTree(seed, rods, 2.0f));
    StrengthPlant<1> plant(body, {.ground = hurdle}, {.drop_height_m = 1.0f, .velocity_x_mps = speed}, kStep);
    for (int step = 0; step < 200; ++step) {
      plant.Step(step, Hold(body));
      const LimbPlaces at = PlacesOf(plant.Save(), static_cast<std::size_t>(body.endpoints), 0);
      for (std::size_t k = 0; k < static_cast<std::size_t>(body.endpoints); ++k) REQUIRE(at.x[k] < 3.001);
      if (plant.TermsOf(0).broke_physics) break;
    }
  }
}

TEST_CASE("drawn ground: a hurdle's edge stops a falling rod", "[physics][ground][strength]") {
  // It falls flat across a post that is thinner than a step of it.
  const std::vector<Corner> post = {{-0.1f, 0.0f}, {-0.1f, 1.0f}, {-0.09f, 1.0f}, {-0.09f, 0.0f}};
  const float drop = GENERATE(0.2f, 5.0f, 50.0f);
  Figure stick;
  stick.rods = {{.length_m = 2.0f, .rest_rad = 0.0f}};
  const Mechanism body(stick);
  StrengthPlant<1> plant(body, {.ground = post}, {.drop_height_m = drop}, kStep);
  REQUIRE(plant.Save().height_m[0] == Catch::Approx(1.0f + drop));
  const Terrain terrain{std::span(post)};
  bool touched = false;
  for (int step = 0; step < 600; ++step) {
    plant.Step(step, Hold(body));
    CAPTURE(drop, step);
    REQUIRE(DeepestOf(body, terrain, plant.Save()) < 2e-3);
    touched |= std::abs(plant.Save().speed[0][0]) > 0.1f;
  }
  REQUIRE(touched);  // 10 cm beside its middle, so it tips over
  REQUIRE_FALSE(plant.TermsOf(0).broke_physics);
}

TEST_CASE("drawn ground: corners in a line change nothing", "[physics][ground][strength]") {
  const std::vector<Corner> straight = {
      {-1.0f, 0.0f}, {-0.3f, 0.0f}, {0.2f, 0.0f}, {0.9f, 0.0f}, {4.0f, 0.0f}};
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Mechanism body(RandomTree(seed, 4, 20.0f));
    const StartState start = {.drop_height_m = 0.1f, .velocity_x_mps = 0.5f};
    StrengthPlant<1> level(body, Environment{}, start, kStep),
        drawn(body, {.ground = straight}, start, kStep);
    for (int step = 0; step < 60; ++step) {
      CAPTURE(seed, step);
      level.Step(step, Hold(body));
      drawn.Step(step, Hold(body));
      REQUIRE(std::abs(level.Save().distance_m[0] - drawn.Save().distance_m[0]) < 2e-4);
      REQUIRE(std::abs(level.Save().height_m[0] - drawn.Save().height_m[0]) < 2e-4f);
    }
  }
}

TEST_CASE("drawn ground: on a ramp a box slides as on tilted ground", "[physics][ground][strength]") {
  // a = g (sin - mu cos), however the slope is given.
  const double tilt = 0.5, friction = 0.2;
  Figure box;
  box.rods = {{.length_m = 1.2f, .rest_rad = static_cast<float>(-tilt)}};
  const std::vector<Corner> ramp = {{-20.0f, static_cast<float>(20.0 * std::tan(tilt))},
                                    {30.0f, static_cast<float>(-30.0 * std::tan(tilt))}};
  const Mechanism body(box);
  StrengthPlant<1> plant(body, {.friction = static_cast<float>(friction), .ground = ramp}, {}, kStep);
  for (int step = 0; step < 200; ++step) plant.Step(step, Hold(body));
  const double exact =
      static_cast<double>(kStandardGravity) * (std::sin(tilt) - friction * std::cos(tilt)) * 2.0;
  const LimbState<1>& s = plant.Save();
  REQUIRE(std::hypot(s.velocity_x[0], s.velocity_y[0]) == Catch::Approx(exact).epsilon(2e-3));
  REQUIRE(std::abs(s.turn_rad[0] + tilt) < 1e-3);
}

TEST_CASE("drawn ground: a figure starts above whatever is below it", "[physics][ground][strength]") {
  const std::vector<Corner> peak = {{-1.0f, 0.0f}, {0.0f, 2.0f}, {1.0f, 0.0f}};
  Figure stick;
  stick.rods = {{.length_m = 3.0f, .rest_rad = 0.0f}};
  const Mechanism body(stick);
  const StrengthPlant<1> plant(body, {.ground = peak}, {.drop_height_m = 0.25f}, kStep);
  REQUIRE(plant.Save().height_m[0] == Catch::Approx(2.25f));
  REQUIRE(plant.Read().height[0][0] == Catch::Approx(0.25f));
}

}  // namespace gaitsmith::test
