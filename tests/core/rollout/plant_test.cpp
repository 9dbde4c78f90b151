// SPDX-License-Identifier: MIT
// The interface between controllers and plants. A second plant obeys its own laws, and runs through
// evaluators, motions, beginnings, transition maps and searches without special code. A document's model is
// used wherever its motion is simulated.
#include <algorithm>
#include <array>
#include <catch_amalgamated.hpp>
#include <cmath>
#include <memory>

#include "core/document/composite.h"
#include "core/document/transition.h"
#include "core/rollout/batch_evaluator.h"
#include "core/rollout/evaluator.h"
#include "core/rollout/moment_scorer.h"
#include "core/rollout/motion_recorder.h"
#include "core/rollout/transition_map.h"
#include "core/search/search.h"
#include "tests/muscle_pair.h"
#include "tests/scene.h"

namespace gaitsmith::test {

namespace {

static_assert(Plant<MusclePair<1>> && Plant<MusclePair<4>> && Plant<MusclePair<16>>);

Problem Crawling(SenseKind senses) {
  Problem problem;
  problem.figure = LyingRod();
  problem.task.kind = TaskKind::kTravelRight;
  problem.task.duration_steps = 400;
  problem.task.weights = {0.0f, -0.01f, 0.0f, 0.02f, 0.0f, 0.001f, 0.0f};
  problem.senses.kind = senses;
  problem.rules = 4;
  problem.pushes = {{.step = 50, .endpoint = 1, .impulse_x_ns = 0.4f}, {.step = 210, .impulse_x_ns = -0.3f}};
  return problem;
}

ControllerShape ShapeOf(const Problem& problem) {
  return problem.ShapeFor(MusclePair<1>::CountPorts(problem.figure));
}

Genome RandomCrawler(const Problem& problem, std::uint64_t seed) {
  RandomStream random(seed, 0, 0);
  return RandomGenome(ShapeOf(problem), problem.senses, Variation{}, random);
}

Controller CrawlerOf(const Problem& problem, std::uint64_t seed) {
  return {.name = {},
          .kind = problem.kind,
          .senses = problem.senses,
          .rules = problem.rules,
          .genes = RandomCrawler(problem, seed)};
}

Script ScriptOf(const Problem& problem, std::span<const Controller> controllers, std::span<const Clip> clips,
                int steps) {
  return {.figure = problem.figure,
          .environment = problem.environment,
          .start = problem.start,
          .pushes = problem.pushes,
          .controllers = controllers,
          .clips = clips,
          .steps = steps};
}

std::unique_ptr<MotionRecorder> Recorder() { return std::make_unique<PlantRecorder<MusclePair>>(); }

template <int W>
Evaluator EvaluatorOf(const Problem& problem) {
  return Evaluator(std::make_shared<PlantEvaluator<MusclePair, W>>(problem, true));
}

/// Compares everything in two motions, bit by bit.
bool Same(const Motion& a, const Motion& b) {
  if (a.Hash() != b.Hash() || a.Frames() != b.Frames()) return false;
  for (int i = 0; i < a.Frames(); ++i) {
    const Motion::Frame &x = a.At(i), &y = b.At(i);
    if (x.x_m != y.x_m || x.velocity_x_mps != y.velocity_x_mps || x.clip != y.clip || x.rule != y.rule)
      return false;
    if (a.AngleRad(i, 0) != b.AngleRad(i, 0) || a.RateRadps(i, 0) != b.RateRadps(i, 0)) return false;
    for (int k = 0; k < 2; ++k) {
      if (a.Endpoint(i, k).x != b.Endpoint(i, k).x || a.Force(i, k).x != b.Force(i, k).x) return false;
    }
    for (int sense = 0; sense < 5; ++sense) {
      if (a.Sense(i, sense) != b.Sense(i, sense)) return false;
    }
    if (a.TermsAt(i).effort_rad != b.TermsAt(i).effort_rad ||
        a.TermsAt(i).slip_sum_m != b.TermsAt(i).slip_sum_m)
      return false;
  }
  return true;
}

}  // namespace

TEST_CASE("plant: a muscle without friction leaves the pair's momentum alone", "[plant]") {
  Problem problem = Crawling(SenseKind::kTimer);
  problem.environment.friction = 0.0f;
  problem.start.velocity_x_mps = 0.7f;
  problem.pushes = {};
  const std::array controllers = {CrawlerOf(problem, 3)};
  const std::array clips = {Clip{}};
  const Motion motion(Recorder(), ScriptOf(problem, controllers, clips, 800));
  float least = motion.AngleRad(0, 0), most = least;
  for (int i = 0; i < motion.Frames(); ++i) {
    REQUIRE(motion.At(i).velocity_x_mps == 0.7f);
    // The centre of mass is between the masses, where their moments cancel.
    const double start = static_cast<double>(motion.Endpoint(i, 0).x);
    const double end = static_cast<double>(motion.Endpoint(i, 1).x);
    REQUIRE(std::abs(start / 3.0 + end * (2.0 / 3.0)) < 1e-6);
    REQUIRE(std::abs(end - start - static_cast<double>(motion.AngleRad(i, 0))) < 1e-6);
    least = std::min(least, motion.AngleRad(i, 0));
    most = std::max(most, motion.AngleRad(i, 0));
  }
  CHECK(most - least > 0.1f);
  CHECK(std::abs(motion.At(800).x_m - 5.6) < 1e-4);
}

TEST_CASE("plant: what rests stays at rest, and what slides stops where friction stops it", "[plant]") {
  Problem problem = Crawling(SenseKind::kTimer);
  problem.pushes = {};
  const Motion still(Recorder(), ScriptOf(problem, {}, {}, 300));
  for (int i = 0; i < still.Frames(); ++i) {
    REQUIRE(still.At(i).x_m == 0.0);
    REQUIRE(still.AngleRad(i, 0) == still.AngleRad(0, 0));
  }
  problem.start.velocity_x_mps = 2.0f;
  const Motion sliding(Recorder(), ScriptOf(problem, {}, {}, 300));
  // v^2 / (2 mu g) = 0.2551 m, within half a step's path.
  CHECK(std::abs(sliding.At(300).x_m - 4.0 / (2.0 * 0.8 * 9.8)) < 0.5 * 0.01 * 2.0 + 1e-3);
  CHECK(std::abs(sliding.At(300).velocity_x_mps) < 1e-6f);
  // A force inside the friction cone of each mass moves neither.
  problem.start.velocity_x_mps = 0.0f;
  problem.environment.slope_rad = 0.6f;
  const Motion held(Recorder(), ScriptOf(problem, {}, {}, 300));
  CHECK(std::abs(held.At(300).x_m) < 1e-6);
  problem.environment.friction = 0.6f;
  const Motion slipping(Recorder(), ScriptOf(problem, {}, {}, 300));
  const double expected = -0.5 * 9.8 * (std::sin(0.6) - 0.6 * std::cos(0.6)) * 9.0;
  CHECK(std::abs(slipping.At(300).x_m - expected) < 0.01 * std::abs(expected));
}

TEST_CASE("plant: every number of lanes has the bits of one, and those of the recorded motion",
          "[plant][determinism]") {
  for (const SenseKind senses : {SenseKind::kPhysical, SenseKind::kTimer}) {
    for (const ControllerKind kind :
         {ControllerKind::kRules, ControllerKind::kNetwork, ControllerKind::kTrajectory}) {
      Problem problem = Crawling(senses);
      problem.kind = kind;
      std::vector<Genome> genomes;
      genomes.reserve(21);
      for (std::uint64_t seed = 0; seed < 21; ++seed) genomes.push_back(RandomCrawler(problem, seed));
      const auto one = EvaluatorOf<1>(problem).Evaluate(genomes);
      std::vector<std::uint64_t> hashes;
      for (const Evaluator& wide : {EvaluatorOf<2>(problem), EvaluatorOf<4>(problem), EvaluatorOf<8>(problem),
                                    EvaluatorOf<16>(problem)}) {
        const auto many = wide.Evaluate(genomes);
        for (std::size_t i = 0; i < genomes.size(); ++i) {
          CAPTURE(i);
          REQUIRE(many[i].trajectory_hash == one[i].trajectory_hash);
          REQUIRE(many[i].fitness == one[i].fitness);
        }
      }
      for (std::size_t seed = 0; seed < genomes.size(); ++seed) {
        const std::array controllers = {CrawlerOf(problem, seed)};
        const std::array clips = {Clip{}};
        const Motion motion(Recorder(), ScriptOf(problem, controllers, clips, 400));
        CHECK(motion.Hash() == one[seed].trajectory_hash);
        CHECK(Fitness(problem.task, motion.TermsAt(400)) == one[seed].fitness);
        hashes.push_back(motion.Hash());
      }
      std::ranges::sort(hashes);
      CHECK(std::ranges::unique(hashes).begin() - hashes.begin() > 10);
    }
  }
}

TEST_CASE("plant: a controller that takes over goes on as the composite motion does", "[plant]") {
  Problem problem = Crawling(SenseKind::kPhysical);
  const std::array controllers = {CrawlerOf(problem, 5), CrawlerOf(problem, 8)};
  constexpr int kSwitch = 137;
  const std::array clips = {Clip{.controller = 0, .start_step = 0},
                            Clip{.controller = 1, .start_step = kSwitch}};
  const Motion motion(Recorder(), ScriptOf(problem, controllers, clips, kSwitch + 400));
  problem.beginnings = {{.controllers = {controllers[0]}, .clips = {clips[0]}, .steps = kSwitch}};
  const auto found = EvaluatorOf<4>(problem).Evaluate(std::vector<Genome>{controllers[1].genes});
  const double way = motion.At(kSwitch + 400).x_m - motion.At(kSwitch).x_m;
  CHECK(std::abs(static_cast<double>(found[0].terms.travel_m) - way) < 1e-6);
  CHECK(std::abs(way) > 1e-3);

  // A restored moment of the motion continues with the same bits.
  const MuscleBody body(problem.figure);
  const auto takeovers = DecodeClips(clips, controllers, MusclePair<1>::PortsOf(body), kStep);
  const auto begin = [&] {
    return Rollout<MusclePair, 1>(body, problem.environment, problem.start, problem.pushes, takeovers);
  };
  const auto end_of = [&](Rollout<MusclePair, 1> rollout) {
    TrajectoryHash hash;
    rollout.RunTo(500, kNothing, [&] { rollout.PlantNow().AddTo(hash, 0); });
    return hash.Value();
  };
  for (const int step : {0, 1, 50, 51, kSwitch, kSwitch + 1, 210, 211, 480}) {
    CAPTURE(step);
    Rollout<MusclePair, 1> going = begin();
    going.RunTo(step, kNothing, kNothing);
    const Moment<MusclePair, 1> moment = going.Save();
    Rollout<MusclePair, 1> restored = begin();
    restored.RunTo(321, kNothing, kNothing);
    restored.Restore(moment);
    CHECK(end_of(restored) == end_of(going));
  }
}

TEST_CASE("plant: with several beginnings the mean counts", "[plant]") {
  Problem problem = Crawling(SenseKind::kPhysical);
  const std::vector<Genome> genomes = {RandomCrawler(problem, 2), RandomCrawler(problem, 8)};
  const std::array<Beginning, 2> each = {
      Beginning{}, Beginning{.controllers = {CrawlerOf(problem, 5)}, .clips = {{}}, .steps = 90}};
  std::array<double, 2> sum{};
  for (const Beginning& beginning : each) {
    problem.beginnings = {beginning};
    const auto found = EvaluatorOf<4>(problem).Evaluate(genomes);
    for (std::size_t i = 0; i < 2; ++i) sum[i] += static_cast<double>(found[i].fitness);
  }
  problem.beginnings = {each[0], each[1]};
  const auto mean = EvaluatorOf<2>(problem).Evaluate(genomes);
  for (std::size_t i = 0; i < 2; ++i)
    CHECK(std::abs(static_cast<double>(mean[i].fitness) - 0.5 * sum[i]) < 1e-6);
}

TEST_CASE("plant: a motion that goes on from another one's checkpoints has the bits of a fresh one",
          "[plant]") {
  const Problem problem = Crawling(SenseKind::kPhysical);
  const std::array controllers = {CrawlerOf(problem, 5), CrawlerOf(problem, 8), CrawlerOf(problem, 9)};
  const std::array first = {Clip{.controller = 0, .start_step = 0}, Clip{.controller = 1, .start_step = 220}};
  const std::array then = {Clip{.controller = 0, .start_step = 0}, Clip{.controller = 2, .start_step = 220}};
  const Script before = ScriptOf(problem, controllers, first, 700);
  const Script after = ScriptOf(problem, controllers, then, 650);
  const Motion fresh(Recorder(), after);
  CHECK_FALSE(Same(fresh, Motion(Recorder(), before)));
  for (const int parting : {0, 99, 100, 200, 220}) {
    CAPTURE(parting);
    CHECK(Same(Motion(Motion(Recorder(), before), parting, Recorder(), after), fresh));
  }
  // The part before the parting step is reused: a parting that is too late keeps the motion of the old clips.
  CHECK_FALSE(Same(Motion(Motion(Recorder(), before), 400, Recorder(), after), fresh));
}

TEST_CASE("plant: nothing is taken from a motion of another model", "[plant]") {
  Problem problem = Crawling(SenseKind::kPhysical);
  const Script script = ScriptOf(problem, {}, {}, 400);
  const auto by_figure = [&] { return Motion(script); };
  const auto by_muscle = [&] { return Motion(Recorder(), script); };
  REQUIRE(by_figure().Hash() != by_muscle().Hash());
  const Motion muscle(by_figure(), 350, Recorder(), script);
  CHECK(Same(muscle, by_muscle()));
  const Motion figure(by_muscle(), 350, script);
  CHECK(figure.Hash() == by_figure().Hash());
  CHECK(figure.At(200).x_m == by_figure().At(200).x_m);
}

TEST_CASE("plant: a transition map scores as an evaluator does that begins there", "[plant]") {
  Problem problem = Crawling(SenseKind::kPhysical);
  const Genome taking = RandomCrawler(problem, 8);
  const std::vector<int> steps = {20, 55, 90, 137, 200, 211};
  problem.beginnings = {{.controllers = {CrawlerOf(problem, 5)}, .clips = {{}}, .steps = 0}};
  const TransitionMap map(std::make_shared<PlantMomentScorer<MusclePair>>(problem, taking, steps),
                          static_cast<int>(steps.size()));
  const auto order = CoarseFirst(map.Count());
  const auto scores = map.Scores(0, map.Count());
  const std::vector<Genome> genomes = {taking};
  for (std::size_t place = 0; place < steps.size(); ++place) {
    Problem one = problem;
    one.beginnings[0].steps = steps[static_cast<std::size_t>(order[place])];
    CHECK(scores[place] == EvaluatorOf<4>(one).Evaluate(genomes)[0].fitness);
  }
  CHECK(map.Scores(3, 2) == std::vector(scores.begin() + 3, scores.begin() + 5));
  problem.beginnings = {};
  problem.pushes = {};
  CHECK(map.UsualScore() == EvaluatorOf<4>(problem).Evaluate(genomes)[0].fitness);
}

TEST_CASE("plant: a search finds a crawler", "[plant]") {
  Problem problem = Crawling(SenseKind::kTimer);
  problem.pushes = {};
  SearchSettings settings;
  settings.evaluations = 600;
  const auto search = MakeSearch(settings, SearchSpace{ShapeOf(problem), problem.senses});
  const Evaluator evaluator = EvaluatorOf<4>(problem);
  float best_of_first = 0.0f;
  while (!search->Done()) {
    const bool first = search->Evaluations() == 0;
    std::vector<float> fitness;
    for (const Evaluation& one : evaluator.Evaluate(search->Ask(40))) fitness.push_back(one.fitness);
    if (first) best_of_first = std::ranges::max(fitness);
    search->Tell(fitness);
  }
  CHECK(search->BestFitness() > 0.1f);
  CHECK(search->BestFitness() > best_of_first);
}

TEST_CASE("model: it goes wherever a document's motion is simulated", "[plant][document]") {
  Document d = TwoClips();
  d.model = 7;  // a model that only a later Gaitsmith has
  CHECK(ProblemOf(d).model == 7);
  CHECK(ReplayProblem(d, d.controllers[0]).model == 7);
  CHECK(ScriptOf(d).model == 7);
  CHECK(TransitionRequest(d, 1).model == 7);
  Document same = d, other = d;
  other.model = 1;
  CHECK(PartingStep(d, same) == kMaxSteps);
  CHECK(PartingStep(d, other) == 0);
  CHECK_FALSE(Validate(d));
}

}  // namespace gaitsmith::test
