// SPDX-License-Identifier: MIT
// Springs on the ground: rest, friction, energy, drawn ground, and what makes a motion void.
#include <algorithm>
#include <catch_amalgamated.hpp>
#include <cmath>
#include <limits>

#include "core/numeric/random.h"
#include "tests/spring_scene.h"

using namespace gaitsmith;
using Catch::Approx;

namespace {

/// Rests that change at random, each for a third of a second.
ActuatorTargets<1> AtRandom(RandomStream& random) {
  ActuatorTargets<1> targets = AllAt(1.0f, 0.08f);
  for (auto& target : targets.target) target[0] = static_cast<float>(0.7 + 0.6 * random.Uniform());
  return targets;
}

double LowestGap(const Lattice& body, const Terrain& terrain, const LatticeState<1>& s) {
  double lowest = 1e9;
  for (std::size_t k = 0; k < body.nodes; ++k) {
    const double x = s.place_m[0] + static_cast<double>(s.x[k][0]);
    const double y = static_cast<double>(s.height_m[0]) + static_cast<double>(s.y[k][0]);
    // At the foot of a wall a node may be a rounding error to the wrong side.
    lowest = std::min(lowest, y - std::min(terrain.HeightAt(x - 1e-5), terrain.HeightAt(x + 1e-5)));
  }
  return lowest;
}

std::vector<Corner> Rubble(std::uint64_t seed) {
  RandomStream random(seed, 1, 0);
  std::vector<Corner> ground;
  for (int i = 0; i < 40; ++i) {
    const float x = -10.0f + 0.5f * static_cast<float>(i);
    const auto y = static_cast<float>(0.25 * random.Uniform());
    ground.push_back({x, y});
    if (random.Chance(0.3)) ground.push_back({x, y + (random.Chance(0.5) ? 0.2f : -0.2f)});
  }
  return ground;
}

}  // namespace

TEST_CASE("springs: a dropped figure comes to rest, and the ground bears its weight", "[core][springs]") {
  const Lattice body(Box(2000.0f, 10.0f));
  const std::vector<Corner> ground =
      GENERATE(std::vector<Corner>{}, std::vector<Corner>{{-3.0f, 0.0f}, {3.0f, 0.0f}});
  SpringPlant<1> plant(body, {.ground = ground}, {.drop_height_m = 0.3f}, kStep);
  for (int step = 0; step < 1000; ++step) plant.Step(step, AllAt(1.0f));
  double force = 0.0;
  for (int k = 0; k < static_cast<int>(body.nodes); ++k)
    force += static_cast<double>(plant.ContactForce(k, 0)[1]);
  CHECK(force == Approx(static_cast<double>(body.total_kg) * 9.8).epsilon(1e-3));
  CHECK(std::abs(static_cast<double>(plant.Observe(0).velocity_y_mps)) < 1e-4);
  CHECK(std::abs(static_cast<double>(plant.Observe(0).velocity_x_mps)) < 1e-4);
  CHECK(LowestGap(body, Terrain(ground), plant.Save()) == Approx(0.0).margin(1e-6));
}

TEST_CASE("springs: friction holds on a gentle slope, and slides on a steep one as Coulomb says",
          "[core][springs]") {
  const float friction = GENERATE(0.3f, 0.7f);
  const float slope = GENERATE(0.2f, 0.5f);
  const Lattice body(Pair(500.0f, 5.0f));
  SpringPlant<1> plant(body, {.friction = friction, .slope_rad = slope}, {}, kStep);
  for (int step = 0; step < 100; ++step) plant.Step(step, AllAt(1.0f));
  const double pull = 9.8 * (std::sin(static_cast<double>(slope)) -
                             static_cast<double>(friction) * std::cos(static_cast<double>(slope)));
  CHECK(plant.Observe(0).x_m == Approx(-0.5 * std::max(pull, 0.0)).margin(0.02));
  CHECK(static_cast<double>(plant.TermsOf(0).slip_sum_m) ==
        Approx(2.0 * 0.5 * std::max(pull, 0.0)).margin(0.04));
}

