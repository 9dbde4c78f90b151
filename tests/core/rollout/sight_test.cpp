// SPDX-License-Identifier: MIT
// Controllers that see the ground ahead: what they feel against closed forms, level ground, mirror images,
// and every number of lanes.
#include <algorithm>
#include <catch_amalgamated.hpp>
#include <cmath>

#include "core/control/rule_edit.h"
#include "core/document/document.h"
#include "core/document/json.h"
#include "core/document/link.h"
#include "core/rollout/evaluator.h"
#include "core/rollout/mirror_image.h"
#include "tests/scene.h"

namespace gaitsmith::test {

namespace {

constexpr double kStepAt = 2.0, kStepHigh = 0.25;  // [m]

/// Mr. Star-Man with limited joints before a step, and a controller with sight.
Document BeforeStep(std::uint64_t seed, Facing facing = Facing::kRight) {
  Document d = StarManTravel(SenseKind::kSight);
  d.model = 2;
  d.senses.facing = facing;
  const float side = facing == Facing::kRight ? 1.0f : -1.0f;
  constexpr auto kX = static_cast<float>(kStepAt), kY = static_cast<float>(kStepHigh);
  d.environment.ground = facing == Facing::kRight ? std::vector<Corner>{{kX, 0.0f}, {kX, kY}}
                                                  : std::vector<Corner>{{-kX, kY}, {-kX, 0.0f}};
  d.start = {.drop_height_m = 0.5f, .velocity_x_mps = 4.0f * side};
  d.controllers = {RandomController(d.figure, d.senses, seed)};
  d.timeline = {{0, 0}};
  d.duration_steps = 200;
  return d;
}

/// The two senses of the ground, the last of the set.
struct Seen {
  float ahead, corner;
};
Seen SeenAt(const Motion& motion, int frame) {
  const int count = SenseCount(SenseKind::kSight, motion.Bones().rods);
  return {motion.Sense(frame, count - 2), motion.Sense(frame, count - 1)};
}

/// The same controller without sight.
Controller WithoutSight(const Controller& seeing, const PortCount& ports) {
  Controller blind = seeing;
  blind.senses.kind = SenseKind::kPhysical;
  const BankShape to(blind.rules, SenseKind::kPhysical, ports), from = seeing.Shape(ports).Bank();
  blind.genes.assign(to.Genes(), 0);
  for (int rule = 0; rule < blind.rules; ++rule) {
    for (int sense = 0; sense < to.senses; ++sense) {
      blind.genes[to.Low(rule, sense)] = seeing.genes[from.Low(rule, sense)];
      blind.genes[to.High(rule, sense)] = seeing.genes[from.High(rule, sense)];
    }
    for (int joint = 0; joint < to.joints; ++joint)
      blind.genes[to.Target(rule, joint)] = seeing.genes[from.Target(rule, joint)];
    blind.genes[to.Tau(rule)] = seeing.genes[from.Tau(rule)];
  }
  return blind;
}

}  // namespace

TEST_CASE("sight: before a step it tells how far it is and how high, and behind it nothing more",
          "[control][ground][strength]") {
  bool crossed = false;
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const Document d = BeforeStep(seed);
    const Motion motion = Simulate(d);
    const double rod = static_cast<double>(motion.Bones().longest_rod_m);
    const double sight = static_cast<double>(d.senses.sight_rods) * rod;
    for (int frame = 1; frame < motion.Frames(); ++frame) {
      const double x = motion.At(frame).x_m;
      const bool before = x < kStepAt;
      const double rise = before && x + sight >= kStepAt ? kStepHigh : 0.0;
      const double way = before ? std::min((kStepAt - x) / sight, 1.0) : 1.0;
      crossed |= !before;
      CAPTURE(seed, frame, x);
      const Seen seen = SeenAt(motion, frame);
      REQUIRE(std::abs(static_cast<double>(seen.ahead) - (0.5 + rise / (2.0 * rod))) < 1e-6);
      REQUIRE(std::abs(static_cast<double>(seen.corner) - way) < 1e-6);
    }
  }
  REQUIRE(crossed);
}

TEST_CASE("sight: what is far higher or deeper is felt as the end of the range", "[control][ground]") {
  Document d = BeforeStep(1);
  d.environment.ground = {{0.5f, 0.0f}, {0.5f, -15.0f}, {0.8f, -15.0f}, {0.8f, 15.0f}};
  d.start = {.drop_height_m = 18.0f, .velocity_x_mps = 0.4f};
  d.duration_steps = 100;
  float least = 1.0f, greatest = 0.0f;
  const auto look = [&](float rods) {
    d.senses.sight_rods = d.controllers[0].senses.sight_rods = rods;
    const Motion motion = Simulate(d);
    for (int frame = 1; frame < motion.Frames(); ++frame) {
      least = std::min(least, SeenAt(motion, frame).ahead);
      greatest = std::max(greatest, SeenAt(motion, frame).ahead);
    }
  };
  const float rod = Simulate(d).Bones().longest_rod_m;
  look(0.6f / rod);
  look(1.0f / rod);
  REQUIRE(least == 0.0f);
  REQUIRE(greatest == 1.0f);
}

