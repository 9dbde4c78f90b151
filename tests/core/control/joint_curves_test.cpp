// SPDX-License-Identifier: MIT
// Trajectories: the curve's value against its definition, joints that follow it, what happens at its end,
// mirror images, documents, and searches.
#include "core/control/joint_curves.h"

#include <algorithm>
#include <catch_amalgamated.hpp>
#include <cmath>

#include "core/control/controllers.h"
#include "core/document/binary.h"
#include "core/document/json.h"
#include "core/document/link.h"
#include "core/document/recording.h"
#include "core/physics/joint_response.h"
#include "core/rollout/evaluator.h"
#include "core/rollout/mirror_image.h"
#include "tests/scene.h"
#include "tests/search_run.h"

namespace gaitsmith::test {

namespace {

constexpr int kPeriod = 130;  // steps

SenseSpec CurveSenses(CurveEnd at_end, float tau_s = 0.1f) {
  return {.kind = SenseKind::kTimer, .period_steps = kPeriod, .tau_min_s = tau_s, .at_end = at_end};
}

/// Mr. Star-Man on random curves of ten knots.
Document OnCurves(CurveEnd at_end, std::uint64_t seed) {
  Document d = StarManTravel(SenseKind::kTimer);
  d.kind = ControllerKind::kTrajectory;
  d.senses = CurveSenses(at_end);
  RandomStream random(seed, 3, 1);
  d.controllers = {
      {"curves", d.kind, d.senses, d.rules, RandomGenome(SpaceOf(d).shape, d.senses, Variation{}, random)}};
  d.timeline = {{0, 0}};
  d.duration_steps = 400;
  REQUIRE(Validate(d));
  return d;
}

double Sum(const KnotTimes::Mix& mix, const std::vector<double>& knots) {
  double sum = 0.0;
  for (std::size_t i = 0; i < 4; ++i) sum += mix.weight[i] * knots[mix.knot[i]];
  return sum;
}

/// A joint's curve of a document, at a time since the start [rad].
double CurveOf(const Document& d, const Skeleton& bones, int joint, double time_steps) {
  const Controller& c = d.controllers[0];
  const CurveShape shape(c.rules, bones.rods);
  const Skeleton::Limb& limb = bones.limbs[static_cast<std::size_t>(joint) + 1];
  std::vector<double> knots;
  knots.reserve(static_cast<std::size_t>(shape.knots));
  for (int knot = 0; knot < shape.knots; ++knot)
    knots.push_back(
        static_cast<double>(Decode(c.genes[shape.Angle(knot, joint)], limb.min_rad, limb.max_rad)));
  return Sum(KnotTimes(c.rules, c.senses).ValueAt(time_steps), knots);
}

}  // namespace

TEST_CASE("trajectory: weights add up to one, and a straight line of knots is a straight line",
          "[control][trajectory]") {
  for (const CurveEnd at_end : {CurveEnd::kRepeat, CurveEnd::kRest}) {
    for (const int knots : {1, 2, 3, 4, 10, kMaxRules}) {
      const KnotTimes times(knots, CurveSenses(at_end));
      for (double t = 0.0; t < 3.0 * kPeriod; t += 0.37) {
        CAPTURE(knots, t);
        const KnotTimes::Mix mix = times.ValueAt(t);
        double sum = 0.0;
        for (std::size_t i = 0; i < 4; ++i) {
          sum += mix.weight[i];
          REQUIRE(mix.weight[i] >= 0.0);
          REQUIRE(mix.knot[i] < static_cast<std::size_t>(knots));
        }
        REQUIRE(std::abs(sum - 1.0) < 1e-12);
        REQUIRE(times.NearestTo(t) < knots);
      }
    }
  }
  // Away from the ends a spline reproduces a line.
  const KnotTimes times(10, CurveSenses(CurveEnd::kRest));
  std::vector<double> line(10);
  for (int knot = 0; knot < 10; ++knot) line[static_cast<std::size_t>(knot)] = times.TimeOf(knot);
  for (double t = times.TimeOf(1); t < times.TimeOf(8); t += 1.0)
    CHECK(std::abs(Sum(times.ValueAt(t), line) - t) < 1e-9);
}

TEST_CASE("trajectory: a closed curve meets its start, a resting one begins and ends without speed",
          "[control][trajectory]") {
  const std::vector<double> knots = {0.3, -1.0, 0.8, 0.1, 0.9};
  const KnotTimes closed(5, CurveSenses(CurveEnd::kRepeat)), resting(5, CurveSenses(CurveEnd::kRest));
  const auto slope = [&](const KnotTimes& times, double t) {
    return (Sum(times.ValueAt(t + 1e-4), knots) - Sum(times.ValueAt(t), knots)) / 1e-4;
  };
  CHECK(std::abs(Sum(closed.ValueAt(kPeriod - 1e-9), knots) - Sum(closed.ValueAt(0.0), knots)) < 1e-8);
  CHECK(std::abs(slope(closed, kPeriod - 1e-4) - slope(closed, kPeriod)) < 1e-6);
  CHECK(Sum(closed.ValueAt(12.5), knots) == Sum(closed.ValueAt(12.5 + 3 * kPeriod), knots));
  CHECK(std::abs(slope(resting, 0.0)) < 1e-6);
  CHECK(std::abs(slope(resting, kPeriod - 1e-4)) < 1e-6);
  CHECK(Sum(resting.ValueAt(kPeriod), knots) == Sum(resting.ValueAt(9.0 * kPeriod), knots));
}

TEST_CASE("trajectory: a joint answers its curve as a critically damped filter, to second order in the step",
          "[control][trajectory]") {
  Figure figure = LyingRod();
  figure.rods.push_back({.parent = 0, .min_rad = -2.5f, .max_rad = 2.5f});
  const Skeleton bones(figure);
  const CurveShape shape(8, bones.rods);
  const Genome genes = {20000, 45000, 30000, 52000, 25000, 38000, 12000, 33000};
  const std::span<const Gene> span(genes);
  const std::array<std::array<float, 2>, 1> limits = {{{-2.5f, 2.5f}}};
  const auto end_of = [&](float step_s) {  // angle after 4 s
    SenseSpec senses = CurveSenses(CurveEnd::kRepeat, 0.08f);
    senses.period_steps = static_cast<int>(std::lround(1.6f / step_s));
    const JointCurves<1> curves(shape, senses, std::span(&span, 1), limits, step_s);
    ActuatorTargets<1> targets{};
    std::array<Lane<1>::F, kMaxJoints> angle{}, rate{}, turn{};
    for (int step = 0; step < static_cast<int>(std::lround(4.0f / step_s)); ++step) {
      curves.Follow(step, targets);
      MoveJoints<1>(bones, targets, step_s, angle, rate, turn);
    }
    return static_cast<double>(angle[0][0]);
  };
  const double fine = end_of(0.000625f);
  const double errors[] = {std::abs(end_of(0.04f) - fine), std::abs(end_of(0.02f) - fine),
                           std::abs(end_of(0.01f) - fine)};
  CAPTURE(errors[0], errors[1], errors[2]);
  CHECK(errors[2] < 1e-3);
  CHECK(std::log2(errors[0] / errors[1]) > 1.7);
  CHECK(std::log2(errors[1] / errors[2]) > 1.7);
}

TEST_CASE("trajectory: with equal knots it does what one rule does", "[control][trajectory]") {
  Document d = OnCurves(CurveEnd::kRepeat, 1);
  const CurveShape shape(d.rules, d.figure.Rods());
  const int joints = shape.joints;
  std::vector<float> pose;
  const Skeleton bones(d.figure);
  for (int joint = 0; joint < joints; ++joint) {
    const Gene gene = static_cast<Gene>(9000 + 11000 * joint);
    for (int knot = 0; knot < d.rules; ++knot) d.controllers[0].genes[shape.Angle(knot, joint)] = gene;
    const Skeleton::Limb& limb = bones.limbs[static_cast<std::size_t>(joint) + 1];
    pose.push_back(Decode(gene, limb.min_rad, limb.max_rad));
  }
  Document rule = d;
  rule.controllers = {HoldPose(d.figure, pose, d.senses.tau_min_s)};
  const Motion curves = Simulate(d), one = Simulate(rule);
  for (const int frame : {10, 50, 100}) {
    for (int joint = 0; joint < joints; ++joint)
      CHECK(std::abs(curves.AngleRad(frame, joint) - one.AngleRad(frame, joint)) < 1e-4f);
  }
}

TEST_CASE("trajectory: figures of both models rest at the end of curves that rest", "[control][trajectory]") {
  for (const int model : {1, 2}) {
    Document d = OnCurves(CurveEnd::kRest, 4);
    d.model = model;
    for (Rod& rod : d.figure.rods) rod.strength = 1000.0f;  // weak joints could not follow
    d.environment.gravity_mps2 = 0.0f;
    d.start.drop_height_m = 5.0f;
    const Motion motion = Simulate(d);
    const Skeleton& bones = motion.Bones();
    for (int joint = 0; joint < bones.joints; ++joint) {
      CAPTURE(model, joint);
      CHECK(std::abs(static_cast<double>(motion.AngleRad(400, joint)) - CurveOf(d, bones, joint, 400)) <
            0.01);
      CHECK(std::abs(motion.AngleRad(400, joint) - motion.AngleRad(350, joint)) < 1e-3f);
    }
    CHECK(motion.At(0).rule == 0);
    CHECK(motion.At(400).rule == d.rules - 1);
  }
}

TEST_CASE("trajectory: every number of lanes has the bits of the recorded motion", "[control][trajectory]") {
  for (const CurveEnd at_end : {CurveEnd::kRepeat, CurveEnd::kRest}) {
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
      const Document d = OnCurves(at_end, seed);
      for (const int lanes : {1, 2, 4, 8}) {
        const auto scored = Evaluator(ReplayProblem(d, d.controllers[0]), lanes, true)
                                .Evaluate(std::vector<Genome>(3, d.controllers[0].genes));
        CHECK(scored[2].trajectory_hash == Simulate(d).Hash());
      }
    }
  }
}

