// SPDX-License-Identifier: MIT
// Laws of the joints of model 2: their strength, their limits, their work, and what they are to model 1.
#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <catch_amalgamated.hpp>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "core/document/json.h"
#include "core/numeric/random.h"
#include "core/physics/figure_plant.h"
#include "core/physics/strength_plant.h"
#include "core/rollout/rollout.h"
#include "tests/limb_scene.h"
#include "tests/reference/free_limbs.h"
#include "tests/scene.h"

namespace gaitsmith::test {

namespace {

Environment Weightless() {
  Environment environment;
  environment.gravity_mps2 = 0.0f;
  return environment;
}

/// Poses that change every 0.3 s, as far as the joints go and further.
std::vector<float> HastyPose(float time_s, int joints, std::uint64_t seed) {
  RandomStream random(seed, 82, static_cast<std::uint64_t>(time_s / 0.3f + 1e-3f));
  std::vector<float> pose(static_cast<std::size_t>(joints));
  for (float& angle : pose) angle = static_cast<float>(4.0 * random.Uniform() - 2.0);
  return pose;
}

}  // namespace

TEST_CASE("strength: no joint exceeds its torque or passes its limits", "[physics][strength]") {
  // Measured: 1.5e-3 rad, a stop being 1,000 times firmer than the limb; and once 5.2e-3 in a step whose
  // rounds ran out.
  constexpr float kGivesWay = 1e-2f;
  int stopped = 0, strained = 0, follows = 0;
  for (const float strength : {0.0f, 0.1f, 2.0f, 20.0f}) {
    for (std::uint64_t seed = 0; seed < 45; ++seed) {
      const Mechanism body(RandomTree(seed, 2 + static_cast<int>(seed) % 15, strength));
      StrengthPlant<1> plant(body, Environment{}, {.drop_height_m = 0.5f, .spin_radps = 1.0f}, kStep);
      for (int step = 0; step < 300; ++step) {
        const auto time_s = static_cast<float>(step) * kStep;
        plant.Step(step, Towards<1>(HastyPose(time_s, body.joints, seed), 0.05f));
        const LimbState<1>& s = plant.Save();
        CAPTURE(strength, seed, step);
        if (plant.TermsOf(0).broke_physics) break;
        for (std::size_t i = 1; i < static_cast<std::size_t>(body.rods); ++i) {
          const float angle = s.angle_rad[i - 1][0];
          REQUIRE(angle <= body.limbs[i].max_rad + kGivesWay);
          REQUIRE(angle >= body.limbs[i].min_rad - kGivesWay);
          if (s.stop_side[i][0] != 0.0f) {
            // A stop pushes back, and never holds.
            REQUIRE(s.stop_side[i][0] * s.joint_impulse[i][0] <= 0.0f);
            ++stopped;
            continue;
          }
          const float most = body.torque_nm[i] * kStep;
          REQUIRE(plant.Strain(static_cast<int>(i) - 1, 0) <= 1.0f);
          if (most > 0.0f && s.torque_side[i][0] != 0.0f)
            REQUIRE(plant.Strain(static_cast<int>(i) - 1, 0) == 1.0f);
          REQUIRE(std::abs(s.joint_impulse[i][0]) <= most);
          if (s.torque_side[i][0] != 0.0f) REQUIRE(s.joint_impulse[i][0] == s.torque_side[i][0] * most);
          ++(s.torque_side[i][0] != 0.0f ? strained : follows);
        }
      }
    }
  }
  CAPTURE(stopped, strained, follows);  // 26,000, 151,000, 235,000
  REQUIRE(std::min({stopped, strained, follows}) > 3000);
}

TEST_CASE("strength: in flight the limbs gain what the joints give them", "[physics][strength]") {
  // A step is a blow by the joints and then free motion, so an impulse J of a step works at the mean of the
  // speeds before and after it, both with the mass matrix M of the step's beginning: J M^-1 (p + J / 2).
  const float strength = GENERATE(0.0f, 0.01f, 0.05f, 0.2f, 50.0f);
  const Mechanism body(RandomTree(7, 5, strength));
  const FreeLimbs judge(body);
  const std::vector<float> pose = HastyPose(0.0f, body.joints, 3);
  std::array<double, 3> error{}, moved{};
  for (std::size_t halving = 0; halving < 3; ++halving) {
    const int steps = 100 << halving;
    const float h = 1.0f / static_cast<float>(steps);
    StrengthPlant<1> plant(body, Weightless(), {.drop_height_m = 50.0f, .spin_radps = 2.3f}, h);
    double energy = judge.Energy(plant.Save(), 0.0);
    for (int step = 0; step < steps; ++step) {
      const FreeLimbs::Matrix mass = judge.Mass(judge.Place(plant.Save()));
      const FreeLimbs::Vector momenta = judge.Momenta(plant.Save());
      plant.Step(step, Towards<1>(pose, 0.1f, h));
      FreeLimbs::Vector impulse = FreeLimbs::Vector::Zero(body.rods);
      for (Eigen::Index i = 1; i < body.rods; ++i)
        impulse[i] = static_cast<double>(plant.Save().joint_impulse[static_cast<std::size_t>(i)][0]);
      const double now = judge.Energy(plant.Save(), 0.0);
      error[halving] += now - energy - impulse.dot(mass.ldlt().solve(momenta + 0.5 * impulse));
      moved[halving] += std::abs(now - energy);
      energy = now;
    }
  }
  CAPTURE(strength, error[0], error[1], error[2], moved[0]);
  // Over one second, of 0.1 J that limp limbs exchange and of 1.3 to 2.4 J otherwise. Measured: 7.9e-5 J limp
  // and up to 1.6e-4 J otherwise; at h / 4 a sixteenth, or 1.5e-6 J of rounding.
  REQUIRE(std::abs(error[0]) < 1e-3 * moved[0]);
  REQUIRE(std::abs(error[2]) < std::abs(error[0]) / 10.0 + 5e-6);
}

TEST_CASE("strength: the stronger and stiffer the joints, the more they do what model 1 does",
          "[physics][strength]") {
  std::vector<double> medians;
  for (const float stiffness : {1e3f, 1e4f, 1e5f, 1e6f}) {
    std::vector<double> apart;
    for (const std::string& name : GalleryDocuments()) {
      const auto document = DecodeJson(ReadFile(name));
      REQUIRE(document);
      if (document->figure.HasSprings()) continue;
      Figure strong = document->figure;
      for (Rod& rod : strong.rods) {
        rod.strength = 1e6f;
        rod.stiffness = stiffness;
      }
      const Skeleton bones(document->figure);
      const Mechanism body(strong);
      const auto clips = DecodeClips(document->timeline, document->controllers, PortsOf(bones), kStep);
      Rollout<FigurePlant, 1> one(bones, document->environment, document->start, document->pushes, clips);
      Rollout<StrengthPlant, 1> two(body, document->environment, document->start, document->pushes, clips);
      double most = 0.0;
      for (int step = 1; step <= 100; ++step) {
        one.RunTo(step, kNothing, kNothing);
        two.RunTo(step, kNothing, kNothing);
        const Snapshot a = one.PlantNow().Observe(0), b = two.PlantNow().Observe(0);
        most = std::max(most, std::hypot(a.x_m - b.x_m, static_cast<double>(a.y_m - b.y_m)));
      }
      apart.push_back(most);
    }
    std::ranges::sort(apart);
    medians.push_back(apart[apart.size() / 2]);
  }
  // Measured: 2.8, 1.2, 0.80 and 0.78 mm. What is left are landings, which both resolve to first order.
  CAPTURE(medians);
  REQUIRE(std::ranges::is_sorted(medians, std::greater<>()));
  REQUIRE(medians.front() > 2.0 * medians.back());
  REQUIRE(medians.back() < 2e-3);
}

}  // namespace gaitsmith::test
