// SPDX-License-Identifier: MIT
// Laws of contact with the ground.
#include <algorithm>
#include <catch_amalgamated.hpp>
#include <cmath>

#include "core/physics/figure_plant.h"
#include "core/rollout/ground_use.h"
#include "core/rollout/motion.h"
#include "tests/reference/free_flight.h"
#include "tests/scene.h"

namespace gaitsmith::test {

TEST_CASE("ground: a sliding rod stops after v^2 / 2 mu g", "[physics][ground]") {
  const float speed = GENERATE(0.7f, 2.3f, 6.1f);
  const float friction = GENERATE(0.15f, 0.8f);
  Environment environment;
  environment.friction = friction;
  StartState start;
  start.velocity_x_mps = speed;
  const double exact = static_cast<double>(speed * speed) / (2.0 * static_cast<double>(friction) * 9.8);
  double error[2];
  for (const int halving : {0, 1}) {
    const float h = halving == 0 ? 0.01f : 0.005f;
    const Motion motion = MotionOf(LyingRod(), environment, start, {}, {}, {}, static_cast<int>(6.0f / h), h);
    error[halving] = std::abs(motion.At(motion.Frames() - 1).x_m - exact);
    CAPTURE(speed, friction, exact, h, error[halving]);
    REQUIRE(error[halving] <= static_cast<double>(speed * h));
    REQUIRE(std::abs(motion.At(motion.Frames() - 1).velocity_x_mps) < 1e-6f);
  }
  // First order with contact: half the step gives half the error, unless the error is tiny.
  REQUIRE((error[1] < 0.65 * error[0] || error[1] < 1e-4));
}

TEST_CASE("ground: on a slope, friction holds below its angle and lets slide above", "[physics][ground]") {
  Environment environment;
  environment.friction = 0.4f;
  environment.slope_rad = 0.35f;  // tan = 0.365
  const Motion held = MotionOf(LyingRod(), environment, StartState{}, {}, {}, {}, 500);
  REQUIRE(std::abs(held.At(500).x_m) < 1e-5);
  environment.slope_rad = 0.45f;  // tan = 0.483
  const Motion slid = MotionOf(LyingRod(), environment, StartState{}, {}, {}, {}, 300);
  const double pull = 9.8 * (std::sin(0.45) - 0.4 * std::cos(0.45));
  REQUIRE(slid.At(300).x_m == Catch::Approx(-0.5 * pull * 9.0).epsilon(0.01));
}

TEST_CASE("ground: on ice that rocks, a rod goes where gravity's component takes it", "[physics][ground]") {
  Environment environment;
  environment.friction = 0.0f;
  environment.sway_rad = 0.3f;
  environment.sway_period_s = 1.7f;
  for (const float slope : {0.0f, -0.1f}) {
    environment.slope_rad = slope;
    const Motion motion = MotionOf(LyingRod(), environment, StartState{}, {}, {}, {}, 600);
    double speed = 0.0, x = 0.0;
    for (int step = 0; step < 600; ++step) {
      const double angle =
          static_cast<double>(slope) + 0.3 * std::sin(2.0 * 3.14159265358979 * step * 0.01 / 1.7);
      speed -= 9.8 * std::sin(angle) * 0.01;
      x += speed * 0.01;
    }
    CAPTURE(slope, x);
    REQUIRE(motion.At(600).velocity_x_mps == Catch::Approx(speed).margin(1e-4));
    REQUIRE(motion.At(600).x_m == Catch::Approx(x).margin(1e-3));
    REQUIRE(std::abs(motion.At(600).y_m - motion.At(0).y_m) < 1e-4f);
  }
}

TEST_CASE("ground: rocking to the right is the mirror image of rocking to the left", "[physics][ground]") {
  Environment environment;
  environment.sway_rad = 0.2f;
  environment.slope_rad = 0.05f;
  const float half = 0.5f * environment.sway_period_s;
  for (const float time : {0.0f, 0.3f, 1.1f, 3.9f, 40.2f}) {
    const float here = GroundAngle(environment, time) - environment.slope_rad;
    const float later = GroundAngle(environment, time + half) - environment.slope_rad;
    CAPTURE(time);
    REQUIRE(std::abs(here + later) < 1e-5f);
    REQUIRE(std::abs(here) <= 0.2f);
  }
}

TEST_CASE("ground: rest stays rest for a minute", "[physics][ground]") {
  for (const char* name : {"mr-star-man", "beryl-biped", "horse", "five-rod-fred"}) {
    CAPTURE(name);
    Figure figure = ShippedFigure(name);
    // A figure that cannot stand falls first. Rest is judged after that.
    const Motion motion = MotionOf(figure, Environment{}, StartState{}, {}, {}, {}, 9000);
    const auto& settled = motion.At(3000);
    const auto& later = motion.At(9000);
    REQUIRE(std::abs(later.x_m - settled.x_m) < 1e-5);
    REQUIRE(std::abs(later.y_m - settled.y_m) < 1e-5f);
    REQUIRE(std::abs(later.turn_rad - settled.turn_rad) < 1e-5);
  }
}

TEST_CASE("ground: forces on a resting figure carry its weight", "[physics][ground]") {
  const Figure figure = ShippedFigure("mr-star-man");
  const Motion motion = MotionOf(figure, Environment{}, StartState{}, {}, {}, {}, 200);
  double carried = 0.0;
  for (int k = 0; k < motion.Bones().endpoints; ++k) carried += static_cast<double>(motion.Force(200, k).y);
  REQUIRE(carried == Catch::Approx(5.0 * 9.8).epsilon(1e-4));
}

TEST_CASE("ground: a frozen figure never gains energy, over 1000 random drops", "[physics][ground]") {
  double worst = -1e9, largest_lift_m = 0.0;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    const Figure figure = RandomFigure(seed);
    RandomStream random(seed, 1, 0);
    const auto between = [&](double low, double high) {
      return static_cast<float>(low + (high - low) * random.Uniform());
    };
    StartState start;
    start.drop_height_m = between(0.0, 1.0);
    start.velocity_x_mps = between(-3.0, 3.0);
    start.velocity_y_mps = between(-3.0, 1.0);
    start.spin_radps = between(-6.0, 6.0);
    Environment environment;
    environment.friction = between(0.0, 1.5);
    const Motion motion = MotionOf(figure, environment, start, {}, {}, {}, 150);
    const std::vector<double> still(static_cast<std::size_t>(figure.Joints()), 0.0);
    const double inertia = FreeFlight(motion.Bones()).ShapeAt(still, still).inertia;
    const double mass = static_cast<double>(motion.Bones().mass_kg);
    const auto energy = [&](const Motion::Frame& f) {
      const double vx = static_cast<double>(f.velocity_x_mps), vy = static_cast<double>(f.velocity_y_mps);
      const double spin = static_cast<double>(f.angular_momentum) / inertia;
      return 0.5 * mass * (vx * vx + vy * vy) + 0.5 * inertia * spin * spin +
             mass * 9.8 * static_cast<double>(f.y_m);
    };
    for (int i = 1; i < motion.Frames(); ++i) {
      largest_lift_m =
          std::max(largest_lift_m, static_cast<double>(motion.At(i).lifting_work_j) / (mass * 9.8));
      const double gained = energy(motion.At(i)) - energy(motion.At(i - 1));
      if (gained > worst) worst = gained;
      if (gained > 1e-3) {
        CAPTURE(seed, i, gained, motion.At(i).lifting_work_j, motion.At(i).normal_work_j,
                motion.At(i).friction_work_j);
        REQUIRE(gained <= 1e-3);
      }
    }
  }
  CAPTURE(worst);
  REQUIRE(worst <= 1e-3);
  // The limit in the comment of kContactSweeps (core/physics/constants.h).
  CAPTURE(largest_lift_m);
  REQUIRE(largest_lift_m < 3.2e-3);
}