TEST_CASE("trajectory: its mirror image moves the mirrored figure the other way", "[control][trajectory]") {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const Document d = OnCurves(CurveEnd::kRepeat, seed);
    const auto image = MirrorImageOf(d.controllers[0], d.figure);
    REQUIRE(image);
    Document other = d;
    other.controllers = {*image};
    const Motion right = Simulate(d), left = Simulate(other);
    // Rounding differs, and contacts let it grow.
    for (int frame = 0; frame <= 60; ++frame)
      CHECK(std::abs(right.At(frame).x_m + left.At(frame).x_m) < 1e-3);
    const auto back = MirrorImageOf(*image, d.figure);
    REQUIRE(back);
    CHECK(back->genes == d.controllers[0].genes);
  }
}

TEST_CASE("trajectory: documents, links and errors", "[control][trajectory][document]") {
  const Document d = OnCurves(CurveEnd::kRest, 9);
  const auto json = DecodeJson(EncodeJson(d));
  REQUIRE(json);
  CHECK(json->controllers[0].kind == ControllerKind::kTrajectory);
  CHECK(json->controllers[0].senses == d.controllers[0].senses);
  CHECK(json->controllers[0].genes == d.controllers[0].genes);
  const auto link = DecodeLink(EncodeLink(d));
  REQUIRE(link);
  CHECK(Simulate(*link).Hash() == Simulate(d).Hash());
  Document wrong = d;
  wrong.controllers[0].senses.kind = SenseKind::kPhysical;
  const auto refused = Validate(wrong);
  REQUIRE_FALSE(refused);
  CHECK(refused.error().where == "controllers[0].kind");
  CHECK(refused.error().what == "a trajectory follows a timer and has no other senses");
  wrong = d;
  wrong.controllers[0].genes.pop_back();
  CHECK_FALSE(Validate(wrong));
}