TEST_CASE("sight: on level ground there is nothing to see, in every model", "[control][ground]") {
  for (int model = 1; model <= 2; ++model) {
    Document d = BeforeStep(3);
    d.model = model;
    d.environment.ground.clear();
    const Motion motion = Simulate(d);
    for (int frame = 1; frame < motion.Frames(); ++frame) {
      REQUIRE(SeenAt(motion, frame).ahead == 0.5f);
      REQUIRE(SeenAt(motion, frame).corner == 1.0f);
    }
  }
}

TEST_CASE("sight: rules that use it for nothing move as they do without it",
          "[control][ground][determinism]") {
  Document d = BeforeStep(5);
  const PortCount ports = d.figure.Rods();
  const int count = SenseCount(SenseKind::kSight, ports);
  for (int rule = 0; rule < d.controllers[0].rules; ++rule) {
    RuleEdit edit(d.controllers[0], ports, rule);
    edit.SetCares(count - 2, false);
    edit.SetCares(count - 1, false);
  }
  const Motion seeing = Simulate(d);
  d.controllers[0] = WithoutSight(d.controllers[0], ports);
  REQUIRE(Simulate(d).Hash() == seeing.Hash());
}

TEST_CASE("sight: the mirror image looks to the other side", "[control][ground][timeline]") {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    Document right = BeforeStep(seed);
    right.duration_steps = 60;  // rounding errors grow: a longer motion may differ
    Document left = BeforeStep(seed, Facing::kLeft);
    left.duration_steps = 60;
    const auto image = MirrorImageOf(right.controllers[0], right.figure);
    REQUIRE(image);
    REQUIRE(image->senses.facing == Facing::kLeft);
    left.controllers = {*image};
    const Motion there = Simulate(right), back = Simulate(left);
    for (int frame = 0; frame < there.Frames(); ++frame) {
      CAPTURE(seed, frame);
      REQUIRE(std::abs(there.At(frame).x_m + back.At(frame).x_m) < 1e-3);
      REQUIRE(there.At(frame).rule == back.At(frame).rule);
    }
    REQUIRE(MirrorImageOf(*image, right.figure)->senses == right.senses);
  }
}

TEST_CASE("sight: neighbours change no bit, and the recorded motion is the evaluated one",
          "[control][ground][determinism]") {
  Document d = BeforeStep(0);
  const Problem problem = ProblemOf(d);
  std::vector<Genome> genomes;
  genomes.reserve(11);
  for (std::uint64_t i = 0; i < 11; ++i) genomes.push_back(RandomController(d.figure, d.senses, i).genes);
  const auto alone = Evaluator(problem, 1, true).Evaluate(genomes);
  for (const int lanes : Evaluator::kLaneCounts) {
    const auto together = Evaluator(problem, lanes, true).Evaluate(genomes);
    for (std::size_t i = 0; i < genomes.size(); ++i)
      REQUIRE(together[i].trajectory_hash == alone[i].trajectory_hash);
  }
  d.duration_steps = problem.task.duration_steps;
  for (std::size_t i = 0; i < genomes.size(); ++i) {
    d.controllers[0].genes = genomes[i];
    REQUIRE(Simulate(d).Hash() == alone[i].trajectory_hash);
  }
}

TEST_CASE("sight: documents and links carry it, and say what does not fit", "[control][document]") {
  Document d = BeforeStep(7, Facing::kLeft);
  d.senses.sight_rods = d.controllers[0].senses.sight_rods = 3.5f;
  d.hash = Simulate(d).Hash();
  const auto again = DecodeLink(EncodeLink(d));
  REQUIRE(again);
  REQUIRE(again->controllers[0].senses == d.controllers[0].senses);
  REQUIRE(EncodeJson(*again) == EncodeJson(d));
  REQUIRE(EncodeJson(d).contains("\"ahead\""));
  const auto fault = [&](auto edit) {
    Document wrong = d;
    edit(wrong);
    const auto decoded = DecodeJson(EncodeJson(wrong));
    return decoded ? "" : decoded.error().Sentence();
  };
  CHECK(fault([](Document& wrong) { wrong.senses.sight_rods = 0.1f; }) ==
        "senses.sight_rods: must be from 0.5 to 20, is 0.1");
  CHECK(fault([](Document& wrong) {
          wrong.controllers.clear();
          wrong.timeline.clear();
          wrong.kind = ControllerKind::kNetwork;
          wrong.hash.reset();
        }) == "kind: a network has physical senses, and no sight");
}

}  // namespace gaitsmith::test