TEST_CASE("ground: friction works against motion, but for 1e-4 of its work", "[physics][ground]") {
  double right = 0.0, wrong = 0.0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Figure figure = ShippedFigure(seed % 2 == 0 ? "mr-star-man" : "beryl-biped");
    const Motion motion =
        MotionOf(figure, Environment{}, StartState{}, {}, std::vector{RandomController(figure, {}, seed)},
                 std::vector<Clip>{{0, 0}}, 1000);
    for (int i = 1; i < motion.Frames(); ++i) {
      // Contact by contact, so that one foot's positive friction work cannot be hidden by another's negative
      // work.
      const double gain = static_cast<double>(motion.At(i).friction_gain_j);
      wrong += gain;
      right += static_cast<double>(motion.At(i).friction_work_j) - gain;
    }
  }
  CAPTURE(right, wrong);
  REQUIRE(right < -100.0);
  REQUIRE(wrong <= -1e-4 * right);
}

TEST_CASE("ground: forces stay in the friction cone and endpoints above the ground", "[physics][ground]") {
  SenseSpec fast;
  fast.tau_min_s = 0.07f;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Figure figure = RandomFigure(seed + 500);
    const Motion motion =
        MotionOf(figure, Environment{}, StartState{}, {}, std::vector{RandomController(figure, fast, seed)},
                 std::vector<Clip>{{0, 0}}, 500);
    if (motion.TermsAt(500).broke_physics) continue;
    for (int i = 0; i < motion.Frames(); ++i) {
      for (int k = 0; k < motion.Bones().endpoints; ++k) {
        const auto force = motion.Force(i, k);
        REQUIRE(force.y >= 0.0f);
        REQUIRE(std::abs(force.x) <= 0.8f * force.y * 1.00001f);
        REQUIRE(motion.At(i).y_m + motion.Endpoint(i, k).y >= -2e-6f);
      }
    }
  }
}

