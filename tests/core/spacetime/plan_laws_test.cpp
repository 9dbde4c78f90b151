// SPDX-License-Identifier: MIT
// Laws that planned motions obey: Newton's between the points where they are demanded, flight and swing
// against closed forms, forces in their cone, feet that keep their places.
#include <algorithm>
#include <catch_amalgamated.hpp>
#include <cmath>
#include <vector>

#include "core/document/json.h"
#include "core/numeric/random.h"
#include "core/spacetime/plan_ground.h"
#include "core/spacetime/plan_guess.h"
#include "core/spacetime/planner.h"
#include "core/spacetime/transcription.h"
#include "core/world/terrain.h"
#include "tests/scene.h"

namespace gaitsmith::test {

namespace {

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

PlanScene ShippedPlan(const std::string& name) {
  return SceneOf(DecodeJson(ReadFile("examples/plans/" + name + ".json")).value());
}

/// A cross that cannot fall over: a root, and at its start two equal rods opposite each other, which turn as
/// one. Nothing couples the two halves but the joint.
Figure Cross() {
  return {"Cross",
          {{.length_m = 1.0f, .mass_kg = 1.0f},
           {.length_m = 0.5f,
            .mass_kg = 0.5f,
            .parent = 0,
            .parent_end = RodEnd::kStart,
            .rest_rad = 0.7f,
            .min_rad = -3.0f,
            .max_rad = 3.0f},
           {.length_m = 0.5f,
            .mass_kg = 0.5f,
            .parent = 1,
            .parent_end = RodEnd::kStart,
            .rest_rad = 3.1415927f,
            .min_rad = 0.0f,
            .max_rad = 0.0f}}};
}

/// Greatest and middle moments that are not explained, between the points [M g l].
struct Residuals {
  double median, most_of_all, greatest, force;
};
Residuals ResidualsOf(const PlannedMotion& motion) {
  constexpr int kPoints = 4000;
  std::vector<double> moments;
  double force = 0.0;
  for (int i = 0; i <= kPoints; ++i) {
    const PlannedMotion::Instant at = motion.At(motion.DurationS() * i / kPoints);
    moments.push_back(std::abs(at.moment_residual));
    force = std::max(force, at.force_residual);
  }
  std::ranges::sort(moments);
  return {moments[kPoints / 2], moments[kPoints * 99 / 100], moments.back(), force};
}

}  // namespace

TEST_CASE("planned motions obey Newton's laws between the points where they are demanded", "[spacetime]") {
  const PlanScene scene = ShippedPlan("lamp-jump");
  const PlanAnswer coarse = SolvePlan(scene, {});
  REQUIRE(coarse.motion);
  const PlanAnswer fine = SolvePlan(scene, {.degree = 5, .pieces_per_second = 32}, &*coarse.motion);
  REQUIRE(fine.motion);
  const Residuals of_coarse = ResidualsOf(*coarse.motion), of_fine = ResidualsOf(*fine.motion);
  CHECK(of_coarse.force < 1e-8);
  CHECK(of_fine.force < 1e-8);
  CHECK(of_fine.median < 1e-5);
  CHECK(of_fine.most_of_all < 2e-3);
  CHECK(of_fine.median < 0.1 * of_coarse.median);
  CHECK(of_fine.most_of_all < 0.1 * of_coarse.most_of_all);
}

TEST_CASE("forces stay in the cone of friction, and feet where they stand", "[spacetime]") {
  const PlanScene scene = ShippedPlan("lamp-jump");
  const PlanAnswer answer = SolvePlan(scene, {.degree = 5, .pieces_per_second = 32});
  REQUIRE(answer.motion);
  const auto friction = static_cast<double>(scene.environment.friction);
  std::vector<PlannedMotion::Vector> place(static_cast<std::size_t>(scene.skeleton.endpoints));
  for (const Stance& stance : scene.plan.stances) {
    const auto endpoint = static_cast<std::size_t>(stance.endpoint);
    const double first = stance.first_step * 0.01, last = stance.last_step * 0.01;
    place[endpoint] = answer.motion->At(0.5 * (first + last)).endpoints[endpoint];
    for (int i = 0; i < 200; ++i) {
      const PlannedMotion::Instant at = answer.motion->At(first + (last - first) * (i + 0.5) / 200);
      CHECK(std::abs(at.endpoints[endpoint].x - place[endpoint].x) < 1e-3);
      CHECK(std::abs(at.endpoints[endpoint].y) < 1e-3);
      CHECK(std::abs(at.forces[endpoint].x) <= friction * at.forces[endpoint].y + 1e-9);
      CHECK(at.forces[endpoint].y >= -1e-9);
    }
  }
  for (int i = 0; i <= 400; ++i) {
    const PlannedMotion::Instant at = answer.motion->At(answer.motion->DurationS() * i / 400);
    for (const PlannedMotion::Vector& point : at.endpoints) CHECK(point.y > -2e-3);
    for (std::size_t j = 0; j < at.angle_rad.size(); ++j) {
      CHECK(at.angle_rad[j] >= static_cast<double>(scene.skeleton.limbs[j + 1].min_rad) - 1e-6);
      CHECK(at.angle_rad[j] <= static_cast<double>(scene.skeleton.limbs[j + 1].max_rad) + 1e-6);
    }
  }
  for (const PlannedMotion::Blow& blow : answer.motion->Blows()) {
    CHECK(std::abs(blow.impulse.x) <= friction * blow.impulse.y + 1e-9);
    CHECK(blow.impulse.y >= -1e-9);
  }
}

TEST_CASE("what flies falls along a parabola and keeps its spin", "[spacetime]") {
  Figure rod{"Rod", {{.length_m = 0.8f, .mass_kg = 0.7f, .rest_rad = 0.4f}}};
  PlanScene scene{Skeleton(rod),
                  {},
                  {.drop_height_m = 3.0f, .velocity_x_mps = 1.5f, .velocity_y_mps = 2.0f, .spin_radps = 2.0f},
                  {}};
  scene.plan.steps = 80;
  // No place is asked for: there is only one motion.
  scene.plan.keyframes = {{.step = 40}};
  const PlanAnswer answer = SolvePlan(scene, {});
  REQUIRE(answer.motion);
  const double start = answer.motion->At(0.0).centre.y;
  for (const double t : {0.1, 0.33, 0.5, 0.79}) {
    const PlannedMotion::Instant at = answer.motion->At(t);
    CHECK_THAT(at.centre.x, WithinAbs(1.5 * t, 1e-9));
    CHECK_THAT(at.centre.y,
               WithinAbs(start + 2.0 * t - 0.5 * static_cast<double>(kStandardGravity) * t * t, 1e-9));
    CHECK_THAT(at.direction_rad[0], WithinAbs(static_cast<double>(0.4f) + 2.0 * t, 1e-9));
  }
}

TEST_CASE("a swing from rest to rest costs what the calculus of variations says", "[spacetime]") {
  // One joint between two bodies J and K turns them against each other by theta in the time T. The angle is
  // then a cubic, the squared torque 12 theta^2 / T^3 over (1/J + 1/K)^2.
  const Figure cross = Cross();
  PlanScene scene{Skeleton(cross), {.gravity_mps2 = 0.0f}, {.drop_height_m = 5.0f}, {}};
  constexpr double kTheta = 1.25;
  scene.plan.steps = 100;
  scene.plan.smoothness = 1e-6f;
  scene.plan.keyframes = {{.step = 100, .pose_rad = {static_cast<float>(kTheta), 0.0f}, .still = true}};
  for (const int degree : {3, 5}) {
    const PlanAnswer answer = SolvePlan(scene, {.degree = degree, .pieces_per_second = 8});
    REQUIRE(answer.motion);
    // In units of mass (2 kg), longest rod (1 m) and gravity. A reduced mass at the joint adds to each body:
    // its share of the motion of the whole's centre.
    const double unit = std::sqrt(1.0 / static_cast<double>(kStandardGravity)), time = 1.0 / unit;
    // Root: half the mass, middle 0.5 from the joint; pair: half the mass, middle at the joint.
    const double root =
        0.5 / 12.0 + 0.5 * 0.5 * 0.25;  // about its own middle, and the two middles about the whole's
    const double pair = 2.0 * 0.25 * (0.25 / 12.0 + 0.25 * 0.25);
    const double share = 1.0 / (1.0 / root + 1.0 / pair);
    const double torque2 = share * share * 12.0 * kTheta * kTheta / (time * time * time);
    const double cost = torque2 * (1.0 + 1e-6 * (1.0 / (root * root) + 2.0 / (pair * pair)));
    CHECK_THAT(answer.cost, WithinRel(cost, 1e-5));
    const PlannedMotion::Instant middle = answer.motion->At(0.5);
    CHECK_THAT(middle.angle_rad[0], WithinAbs(0.5 * kTheta, 1e-3));
    const PlannedMotion::Instant quarter = answer.motion->At(0.25);
    CHECK_THAT(quarter.angle_rad[0], WithinAbs(kTheta * (3.0 / 16.0 - 2.0 / 64.0), 1e-3));
  }
}

TEST_CASE("nothing of a planned motion passes through drawn ground", "[spacetime]") {
  const PlanScene scene = ShippedPlan("lamp-hurdle");
  const PlanAnswer answer = SolvePlan(scene, {});
  REQUIRE(answer.motion);
  const Terrain terrain(scene.environment.ground);
  double least = 1.0;
  for (int i = 0; i <= 1000; ++i) {
    const PlannedMotion::Instant at = answer.motion->At(answer.motion->DurationS() * i / 1000);
    for (int rod = 0; rod < scene.skeleton.rods; ++rod) {
      const PlannedMotion::Vector &from = at.endpoints[static_cast<std::size_t>(
                                      scene.skeleton.limbs[static_cast<std::size_t>(rod)].start)],
                                  &to = at.endpoints[static_cast<std::size_t>(rod) + 1];
      for (int part = 0; part <= 8; ++part) {
        const double x = from.x + (to.x - from.x) * part / 8.0, y = from.y + (to.y - from.y) * part / 8.0;
        if (y - terrain.HeightAt(x) < -0.01)
          UNSCOPED_INFO("rod " << rod << " part " << part << " at point " << i << ": " << x << ", " << y);
        least = std::min(least, y - terrain.HeightAt(x));
      }
    }
  }
  CHECK(least > -0.01);
  // The same plan on level ground would not clear it.
  CHECK(answer.motion->At(1.0).centre.y > 0.2);
}

TEST_CASE("the cover of drawn ground is smooth and nowhere below it", "[spacetime]") {
  const std::vector<Corner> ground{{0.0f, 0.0f},  {0.0f, 0.3f}, {0.04f, 0.3f},
                                   {0.04f, 0.0f}, {1.0f, 0.0f}, {2.0f, 0.5f}};
  const PlanGround plan(ground, 0.5);
  const Terrain terrain(ground);
  for (int i = -200; i <= 600; ++i) {
    const double x = 0.01 * i, height = terrain.HeightAt(0.5 * x) / 0.5;
    const PlanGround::Height cover = plan.CoverAt(x);
    CHECK(cover.value >= height - 1e-9);
    constexpr double kH = 1e-6;
    CHECK_THAT(cover.slope,
               WithinAbs((plan.CoverAt(x + kH).value - plan.CoverAt(x - kH).value) / (2 * kH), 1e-3));
    CHECK_THAT(cover.bend,
               WithinAbs((plan.CoverAt(x + kH).slope - plan.CoverAt(x - kH).slope) / (2 * kH), 1e-1));
  }
  CHECK(plan.CoverAt(-0.3).value < 1e-9);
  CHECK_THAT(plan.At(3.0).value, WithinAbs(0.5, 1e-6));
}

TEST_CASE("the derivatives of a plan's program are those of its values", "[spacetime]") {
  const PlanScene scene = ShippedPlan(GENERATE("lamp-jump", "lamp-hurdle"));
  const PlanLayout layout(scene, {.degree = 4, .pieces_per_second = 6});
  const Eigen::VectorXd guess = GuessPlan(scene, layout);
  RandomStream random(3, 1, 1);
  const auto some = [&random](Eigen::Index count) {
    Eigen::VectorXd numbers(count);
    for (double& number : numbers) number = 2.0 * random.Uniform() - 1.0;
    return numbers;
  };
  for (const bool elastic : {false, true}) {
    const Transcription program(scene, layout, guess, elastic);
    const Eigen::VectorXd x = program.Completed(guess) + 0.1 * some(program.Variables());
    const Eigen::VectorXd multipliers = some(program.Equations());
    NonlinearProgram::Slopes at, more, less;
    program.SlopesAt(x, multipliers, at);
    const auto pull = [&](const NonlinearProgram::Slopes& slopes) {
      Eigen::VectorXd sum = slopes.gradient;
      for (std::size_t i = 0; i < slopes.jacobian.places.size(); ++i)
        sum[slopes.jacobian.places[i].column] +=
            slopes.jacobian.values[i] * multipliers[slopes.jacobian.places[i].row];
      return sum;
    };
    for (int i = 0; i < 5; ++i) {
      const Eigen::VectorXd direction = some(program.Variables());
      constexpr double kH = 1e-5;
      const auto values_more = program.ValuesAt(x + kH * direction),
                 values_less = program.ValuesAt(x - kH * direction);
      const double slope = (values_more.objective - values_less.objective) / (2 * kH);
      CHECK_THAT(at.gradient.dot(direction), WithinRel(slope, 1e-6));
      Eigen::VectorXd change = Eigen::VectorXd::Zero(program.Equations());
      for (std::size_t k = 0; k < at.jacobian.places.size(); ++k)
        change[at.jacobian.places[k].row] += at.jacobian.values[k] * direction[at.jacobian.places[k].column];
      CHECK((change - (values_more.equations - values_less.equations) / (2 * kH)).lpNorm<Eigen::Infinity>() <
            1e-6);
      program.SlopesAt(x + kH * direction, multipliers, more);
      program.SlopesAt(x - kH * direction, multipliers, less);
      Eigen::VectorXd bend = Eigen::VectorXd::Zero(program.Variables());
      for (std::size_t k = 0; k < at.hessian.places.size(); ++k) {
        const auto& [row, column] = at.hessian.places[k];
        bend[row] += at.hessian.values[k] * direction[column];
        if (row != column) bend[column] += at.hessian.values[k] * direction[row];
      }
      const Eigen::VectorXd expected = (pull(more) - pull(less)) / (2 * kH);
      CHECK((bend - expected).lpNorm<Eigen::Infinity>() < 1e-6 * expected.lpNorm<Eigen::Infinity>());
    }
  }
}

}  // namespace gaitsmith::test
