// SPDX-License-Identifier: MIT
// Laws of contact with the ground of model 2.
#include <algorithm>
#include <array>
#include <catch_amalgamated.hpp>
#include <cmath>
#include <vector>

#include "core/numeric/random.h"
#include "core/physics/strength_plant.h"
#include "core/world/environment.h"
#include "tests/limb_scene.h"
#include "tests/reference/free_limbs.h"
#include "tests/scene.h"

namespace gaitsmith::test {

namespace {

constexpr int kFallSteps = 600;

/// A tree of 1 to 10 rods that holds its pose and falls from 0.5 m.
struct Fall {
  Fall(std::uint64_t seed, float strength)
      : random(seed, 83, 0),
        body(RandomTree(seed, 1 + static_cast<int>(seed % 10), strength)),
        environment{.friction = Between(0.3, 1.5)},
        plant(body, environment,
              {.drop_height_m = 0.5f, .velocity_x_mps = Between(-2.0, 2.0), .spin_radps = Between(-3.0, 3.0)},
              kStep),
        hold(Towards<1>(std::vector<float>(static_cast<std::size_t>(body.joints), 0.0f), 0.1f)),
        unit(static_cast<double>(body.mass_kg * kStandardGravity * body.longest_rod_m)) {}

  float Between(double low, double high) { return static_cast<float>(low + (high - low) * random.Uniform()); }
  [[nodiscard]] const LimbState<1>& Now() const { return plant.Save(); }

  RandomStream random;
  Mechanism body;
  Environment environment;
  StrengthPlant<1> plant;
  ActuatorTargets<1> hold;
  double unit;  // M g L [J]
};

}  // namespace

TEST_CASE("strength: the ground pushes and rubs as Coulomb says, and lets nothing sink",
          "[physics][strength]") {
  const float strength = GENERATE(0.0f, 0.2f, 2.0f, 1000.0f);
  int moving = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Fall fall(seed, strength);
    for (int step = 0; step < kFallSteps; ++step) {
      CAPTURE(strength, seed, step);
      fall.plant.Step(step, fall.hold);
      const LimbState<1>& s = fall.Now();
      REQUIRE(!fall.plant.TermsOf(0).broke_physics);
      for (std::size_t k = 0; k < static_cast<std::size_t>(fall.body.endpoints); ++k) {
        REQUIRE(s.last_force.normal[k][0] >= 0.0f);
        REQUIRE(std::abs(s.last_force.tangent[k][0]) <=
                fall.environment.friction * s.last_force.normal[k][0] * 1.000001f);
        REQUIRE(s.height_m[0] + s.endpoint_y[k][0] > -1e-6f);
      }
      // Measured: 2.0e-5 m, and 3.2e-4 and 2.2e-4 of M g L.
      REQUIRE(static_cast<double>(s.lifting_work_j[0] / fall.body.mass_kg) /
                  static_cast<double>(kStandardGravity) <
              1e-4);
      REQUIRE(static_cast<double>(s.normal_work_j[0]) < 1e-3 * fall.unit);
      REQUIRE(static_cast<double>(s.friction_gain_j[0]) < 1e-3 * fall.unit);
    }
    moving += std::hypot(fall.Now().velocity_x[0], fall.Now().velocity_y[0]) > 1e-3f ? 1 : 0;
  }
  // Measured after 6 s: 7 of the limp figures, 1 of the weakest and none of the others.
  CAPTURE(strength, moving);
  REQUIRE(moving <= (strength > 0.0f ? 3 : 15));
}

