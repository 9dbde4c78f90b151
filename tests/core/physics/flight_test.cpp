// SPDX-License-Identifier: MIT
// Laws of free flight, without contact with the ground.
#include <algorithm>
#include <catch_amalgamated.hpp>
#include <cmath>

#include "core/rollout/motion.h"
#include "tests/reference/free_flight.h"
#include "tests/scene.h"

namespace gaitsmith::test {

namespace {

struct Momentum {
  double linear_x, linear_y, angular;
};

/// Momenta at a frame from positions alone: a sixth-order central difference in time of the endpoints.
Momentum FromPositions(const Motion& motion, int frame) {
  constexpr double kWeights[] = {0.75, -0.15, 1.0 / 60.0};
  const Skeleton& bones = motion.Bones();
  constexpr int kApart = 4;
  const double h = kApart * static_cast<double>(motion.StepS());
  const auto middle = [&](int at, int rod) {
    const auto a = motion.Endpoint(at, bones.limbs[static_cast<std::size_t>(rod)].start);
    const auto b = motion.Endpoint(at, rod + 1);
    return Eigen::Vector2d(0.5 * (static_cast<double>(a.x) + static_cast<double>(b.x)),
                           0.5 * (static_cast<double>(a.y) + static_cast<double>(b.y)));
  };
  const auto direction = [&](int at, int rod) {
    const auto a = motion.Endpoint(at, bones.limbs[static_cast<std::size_t>(rod)].start);
    const auto b = motion.Endpoint(at, rod + 1);
    return std::atan2(static_cast<double>(b.y) - static_cast<double>(a.y),
                      static_cast<double>(b.x) - static_cast<double>(a.x));
  };
  Momentum total{0.0, 0.0, 0.0};
  for (int rod = 0; rod < bones.rods; ++rod) {
    const double mass = static_cast<double>(bones.limbs[static_cast<std::size_t>(rod)].mass_kg);
    const double inertia = static_cast<double>(bones.limbs[static_cast<std::size_t>(rod)].inertia_kgm2);
    Eigen::Vector2d velocity = Eigen::Vector2d::Zero();
    double turning = 0.0;
    for (int k = 1; k <= 3; ++k) {
      velocity += kWeights[k - 1] / h * (middle(frame + kApart * k, rod) - middle(frame - kApart * k, rod));
      turning +=
          kWeights[k - 1] / h *
          std::remainder(direction(frame + kApart * k, rod) - direction(frame - kApart * k, rod), 2.0 * M_PI);
    }
    const Eigen::Vector2d r = middle(frame, rod);
    total.angular += mass * (r.x() * velocity.y() - r.y() * velocity.x()) + inertia * turning;
    total.linear_x += mass * velocity.x();
    total.linear_y += mass * velocity.y();
  }
  return total;
}

StartState Thrown(float spin) {
  StartState start;
  start.drop_height_m = 100.0f;
  start.velocity_x_mps = 3.7f;
  start.velocity_y_mps = 41.0f;
  start.spin_radps = spin;
  return start;
}

}  // namespace

TEST_CASE("flight: momentum recomputed from positions stays, whatever the joints do", "[physics][flight]") {
  // Gravity is off, so that the figure stays in the air for ten seconds. It exerts no moment about the centre
  // of mass anyway.
  Environment weightless;
  weightless.gravity_mps2 = 0.0f;
  for (const char* name : {"mr-star-man", "beryl-biped", "horse"}) {
    const Figure figure = ShippedFigure(name);
    const float spin = GENERATE(-4.3f, 0.9f, 7.1f);
    CAPTURE(name, spin);
    // Alternates two poses slowly enough that differences in time resolve the joints' motion.
    std::vector<float> one(static_cast<std::size_t>(figure.Joints())), other(one.size());
    for (std::size_t j = 0; j < one.size(); ++j) {
      one[j] = 0.8f - 0.3f * static_cast<float>(j % 3);
      other[j] = -0.7f + 0.25f * static_cast<float>(j % 4);
    }
    const std::vector<Controller> controllers = {HoldPose(figure, one, 0.2f), HoldPose(figure, other, 0.2f)};
    const std::vector<Clip> clips = {{0, 0}, {1, 250}, {0, 500}, {1, 700}};
    const Motion motion = MotionOf(figure, weightless, Thrown(spin), {}, controllers, clips, 1000);
    const Momentum first = FromPositions(motion, 237);
    const double scale = std::max(std::abs(first.angular), std::abs(static_cast<double>(spin)) * 0.5);
    // Compared at frames where the joints are at rest, so that the error of the differences does not count.
    for (const int frame : {487, 687, 988}) {
      CAPTURE(frame);
      const Momentum now = FromPositions(motion, frame);
      REQUIRE(std::abs(now.angular - first.angular) <= 1e-5 * scale);
      REQUIRE(std::hypot(now.linear_x, now.linear_y) <= 1e-4);
    }
    REQUIRE(motion.At(1000).angular_momentum == motion.At(0).angular_momentum);
    REQUIRE(motion.At(1000).x_m == Catch::Approx(37.0).epsilon(1e-6));
  }
}

TEST_CASE("flight: free fall follows the closed form", "[physics][flight]") {
  const Figure figure = ShippedFigure("mr-star-man");
  const StartState start = Thrown(1.3f);
  const Motion motion =
      MotionOf(figure, Environment{}, start, {}, std::vector{RandomController(figure, {}, 4)},
               std::vector<Clip>{{0, 0}}, 900);
  for (int i = 0; i <= 900; i += 50) {
    const double t = i * 0.01;
    const double y = static_cast<double>(motion.At(0).y_m) + 41.0 * t - 0.5 * 9.8 * t * t;
    REQUIRE(static_cast<double>(motion.At(i).y_m) == Catch::Approx(y).margin(2e-3));
    REQUIRE(motion.At(i).x_m == Catch::Approx(3.7 * t).margin(1e-4));
  }
}

TEST_CASE("flight: a figure turns itself in mid-air as an independent integration says",
          "[physics][flight]") {
  const Figure figure = ShippedFigure("beryl-biped");
  const std::vector<float> pose = {0.9f, -0.6f, -0.4f, 0.8f};
  const float tau = GENERATE(0.08f, 0.3f);
  Environment weightless;
  weightless.gravity_mps2 = 0.0f;
  const std::vector<Controller> controllers = {HoldPose(figure, pose, tau)};
  StartState start = Thrown(0.0f);
  const Skeleton bones(figure);
  const FreeFlight reference(bones);
  std::vector<double> target;
  const SenseSpec& senses = controllers[0].senses;
  const BankShape shape(1, senses.kind, figure.Rods());
  for (int j = 0; j < shape.joints; ++j) {
    const auto& limb = bones.limbs[static_cast<std::size_t>(j) + 1];
    target.push_back(
        static_cast<double>(Decode(controllers[0].genes[shape.Target(0, j)], limb.min_rad, limb.max_rad)));
  }
  const double exact = reference.Turn(target, static_cast<double>(tau), 0.0, 1.0);
  double error[3];
  for (int halving = 0; halving < 3; ++halving) {
    const int steps = 100 << halving;
    const Motion motion = MotionOf(figure, weightless, start, {}, controllers, std::vector<Clip>{{0, 0}},
                                   steps, 1.0f / static_cast<float>(steps));
    error[halving] = std::abs(motion.At(steps).turn_rad - motion.At(0).turn_rad - exact);
  }
  CAPTURE(tau, exact, error[0], error[1], error[2]);
  REQUIRE(std::abs(exact) > 0.02);  // the figure does turn
  REQUIRE(error[0] < 2e-3 * std::abs(exact) + 1e-5);
  // Second order: halving the step quarters the error, down to the limit of single precision.
  if (error[1] > 1e-5) REQUIRE(error[0] / error[1] > 3.4);
}

TEST_CASE("flight: a push gives its impulse, and its moment about the centre of mass", "[physics][flight]") {
  const Figure figure = LyingRod();
  Environment weightless;
  weightless.gravity_mps2 = 0.0f;
  StartState start;
  start.drop_height_m = 5.0f;
  const std::vector<Push> pushes = {{20, kCentreOfMass, 0.35f, 0.0f}, {30, 1, 0.0f, 0.21f}};
  const Motion motion = MotionOf(figure, weightless, start, pushes, {}, {}, 40);
  REQUIRE(motion.At(20).velocity_x_mps == 0.0f);
  REQUIRE(motion.At(21).velocity_x_mps == Catch::Approx(0.5f));
  REQUIRE(motion.At(30).angular_momentum == 0.0f);
  REQUIRE(motion.At(31).velocity_y_mps == Catch::Approx(0.3f));
  REQUIRE(motion.At(31).angular_momentum == Catch::Approx(0.65f * 0.21f));
}

}  // namespace gaitsmith::test