TEST_CASE("springs: the ground pushes only, rubs no more than Coulomb says, and gives no energy",
          "[core][springs]") {
  const std::uint64_t seed = GENERATE(range(std::uint64_t{1}, std::uint64_t{9}));
  const bool drawn = GENERATE(false, true);
  const Lattice body(Box(3000.0f, 0.0f));
  const Environment world{.friction = 0.6f, .ground = drawn ? Rubble(seed) : std::vector<Corner>{}};
  RandomStream random(seed, 0, 0);
  SpringPlant<1> plant(body, world, {.drop_height_m = 0.5f, .velocity_x_mps = 3.0f, .spin_radps = 5.0f},
                       kStep);
  double work = 0.0, ground_work = 0.0, worst_gain = 0.0, start = 0.0;
  ActuatorTargets<1> targets = AtRandom(random);
  const auto energy = [&] {
    const double lifted =
        static_cast<double>(body.total_kg) * 9.8 * static_cast<double>(plant.Save().height_m[0]);
    return TotalsOf(body, plant.Save(), 9.8).Energy() + lifted;
  };
  start = energy();
  for (int step = 0; step < 600; ++step) {
    if (step % 30 == 0) targets = AtRandom(random);
    plant.Step(step, targets);
    for (std::size_t j = 0; j < body.muscles; ++j) work += static_cast<double>(plant.Save().work_j[j][0]);
    const Snapshot now = plant.Observe(0);
    ground_work += static_cast<double>(now.normal_work_j) + static_cast<double>(now.friction_work_j);
    CHECK(static_cast<double>(now.friction_gain_j) <= 1e-7);
    worst_gain = std::max(worst_gain, energy() - start - work);
    for (std::size_t k = 0; k < body.nodes && !drawn; ++k) {
      const float normal = plant.Save().normal[k][0], tangent = plant.Save().tangent[k][0];
      CHECK(normal >= 0.0f);
      CHECK(std::abs(tangent) <= 0.6f * normal * 1.0001f + 1e-7f);
    }
  }
  CHECK(ground_work < 0.0);
  // What leapfrog wavers by, and no more.
  CHECK(worst_gain < 0.02 * (start + std::abs(work)));
  CHECK(!plant.TermsOf(0).broke_physics);
}

TEST_CASE("springs: nodes stay above drawn ground, whatever it is", "[core][springs]") {
  const std::uint64_t seed = GENERATE(range(std::uint64_t{1}, std::uint64_t{31}));
  const Lattice body(Box(1500.0f, 4.0f));
  const Environment world{.ground = Rubble(seed)};
  const Terrain terrain(world.ground);
  RandomStream random(seed, 0, 0);
  SpringPlant<1> plant(body, world,
                       {.drop_height_m = 0.2f,
                        .velocity_x_mps = static_cast<float>(12.0 * random.Uniform() - 6.0),
                        .spin_radps = 4.0f},
                       kStep);
  CHECK(LowestGap(body, terrain, plant.Save()) >= 0.1999);
  ActuatorTargets<1> targets = AtRandom(random);
  double lowest = 0.0;
  for (int step = 0; step < 1000; ++step) {
    if (step % 30 == 0) targets = AtRandom(random);
    plant.Step(step, targets);
    lowest = std::min(lowest, LowestGap(body, terrain, plant.Save()));
  }
  CHECK(lowest > -1e-3);
  CHECK(!plant.TermsOf(0).broke_physics);
}