TEST_CASE("joints: no limit is ever passed, however hasty the rules", "[physics][joints]") {
  SenseSpec hasty;
  hasty.tau_min_s = 0.05f;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Figure figure = ShippedFigure("beryl-biped");
    const Motion motion =
        MotionOf(figure, Environment{}, StartState{}, {}, std::vector{RandomController(figure, hasty, seed)},
                 std::vector<Clip>{{0, 0}}, 500);
    for (int i = 0; i < motion.Frames(); ++i) {
      for (int j = 0; j < motion.Bones().joints; ++j) {
        const auto& limb = motion.Bones().limbs[static_cast<std::size_t>(j) + 1];
        REQUIRE(motion.AngleRad(i, j) >= limb.min_rad);
        REQUIRE(motion.AngleRad(i, j) <= limb.max_rad);
      }
    }
  }
}

TEST_CASE("ground: the energy that its blow gives is what the figure has more", "[physics][ground]") {
  Environment weightless;
  weightless.gravity_mps2 = 0.0f;
  const Skeleton rod(LyingRod());
  const double mass = 0.7;
  const auto energy = [&](const MotionState<1>& s, double inverse_inertia) {
    const auto square = [](Lane<1>::F value) {
      return static_cast<double>(value[0]) * static_cast<double>(value[0]);
    };
    return 0.5 * (mass * (square(s.velocity_x) + square(s.velocity_y)) +
                  square(s.angular_momentum) * inverse_inertia);
  };
  int blows = 0;
  for (const float along : {-30.0f, 0.0f, 12.0f}) {
    for (const float down : {-15.0f, -40.0f}) {
      for (const float spin : {-25.0f, -3.0f, 8.0f}) {
        CAPTURE(along, down, spin);
        FigurePlant<1> plant(
            rod, weightless,
            {.drop_height_m = 0.05f, .velocity_x_mps = along, .velocity_y_mps = down, .spin_radps = spin},
            kStep);
        const MotionState<1> before = plant.Save();
        plant.Step(0, {});
        const MotionState<1> after = plant.Save();
        const auto inverse_inertia = static_cast<double>(after.inverse_inertia[0]);
        const double came = energy(before, inverse_inertia);
        const double gained = energy(after, inverse_inertia) - came;
        const auto given = static_cast<double>(after.ground.given_energy_j[0]);
        CHECK(std::abs(given - gained) < 0.02 * came);
        blows += gained < -0.3 * came ? 1 : 0;
      }
    }
  }
  CHECK(blows >= 12);
}

TEST_CASE("mirror: a mirrored figure does the mirrored fall", "[physics][ground]") {
  Figure figure = ShippedFigure("hopper");
  Figure mirrored = figure;
  for (Rod& rod : mirrored.rods) {
    rod.rest_rad = rod.parent == kNoParent ? 3.1415927f - rod.rest_rad : -rod.rest_rad;
  }
  const Motion one = MotionOf(figure, Environment{}, StartState{}, {}, {}, {}, 60);
  const Motion other = MotionOf(mirrored, Environment{}, StartState{}, {}, {}, {}, 60);
  REQUIRE(other.At(60).x_m == Catch::Approx(-one.At(60).x_m).margin(1e-4));
  REQUIRE(other.At(60).y_m == Catch::Approx(one.At(60).y_m).margin(1e-4f));
}

TEST_CASE("ground use: a rod at rest lies on both ends all the time, one that is thrown on none",
          "[physics][ground]") {
  const GroundUse lying = GroundUseOf(MotionOf(LyingRod(), {}, {}, {}, {}, {}, 200));
  CHECK(lying.share == 1.0f);
  CHECK(lying.bearers == 2);
  StartState thrown;
  thrown.drop_height_m = 50.0f;
  const GroundUse flying = GroundUseOf(MotionOf(LyingRod(), {}, thrown, {}, {}, {}, 200));
  CHECK(flying.share == 0.0f);
  CHECK(flying.bearers == 0);
}

}  // namespace gaitsmith::test