TEST_CASE("trajectory: every search works with it, and improves", "[search][trajectory]") {
  for (std::size_t i = 0; i < kAlgorithmNames.size(); ++i) {
    Document d = OnCurves(CurveEnd::kRepeat, 1);
    d.controllers.clear();
    d.timeline.clear();
    d.task.duration_steps = 200;
    d.search.algorithm = static_cast<Algorithm>(i);
    d.search.evaluations = 600;
    d.search.population = 10;
    d.search.genetic.population = 40;
    d.search.torus.side = 5;
    d.search.elites.initial = 100;
    d.search.two_stage = {.random = 200, .kept = 3};
    CAPTURE(kAlgorithmNames[i]);
    REQUIRE(Validate(d));
    const Outcome first = RunSearchOf(d);
    CHECK(first.fitness > 0.5f);
    CHECK(RunSearchOf(d).best == first.best);
  }
}

TEST_CASE("recording: a trajectory is recorded as itself, and more knots fit a motion of rules better",
          "[trajectory][recording]") {
  Document once = OnCurves(CurveEnd::kRest, 2);
  once.duration_steps = kPeriod;
  once.senses.tau_min_s = once.controllers[0].senses.tau_min_s = 0.02f;
  const auto same = RecordAsCurves(once, once.rules);
  REQUIRE(same);
  CHECK(same->typical_rad < 1e-4);
  for (std::size_t i = 0; i < once.controllers[0].genes.size(); ++i)
    CHECK(std::abs(same->document.controllers[0].genes[i] - once.controllers[0].genes[i]) <= 3);

  Document rules = StarManTravel(SenseKind::kPhysical);
  rules.controllers = {RandomController(rules.figure, rules.senses, 7)};
  rules.timeline = {{0, 0}};
  rules.duration_steps = 500;
  double before = 1e9;
  for (const int knots : {2, 4, 8, 16, 32}) {
    const auto recording = RecordAsCurves(rules, knots);
    REQUIRE(recording);
    REQUIRE(Validate(recording->document));
    CHECK(recording->typical_rad <= before + 1e-4);
    CHECK(recording->typical_rad <= recording->worst_rad);
    before = recording->typical_rad;
    // Its joints do what it says.
    const Motion was = Simulate(rules), is = Simulate(recording->document);
    double squares = 0.0;
    for (int frame = 100; frame <= 500; ++frame) {
      for (int joint = 0; joint < was.Bones().joints; ++joint) {
        const double off = static_cast<double>(was.AngleRad(frame, joint) - is.AngleRad(frame, joint));
        squares += off * off;
      }
    }
    CHECK(std::sqrt(squares / (401.0 * was.Bones().joints)) < 1.2 * recording->typical_rad + 0.02);
  }
  CHECK(before < 0.05);
  rules.controllers.clear();
  rules.timeline.clear();
  CHECK_FALSE(RecordAsCurves(rules, 8));
}

}  // namespace gaitsmith::test