TEST_CASE("springs: a wall stops what is thrown at it", "[core][springs]") {
  const Lattice body(Box(4000.0f, 10.0f));
  const float side = GENERATE(1.0f, -1.0f);
  std::vector<Corner> wall{{1.0f, 0.0f}, {1.0f, 3.0f}, {1.02f, 3.0f}, {1.02f, 0.0f}};
  if (side < 0.0f) {
    std::ranges::reverse(wall);
    for (Corner& corner : wall) corner.x_m = -corner.x_m;
  }
  SpringPlant<1> plant(body, {.ground = wall}, {.drop_height_m = 0.5f, .velocity_x_mps = side * 15.0f},
                       kStep);
  for (int step = 0; step < 200; ++step) {
    plant.Step(step, AllAt(1.0f));
    for (std::size_t k = 0; k < body.nodes; ++k)
      CHECK(static_cast<double>(side) *
                (plant.Save().place_m[0] + static_cast<double>(plant.Save().x[k][0])) <=
            1.0 + 1e-5);
  }
  CHECK(!plant.TermsOf(0).broke_physics);
}

TEST_CASE("springs: drawn ground that is level moves a figure as level ground does", "[core][springs]") {
  const Lattice body(Box());
  const StartState start{.drop_height_m = 0.1f, .velocity_x_mps = 1.0f};
  SpringPlant<1> level(body, {}, start, kStep);
  SpringPlant<1> drawn(body, {.ground = {{-5.0f, 0.0f}, {5.0f, 0.0f}}}, start, kStep);
  for (int step = 0; step < 60; ++step) {
    level.Step(step, AllAt(0.8f));
    drawn.Step(step, AllAt(0.8f));
    CHECK(drawn.Observe(0).x_m == Approx(level.Observe(0).x_m).margin(1e-4));
    CHECK(static_cast<double>(drawn.Observe(0).y_m) ==
          Approx(static_cast<double>(level.Observe(0).y_m)).margin(1e-4));
  }
}

TEST_CASE("springs: a node that lands on drawn ground slides as Coulomb says, also on a corner",
          "[core][springs]") {
  const Terrain level(std::vector<Corner>{{-5.0f, 0.0f}, {0.0f, 0.0f}, {5.0f, 0.0f}});
  const auto h = static_cast<double>(kStep / 4.0f);
  const double friction = GENERATE(0.0, 0.5);
  RandomStream random(5, 3, 0);
  for (int i = 0; i < 5000; ++i) {
    const double y = 2.0 * h * random.Uniform(), vx = random.Normal(), vy = -2.0 - random.Uniform();
    const double x =
        i % 2 == 0 ? 1.0 : vx * y / vy;  // in the middle of a face, or so that it lands on the corner
    NodePath path(x, y, vx, vy, h);
    path.Meet(level, friction, 0.3);
    REQUIRE(path.touches);
    CHECK(path.Y() == Approx(0.0).margin(1e-15));
    const double slowed = std::max(std::abs(vx) - friction * path.normal_y / 0.3, 0.0);
    CHECK(std::abs(path.SpeedX()) == Approx(slowed).margin(1e-12));
  }
}

TEST_CASE("springs: a figure that is torn apart is void, and its numbers stay finite", "[core][springs]") {
  const float impulse = GENERATE(300.0f, 1e6f);
  const Lattice body(Box());
  SpringPlant<1> plant(body, {}, {}, kStep);
  plant.Give({0, 0, impulse, impulse});
  for (int step = 0; step < 100; ++step) plant.Step(step, AllAt(1.0f));
  CHECK(plant.TermsOf(0).broke_physics);
  CHECK(std::isfinite(plant.Observe(0).x_m));
  CHECK(std::isfinite(plant.Observe(0).y_m));
  CHECK(std::isfinite(plant.Observe(0).turn_rad));
  for (std::size_t j = 0; j < body.muscles; ++j) CHECK(std::isfinite(plant.Read().position[j][0]));
}

TEST_CASE("springs: a motion whose numbers are not finite is void and rests", "[core][springs]") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const Lattice body(Box());
  SpringPlant<1> plant(body, {}, {}, kStep);
  plant.Step(0, AllAt(1.0f));
  plant.Give({0, 1, nan, 0.0f});
  for (int step = 1; step < 20; ++step) plant.Step(step, AllAt(1.0f));
  CHECK(plant.TermsOf(0).broke_physics);
  CHECK(std::isfinite(plant.Observe(0).x_m));
  for (int k = 0; k < 4; ++k) CHECK(std::isfinite(plant.ContactPoint(k, 0)[0]));
}