TEST_CASE("strength: limp figures only lose energy to the ground", "[physics][strength]") {
  double worst = 0.0, gained = 0.0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Fall fall(seed, 0.0f);
    const FreeLimbs judge(fall.body);
    double energy = judge.Energy(fall.Now(), static_cast<double>(kStandardGravity)), sum = 0.0;
    for (int step = 0; step < kFallSteps; ++step) {
      fall.plant.Step(step, fall.hold);
      const double now = judge.Energy(fall.Now(), static_cast<double>(kStandardGravity));
      worst = std::max(worst, (now - energy) / fall.unit);
      sum += std::max(now - energy, 0.0) / fall.unit;
      energy = now;
    }
    gained = std::max(gained, sum);
  }
  CAPTURE(worst, gained);
  // Measured: 4.5e-5 M g L in a step and 1.1e-4 in the 6 s of one figure.
  REQUIRE(worst < 1e-3);
  REQUIRE(gained < 1e-3);
}

TEST_CASE("strength: who stands stands still for a minute", "[physics][strength]") {
  for (const char* name : {"mr-star-man", "beryl-biped", "horse", "five-rod-fred"}) {
    CAPTURE(name);
    Figure figure = ShippedFigure(name);
    for (Rod& rod : figure.rods) rod.strength = 20.0f;
    const Mechanism body(figure);
    const auto hold = Towards<1>(std::vector<float>(static_cast<std::size_t>(body.joints), 0.0f), 0.1f);
    StrengthPlant<1> plant(body, Environment{}, StartState{}, kStep);
    // A figure that cannot stand falls first. Rest is judged after that.
    for (int step = 0; step < 3000; ++step) plant.Step(step, hold);
    const Snapshot settled = plant.Observe(0);
    for (int step = 3000; step < 9000; ++step) plant.Step(step, hold);
    const Snapshot later = plant.Observe(0);
    // Measured: 9.7e-7 m, 1.8e-7 m, 9e-8 rad.
    REQUIRE(std::abs(later.x_m - settled.x_m) < 1e-5);
    REQUIRE(std::abs(later.y_m - settled.y_m) < 1e-5f);
    REQUIRE(std::abs(later.turn_rad - settled.turn_rad) < 1e-5);
    float carried = 0.0f;
    for (int k = 0; k < body.endpoints; ++k) carried += plant.ContactForce(k, 0)[1];
    REQUIRE(carried == Catch::Approx(body.mass_kg * kStandardGravity).epsilon(1e-3));
  }
}

TEST_CASE("strength: a sliding box stops after v^2 / 2 mu g", "[physics][strength]") {
  const float speed = GENERATE(0.7f, 2.3f, 6.1f);
  const float friction = GENERATE(0.15f, 0.8f);
  Figure box;
  for (int i = 0; i < 4; ++i) {
    Rod rod;
    rod.length_m = i % 2 == 0 ? 1.2f : 0.4f;
    rod.mass_kg = 0.7f;
    rod.parent = i - 1;
    rod.rest_rad = i == 0 ? 0.0f : 1.5707963f;
    rod.strength = 20.0f;
    box.rods.push_back(rod);
  }
  REQUIRE(Validate(box));
  const Mechanism body(box);
  const double exact = static_cast<double>(speed * speed) /
                       (2.0 * static_cast<double>(friction) * static_cast<double>(kStandardGravity));
  std::array<double, 2> error{};
  for (std::size_t halving = 0; halving < 2; ++halving) {
    const float h = halving == 0 ? 0.01f : 0.005f;
    StrengthPlant<1> plant(body, {.friction = friction}, {.velocity_x_mps = speed}, h);
    const auto hold = Towards<1>(std::vector<float>(3, 0.0f), 0.1f, h);
    for (int step = 0; step < static_cast<int>(6.0f / h); ++step) plant.Step(step, hold);
    error[halving] = std::abs(plant.Save().distance_m[0] - exact);
    REQUIRE(std::abs(plant.Save().velocity_x[0]) < 1e-5f);
    REQUIRE(std::abs(plant.Save().turn_rad[0]) < 1e-4);
  }
  CAPTURE(speed, friction, exact, error[0], error[1]);
  // Measured: half of the way of a step. First order with contact.
  REQUIRE(error[0] < 0.6 * static_cast<double>(speed) * 0.01);
  REQUIRE(error[1] < 0.6 * error[0]);
}

}  // namespace gaitsmith::test
