// SPDX-License-Identifier: MIT
#include "core/kinematics/posture.h"

#include <catch_amalgamated.hpp>
#include <cmath>

#include "core/kinematics/kinematic_recorder.h"
#include "core/numeric/scalar_math.h"
#include "tests/scene.h"

namespace gaitsmith::test {

namespace {

Script ScriptWith(const Figure& figure) {
  return {.figure = figure,
          .environment = {},
          .start = {},
          .pushes = {},
          .controllers = {},
          .clips = {},
          .steps = 0};
}

/// Frames that all follow one law of time [s].
template <class Law>
Motion Following(const Figure& figure, int frames, const Law& posture_at) {
  std::vector<KinematicFrame> all;
  all.reserve(static_cast<std::size_t>(frames));
  for (int i = 0; i < frames; ++i) {
    all.push_back({.posture = posture_at(i * 0.01),
                   .forces = std::vector<Motion::Point>(figure.rods.size() + 1, Motion::Point{0.0f, 0.0f})});
  }
  return RecordKinematic(ScriptWith(figure), all);
}

}  // namespace

TEST_CASE("posture: endpoints are where the simulation has them", "[kinematics]") {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    Document d;
    d.figure = RandomFigure(seed);
    d.controllers = {RandomController(d.figure, d.senses, seed)};
    d.timeline = {{0, 0}};
    d.duration_steps = 200;
    const Motion motion = Simulate(d);
    for (const int frame : {0, 77, 200}) {
      const std::vector<WorldPoint> points = EndpointsOf(motion.Bones(), PostureAt(motion, frame));
      for (int k = 0; k < motion.Bones().endpoints; ++k) {
        const Motion::Point known = motion.Endpoint(frame, k);
        const auto at = static_cast<std::size_t>(k);
        CHECK(std::abs(points[at].x_m - motion.At(frame).x_m - static_cast<double>(known.x)) < 2e-5);
        CHECK(std::abs(points[at].y_m - static_cast<double>(motion.At(frame).y_m) -
                       static_cast<double>(known.y)) < 2e-5);
      }
    }
  }
}

TEST_CASE("posture: between frames a motion of constant acceleration is exact", "[kinematics]") {
  const Figure figure = ShippedFigure("beryl-biped");
  const auto law = [&](double t) {
    return Posture{.x_m = 1.0 + 2.0 * t - 3.0 * t * t,
                   .y_m = 1.0 + t,
                   .direction_rad = 4.0 * t * t,
                   .angle_rad = std::vector<double>(figure.rods.size() - 1, 0.5 * t - t * t)};
  };
  const Motion motion = Following(figure, 60, law);
  for (const double frame : {1.0, 20.25, 33.5, 57.9}) {
    const Posture between = PostureBetween(motion, frame), known = law(frame * 0.01);
    CHECK(std::abs(between.x_m - known.x_m) < 1e-12);
    CHECK(std::abs(between.y_m - known.y_m) < 2e-7);
    CHECK(std::abs(between.direction_rad - known.direction_rad) < 1e-12);
    for (std::size_t j = 0; j < known.angle_rad.size(); ++j)
      CHECK(std::abs(between.angle_rad[j] - known.angle_rad[j]) < 1e-7);
  }
  // At the ends there is no further frame.
  CHECK(PostureBetween(motion, 0.0).x_m == law(0.0).x_m);
  CHECK(std::abs(PostureBetween(motion, 59.0).x_m - law(0.59).x_m) < 1e-12);
}

TEST_CASE("kinematic recorder: a body that spins like a rigid one keeps the momentum I w", "[kinematics]") {
  const Figure figure = ShippedFigure("mr-star-man");
  const double spin_radps = 1.5;
  const auto law = [&](double t) {
    return Posture{.x_m = 0.3 * t,
                   .y_m = 2.0,
                   .direction_rad = spin_radps * t,
                   .angle_rad = std::vector<double>(figure.rods.size() - 1, 0.0)};
  };
  const Motion motion = Following(figure, 100, law);
  const Skeleton& bones = motion.Bones();
  double inertia = 0.0;
  for (int rod = 0; rod < bones.rods; ++rod) {
    const Skeleton::Limb& limb = bones.limbs[static_cast<std::size_t>(rod)];
    const Motion::Point from = motion.Endpoint(0, limb.start), to = motion.Endpoint(0, rod + 1);
    const double x = 0.5 * static_cast<double>(from.x + to.x), y = 0.5 * static_cast<double>(from.y + to.y);
    inertia += static_cast<double>(limb.inertia_kgm2) + static_cast<double>(limb.mass_kg) * (x * x + y * y);
  }
  for (const int frame : {0, 1, 50, 99}) {
    // The arms' chord is a little shorter than their arc.
    CHECK(std::abs(static_cast<double>(motion.At(frame).angular_momentum) / (inertia * spin_radps) - 1.0) <
          1e-4);
    CHECK(std::abs(motion.At(frame).velocity_x_mps - 0.3f) < 1e-5f);
    CHECK(motion.RateRadps(frame, 0) == 0.0f);
  }
  const Terms& terms = motion.TermsAt(99);
  CHECK(std::abs(static_cast<double>(terms.rotations) - spin_radps * 0.99 / (2.0 * kPi)) < 1e-6);
  CHECK(std::abs(terms.travel_m - 0.297f) < 1e-6f);
}

}  // namespace gaitsmith::test