TEST_CASE("springs: lanes have the bits of figures alone, and a saved state goes on with its bits",
          "[core][springs]") {
  const bool drawn = GENERATE(false, true);
  const Lattice body(Box());
  const Environment world{.sway_rad = 0.1f, .ground = drawn ? Rubble(4) : std::vector<Corner>{}};
  const StartState start{.drop_height_m = 0.2f, .velocity_x_mps = -1.0f};
  SpringPlant<4> four(body, world, start, kStep);
  std::vector<SpringPlant<1>> ones(4, SpringPlant<1>(body, world, start, kStep));
  std::array<TrajectoryHash, 4> together, alone;
  RandomStream random(5, 0, 0);
  std::array<ActuatorTargets<1>, 4> each;
  LatticeState<1> saved{};
  for (int step = 0; step < 300; ++step) {
    if (step % 20 == 0) std::ranges::generate(each, [&] { return AtRandom(random); });
    ActuatorTargets<4> all{};
    for (std::size_t lane = 0; lane < 4; ++lane) {
      for (std::size_t j = 0; j < kMaxActuators; ++j) {
        const auto at = static_cast<int>(lane);
        all.target[j][at] = each[lane].target[j][0];
        all.decay[j][at] = each[lane].decay[j][0];
        all.inverse_tau[j][at] = each[lane].inverse_tau[j][0];
      }
      if (step == 150 && lane == 2) {
        // What was saved goes on in a plant that went elsewhere in between.
        for (int more = 0; more < 20; ++more) ones[lane].Step(step, each[0]);
        ones[lane].Restore(saved);
      }
      ones[lane].Step(step, each[lane]);
      ones[lane].AddTo(alone[lane], 0);
    }
    if (step == 149) saved = ones[2].Save();
    four.Step(step, all);
    for (std::size_t lane = 0; lane < 4; ++lane) four.AddTo(together[lane], static_cast<int>(lane));
  }
  for (std::size_t lane = 0; lane < 4; ++lane) CHECK(together[lane].Value() == alone[lane].Value());
  CHECK(together[0].Value() != together[1].Value());
}

TEST_CASE("springs: a symmetric figure that moves symmetrically goes to no side, however it is damped",
          "[core][springs]") {
  const float damping = GENERATE(4.0f, 100.0f, 1000.0f);
  const Lattice body(Table(2000.0f, damping));
  SpringPlant<1> plant(body, {}, {}, kStep);
  double furthest = 0.0;
  for (int step = 0; step < 200; ++step) {
    plant.Step(step, AllAt(step / 20 % 2 == 0 ? 0.7f : 1.2f));
    furthest = std::max(furthest, std::abs(plant.Observe(0).x_m));
  }
  CHECK(furthest < 1e-4);
}

TEST_CASE("springs: a mirrored figure moves as its mirror image, bit for bit", "[core][springs]") {
  Figure figure = Box();
  Figure mirrored = figure;
  for (Node& node : mirrored.nodes) node.x_m = -node.x_m;
  const Lattice body(figure), other(mirrored);
  SpringPlant<1> plant(body, {}, {.drop_height_m = 0.2f, .velocity_x_mps = 1.0f, .spin_radps = 2.0f}, kStep);
  SpringPlant<1> image(other, {}, {.drop_height_m = 0.2f, .velocity_x_mps = -1.0f, .spin_radps = -2.0f},
                       kStep);
  for (int step = 0; step < 300; ++step) {
    const ActuatorTargets<1> targets = AllAt(step % 40 < 20 ? 0.75f : 1.2f);
    plant.Step(step, targets);
    image.Step(step, targets);
  }
  for (std::size_t k = 0; k < body.nodes; ++k) {
    CHECK(image.Save().x[k][0] == -plant.Save().x[k][0]);
    CHECK(image.Save().y[k][0] == plant.Save().y[k][0]);
  }
  CHECK(image.Observe(0).turn_rad == -plant.Observe(0).turn_rad);
}
