// SPDX-License-Identifier: MIT
// Traits of motions whose looks are known, their distance, and that measuring them changes no motion.
#include <catch_amalgamated.hpp>

#include "core/document/json.h"
#include "core/rollout/evaluator.h"
#include "tests/scene.h"

namespace gaitsmith::test {
namespace {

/// A problem of half a second without controllers' effort: every joint holds its drawn pose.
Problem Held(const Figure& figure) {
  Problem problem;
  problem.figure = figure;
  problem.task.duration_steps = 50;
  problem.rules = 1;
  problem.traits = true;
  return problem;
}

Traits TraitsOfHeld(const Problem& problem) {
  const Controller hold =
      HoldPose(problem.figure, std::vector<float>(static_cast<std::size_t>(problem.figure.Joints())), 0.1f);
  return Evaluator(problem).Evaluate(std::vector<Genome>{hold.genes}).front().traits;
}

}  // namespace

TEST_CASE("traits: a rod that lies is still, on both ends, and does nothing else", "[traits]") {
  const Traits traits = TraitsOfHeld(Held(LyingRod()));
  CHECK(TraitOf(traits, Trait::kStill) == 1.0f);
  CHECK(TraitOf(traits, Trait::kSupport) == 1.0f);
  CHECK(TraitOf(traits, Trait::kAir) == 0.0f);
  CHECK(TraitOf(traits, Trait::kSteps) == 0.0f);
  CHECK(TraitOf(traits, Trait::kUpright) == 1.0f);
  CHECK(std::abs(TraitOf(traits, Trait::kSpeed)) < 1e-3f);
  CHECK(TraitOf(traits, Trait::kBounce) < 1e-3f);
}

TEST_CASE("traits: a rod in free flight is in the air, and its height spreads as a parabola's", "[traits]") {
  Problem problem = Held(LyingRod());
  problem.start.drop_height_m = 50.0f;
  problem.start.velocity_x_mps = 2.6f;
  const Traits traits = TraitsOfHeld(problem);
  CHECK(TraitOf(traits, Trait::kAir) == 1.0f);
  CHECK(TraitOf(traits, Trait::kSupport) == 0.0f);
  CHECK(TraitOf(traits, Trait::kStill) < 0.1f);
  CHECK(TraitOf(traits, Trait::kSpeed) == Catch::Approx(2.0f).epsilon(1e-3));  // 2.6 m/s of a rod of 1.3 m
  // The standard deviation of g t^2 / 2 over [0, T] is g T^2 / 2 * sqrt(1/5 - 1/9).
  const double spread = static_cast<double>(problem.environment.gravity_mps2) * 0.25 / 2.0 *
                        std::sqrt(1.0 / 5.0 - 1.0 / 9.0) / 1.3;
  CHECK(TraitOf(traits, Trait::kBounce) == Catch::Approx(spread).epsilon(0.05));
}

TEST_CASE("traits: a rod that is dropped comes down once at each end", "[traits]") {
  Problem problem = Held(LyingRod());
  problem.start.drop_height_m = 0.3f;
  const Traits traits = TraitsOfHeld(problem);
  CHECK(TraitOf(traits, Trait::kSteps) == Catch::Approx(2.0f / 0.5f));
}

TEST_CASE("traits: measuring them changes no motion, and no lane differs", "[traits]") {
  for (const std::string& path : GalleryDocuments()) {
    const Document d = *DecodeJson(ReadFile(path));
    if (d.timeline.size() != 1) continue;
    CAPTURE(path);
    Problem problem = ReplayProblem(d, d.controllers.front());
    const std::vector<Genome> genomes(5, d.controllers.front().genes);
    const Evaluation plain = Evaluator(problem, true).Evaluate(genomes).front();
    CHECK(plain.traits == Traits{});
    problem.traits = true;
    const Evaluation looked = Evaluator(problem, true).Evaluate(genomes).front();
    CHECK(looked.trajectory_hash == plain.trajectory_hash);
    CHECK(looked.fitness == plain.fitness);
    for (const int lanes : Evaluator::kLaneCounts) {
      for (const Evaluation& one : Evaluator(problem, lanes).Evaluate(genomes))
        CHECK(one.traits == looked.traits);
    }
  }
}

TEST_CASE("traits: like motions of a small and a large figure have like traits", "[traits]") {
  Problem small = Held(LyingRod());
  small.start.drop_height_m = 20.0f;
  small.start.velocity_x_mps = 1.3f;
  Problem large = small;
  large.figure.rods.front().length_m *= 4.0f;
  large.start.drop_height_m *= 4.0f;
  large.start.velocity_x_mps *= 4.0f;
  large.environment.gravity_mps2 *= 4.0f;
  large.traits = true;
  CHECK(TraitDistance(TraitsOfHeld(small), TraitsOfHeld(large)) < 0.01f);
}

TEST_CASE("traits: the distance is a metric with a greatest value of 1", "[traits]") {
  Traits none{}, all{}, half{};
  for (std::size_t i = 0; i < kTraits; ++i) {
    all[i] = 10.0f * kTraitTable[i].scale;
    half[i] = i % 2 == 0 ? kTraitTable[i].scale : 0.0f;
  }
  CHECK(TraitDistance(none, none) == 0.0f);
  CHECK(TraitDistance(none, all) == 1.0f);
  CHECK(TraitDistance(none, half) == TraitDistance(half, none));
  CHECK(TraitDistance(none, half) == Catch::Approx(std::sqrt(7.0 / 13.0)));
  CHECK(TraitDistance(none, all) <= TraitDistance(none, half) + TraitDistance(half, all));
}

}  // namespace gaitsmith::test
