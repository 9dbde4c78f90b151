// SPDX-License-Identifier: MIT
// Our own style terms: compared with closed forms, equal in the evaluator and in the recorded motion, and
// effective in searches.
#include <algorithm>
#include <catch_amalgamated.hpp>
#include <cmath>
#include <limits>

#include "core/document/binary.h"
#include "core/document/json.h"
#include "core/document/link.h"
#include "core/document/style_weights.h"
#include "core/numeric/scalar_math.h"
#include "core/physics/trajectory_hash.h"
#include "core/rollout/evaluator.h"
#include "core/search/evaluation_score.h"
#include "tests/scene.h"

namespace gaitsmith::test {

namespace {

constexpr std::size_t kFurther = kFreeTerms - kPaperTerms;

float Style(const Terms& terms, std::size_t term) { return terms.Style(static_cast<StyleTerm>(term)); }

Terms Last(const Motion& motion) { return motion.TermsAt(motion.Frames() - 1); }

/// A rod with a second rod at its end, whose joint may turn by one radian in both directions.
Figure TwoRods(float first_rad, float second_rad) {
  Rod first, second;
  first.rest_rad = first_rad;
  second.parent = 0;
  second.rest_rad = second_rad;
  return {"two rods", {first, second}};
}

}  // namespace

TEST_CASE("style: a resting figure makes no effort, is upright, smooth, and holds its head still",
          "[task][style]") {
  // A flat rod with an upright rod at its end: 0.8 m high.
  Rod flat, mast;
  flat.length_m = 2.0f;
  mast.parent = 0;
  mast.parent_end = RodEnd::kStart;
  mast.rest_rad = 1.5707964f;
  mast.length_m = 0.8f;
  const Motion motion = MotionOf({"mast", {flat, mast}}, Environment{}, StartState{}, {}, {}, {}, 500);
  for (const int frame : {0, 1, 500}) {
    const Terms& terms = motion.TermsAt(frame);
    CAPTURE(frame);
    CHECK(terms.effort_rad == 0.0f);
    CHECK(terms.smoothness_radps2 == 0.0f);
    CHECK(!std::signbit(terms.smoothness_radps2));
    CHECK(terms.upright == Catch::Approx(1.0f).margin(1e-6));
    CHECK(terms.head_height_m == Catch::Approx(0.8f).margin(1e-4));
  }
  CHECK(motion.TermsAt(0).upright == 1.0f);
  CHECK(motion.Bones().head == 2);
}

TEST_CASE("style: thrown and spinning in the air, upright is the mean of cos(wt)", "[task][style]") {
  StartState start;
  start.drop_height_m = 40.0f;
  start.velocity_y_mps = 3.0f;
  constexpr int kSteps = 150;
  for (const float spin : {0.5f, -2.0f, 3.1415927f, 9.0f}) {
    start.spin_radps = spin;
    const Motion motion = MotionOf(ShippedFigure("mr-star-man"), Environment{}, start, {}, {}, {}, kSteps);
    double upright = 0.0, head_m = 0.0;
    const Motion::Point head = motion.Endpoint(0, motion.Bones().head);
    for (int step = 1; step <= kSteps; ++step) {
      const double t = step * 0.01, turn = static_cast<double>(spin) * t;
      upright += std::cos(turn);
      // The head turns about the falling centre of mass.
      head_m += static_cast<double>(motion.At(0).y_m) + 3.0 * t - 0.5 * 9.8 * t * t +
                std::sin(turn) * static_cast<double>(head.x) + std::cos(turn) * static_cast<double>(head.y);
    }
    const Terms terms = Last(motion);
    CAPTURE(spin);
    CHECK(terms.upright == Catch::Approx(upright / kSteps).margin(2e-5));
    CHECK(terms.head_height_m == Catch::Approx(head_m / kSteps).margin(2e-4));
    CHECK(terms.effort_rad == 0.0f);
    CHECK(terms.smoothness_radps2 == 0.0f);
  }
}

TEST_CASE("style: while it hangs upside down, upright falls", "[task][style]") {
  StartState start;
  start.drop_height_m = 100.0f;
  start.spin_radps = 3.1415927f;
  const Motion motion = MotionOf(TwoRods(0.3f, 0.0f), Environment{}, start, {}, {}, {}, 300);
  // Between 0.5 s and 1.5 s the figure hangs upside down: the mean of cos there is -2/pi.
  const double until = 50.0 * static_cast<double>(motion.TermsAt(50).upright);
  const double after = 150.0 * static_cast<double>(motion.TermsAt(150).upright);
  CHECK((after - until) / 100.0 == Catch::Approx(-2.0 / kPi).margin(1e-3));
}

TEST_CASE("style: effort and smoothness of a joint that is driven to a pose", "[task][style]") {
  const Figure figure = TwoRods(0.0f, 0.5f);
  StartState start;
  start.drop_height_m = 50.0f;
  const float tau = 0.1f;
  const Controller hold = HoldPose(figure, {0.8f}, tau);
  const double target = -1.0 + 2.0 * hold.genes[BankShape(1, SenseKind::kPhysical, 2).Target(0, 0)] / 65535.0;
  const Motion motion =
      MotionOf(figure, Environment{}, start, {}, std::vector{hold}, std::vector<Clip>{{0, 0}}, 300);
  const Terms terms = Last(motion);
  // Critically damped from rest, the joint arrives without turning back: its travel is the distance.
  CHECK(terms.effort_rad == Catch::Approx(target).margin(1e-4));
  // Its rate rises to target / (e tau) once and returns to 0: twice this change in 3 s. Sampling misses a
  // peak between two steps by less than its curvature over half a step.
  const double peak = target / (std::exp(1.0) * static_cast<double>(tau));
  CHECK(terms.smoothness_radps2 == Catch::Approx(-2.0 * peak / 3.0).epsilon(2e-3));
  // The same terms from the recorded angles and rates, step by step.
  double effort = 0.0, change = 0.0;
  for (int i = 1; i < motion.Frames(); ++i) {
    effort +=
        std::abs(static_cast<double>(motion.AngleRad(i, 0)) - static_cast<double>(motion.AngleRad(i - 1, 0)));
    change += std::abs(static_cast<double>(motion.RateRadps(i, 0)) -
                       static_cast<double>(motion.RateRadps(i - 1, 0)));
  }
  CHECK(terms.effort_rad == Catch::Approx(effort).epsilon(1e-6));
  CHECK(terms.smoothness_radps2 == Catch::Approx(-change / 3.0).epsilon(1e-5));
}

TEST_CASE("style: every frame of every golden is what its recording says", "[task][style]") {
  for (const std::string& name : GoldenMotions()) {
    const auto document = DecodeJson(ReadFile(name));
    REQUIRE(document);
    const Motion motion = Simulate(*document);
    const Skeleton& bones = motion.Bones();
    double effort = 0.0, upright = 0.0, change = 0.0, head_m = 0.0;
    for (int i = 1; i < motion.Frames(); ++i) {
      for (int j = 0; j < bones.joints; ++j) {
        effort += std::abs(static_cast<double>(motion.AngleRad(i, j)) -
                           static_cast<double>(motion.AngleRad(i - 1, j)));
        change += std::abs(static_cast<double>(motion.RateRadps(i, j)) -
                           static_cast<double>(motion.RateRadps(i - 1, j)));
      }
      upright += std::cos(motion.At(i).turn_rad - static_cast<double>(bones.start_angle_rad));
      head_m += static_cast<double>(motion.At(i).y_m) + static_cast<double>(motion.Endpoint(i, bones.head).y);
      const Terms& terms = motion.TermsAt(i);
      CAPTURE(name, i);
      REQUIRE(terms.effort_rad == Catch::Approx(effort).epsilon(1e-5).margin(1e-6));
      REQUIRE(terms.upright == Catch::Approx(upright / i).margin(1e-6));
      REQUIRE(terms.head_height_m == Catch::Approx(head_m / i).epsilon(1e-5).margin(1e-5));
      const double seconds = i * 0.01 * std::max(1, bones.joints);
      REQUIRE(terms.smoothness_radps2 == Catch::Approx(-change / seconds).epsilon(1e-4).margin(1e-5));
    }
  }
}

TEST_CASE("style: the terms of the goldens have the same bits on every machine",
          "[task][style][golden][determinism]") {
  // A search that weights a term finds the same motion on every machine only if the term has the same bits on
  // every machine.
  TrajectoryHash hash;
  for (const std::string& name : GoldenMotions()) {
    const Motion motion = Simulate(DecodeJson(ReadFile(name)).value());
    for (int i = 0; i < motion.Frames(); ++i) {
      for (std::size_t term = 0; term < kFreeTerms; ++term) hash.Add(Style(motion.TermsAt(i), term));
    }
  }
  CHECK(HashText(hash.Value()) == "570daa8126cd6a97");
}

TEST_CASE("style: the head is the highest endpoint as drawn, of equals the first", "[figure][style]") {
  CHECK(Skeleton(LyingRod()).head == 0);
  // A V: both arms end at the same height, up to rounding.
  Rod left, right;
  left.rest_rad = 2.0f;
  right.parent = 0;
  right.parent_end = RodEnd::kStart;
  right.rest_rad = -0.858407f;
  CHECK(Skeleton({"V", {left, right}}).head == 1);
  right.length_m = 1.01f;
  CHECK(Skeleton({"V", {left, right}}).head == 2);
  // Drawn upside down, its tip is the head.
  left.rest_rad = -1.0f;
  CHECK(Skeleton({"V", {left, right}}).head == 0);
  CHECK(Skeleton(ShippedFigure("mr-star-man")).head == 1);
}

TEST_CASE("style: a figure of one rod has no joints to move", "[task][style]") {
  StartState start;
  start.velocity_x_mps = 2.0f;
  const Terms terms = Last(MotionOf(LyingRod(), Environment{}, start, {}, {}, {}, 100));
  CHECK(terms.effort_rad == 0.0f);
  CHECK(terms.smoothness_radps2 == 0.0f);
  CHECK(terms.upright == 1.0f);
  CHECK(terms.head_height_m == Catch::Approx(0.0f).margin(1e-3));
}

TEST_CASE("style: the evaluator's terms and fitness are the recorded motion's, to the bit, in every lane",
          "[task][style][determinism]") {
  for (const SenseKind kind : {SenseKind::kPhysical, SenseKind::kTimer}) {
    for (const char* name : {"mr-star-man", "horse"}) {
      Document d = StarManTravel(kind);
      d.figure = ShippedFigure(name);
      d.senses.tau_min_s = 0.07f;
      d.environment.slope_rad = 0.1f;
      std::vector<Genome> genomes;
      genomes.reserve(7);
      for (std::uint64_t i = 0; i < 7; ++i) genomes.push_back(RandomController(d.figure, d.senses, i).genes);
      // Each term alone, then all of them.
      for (std::size_t which = 0; which <= kFurther; ++which) {
        d.task.weights = {0.5f, -0.25f, 3.0f};
        for (std::size_t i = 0; i < kFurther; ++i) {
          if (which == i || which == kFurther) d.task.weights[kPaperTerms + i] = 0.37f;
        }
        const FurtherTerms weighted = WeightedFurtherTerms(d.task);
        std::vector<Terms> recorded;
        std::vector<std::uint64_t> hashes;
        for (const Genome& genome : genomes) {
          const Motion motion =
              MotionOf(d.figure, d.environment, {}, {},
                       std::vector{Controller{"", ControllerKind::kRules, d.senses, 10, genome}},
                       std::vector<Clip>{{0, 0}}, 500);
          recorded.push_back(Last(motion));
          hashes.push_back(motion.Hash());
        }
        for (const int lanes : Evaluator::kLaneCounts) {
          const auto found = Evaluator(ProblemOf(d), lanes, true).Evaluate(genomes);
          for (std::size_t i = 0; i < genomes.size(); ++i) {
            CAPTURE(name, which, lanes, i);
            REQUIRE(found[i].trajectory_hash == hashes[i]);
            REQUIRE(found[i].fitness == Fitness(d.task, recorded[i]));
            for (std::size_t term = 0; term < kStyleTerms; ++term) {
              const bool measured = term < kPaperTerms || weighted[term - kPaperTerms];
              REQUIRE(Style(found[i].terms, term) == (measured ? Style(recorded[i], term) : 0.0f));
            }
          }
        }
      }
    }
  }
}

TEST_CASE(
    "style: a further weight adds weight times term; a term that is no number is void only when weighed",
    "[task][style]") {
  Terms terms;
  terms.travel_m = 2.0f;
  terms.effort_rad = 40.0f;
  terms.upright = 0.5f;
  terms.smoothness_radps2 = -10.0f;
  terms.head_height_m = 1.5f;
  Task task;
  task.weights = {0.0f, 0.0f, 0.0f, -0.1f, 4.0f, 0.2f, 3.0f};
  CHECK(Fitness(task, terms) == Catch::Approx(2.0f - 4.0f + 2.0f - 2.0f + 4.5f));
  terms.upright = std::numeric_limits<float>::quiet_NaN();
  CHECK(Fitness(task, terms) == kVoidScore);
  task.weights[4] = 0.0f;
  CHECK(Fitness(task, terms) == Catch::Approx(2.0f - 4.0f - 2.0f + 4.5f));
  terms.broke_physics = true;
  CHECK(Fitness(task, terms) == kVoidScore);
}

TEST_CASE("style: a motion that broke physics stays void, whatever its weights promise", "[task][style]") {
  Document d = StarManTravel(SenseKind::kPhysical);
  d.pushes = {{0, 1, -60.0f, 0.0f}};  // until it turns at more than 50 rad/s
  d.start.spin_radps = 40.0f;
  d.start.drop_height_m = 50.0f;
  d.task.weights = {0.0f, 0.0f, 0.0f, 1000.0f, 1000.0f, -1000.0f, 1000.0f};
  const std::vector<Genome> genomes(5, RandomController(d.figure, d.senses, 1).genes);
  for (const Evaluation& one : Evaluator(ProblemOf(d)).Evaluate(genomes)) CHECK(one.fitness == kVoidScore);
}

TEST_CASE("style: MAP-Elites is told the paper's three terms", "[search][style]") {
  Evaluation evaluation;
  evaluation.fitness = 9.0f;
  evaluation.terms = {.max_cm_height_m = 1.0f, .slip_sum_m = 2.0f, .rotations = 3.0f, .effort_rad = 4.0f};
  const Score score = ScoreOf(evaluation);
  CHECK(score.fitness == 9.0f);
  CHECK(score.style == std::array{1.0f, 2.0f, 3.0f});
}

TEST_CASE("style: further weights travel in JSON and links, and cost a version only when set",
          "[document][style]") {
  Document plain = StarManTravel(SenseKind::kTimer);
  plain.task.weights = {1.0f, -2.0f, 3.5f};
  plain.hash = Simulate(plain).Hash();
  const std::string json = EncodeJson(plain);
  REQUIRE(EncodeBinary(plain)[0] == 1);
  for (std::size_t term = kPaperTerms; term < kFreeTerms; ++term) {
    const std::string name(kStyleTermNames[term]);
    CAPTURE(name);
    REQUIRE(json.find("\"" + name + "\"") == std::string::npos);
    Document d = plain;
    d.task.weights[term] = -0.125f;
    const auto bytes = EncodeBinary(d);
    REQUIRE(bytes[0] == 2);
    const auto from_binary = DecodeBinary(bytes);
    REQUIRE(from_binary);
    REQUIRE(from_binary->task.weights == d.task.weights);
    const std::string own = EncodeJson(d);
    REQUIRE(own.find("\"" + name + "\": -0.125") != std::string::npos);
    REQUIRE(own.size() < json.size() + 60);  // one more line: the other terms stay out
    const auto from_json = DecodeJson(own);
    REQUIRE(from_json);
    REQUIRE(EncodeBinary(*from_json) == bytes);
    const auto from_link = DecodeLink(EncodeLink(d));
    REQUIRE(from_link);
    REQUIRE(EncodeJson(*from_link) == own);
    // With the weight back at 0 the document is version 1 again, byte for byte.
    d.task.weights[term] = 0.0f;
    REQUIRE(EncodeBinary(d) == EncodeBinary(plain));
    REQUIRE(EncodeJson(d) == json);
  }
}

TEST_CASE("style: weights that cannot be are refused with their place", "[document][style]") {
  const auto fault = [](float weight) {
    Document d = StarManTravel(SenseKind::kTimer);
    d.task.weights[static_cast<std::size_t>(StyleTerm::kUpright)] = weight;
    const auto valid = Validate(d);
    return valid ? std::string("valid") : valid.error().Sentence();
  };
  CHECK(fault(1000.0f) == "valid");
  CHECK(fault(NAN) == "task.weights.upright: must be a finite number");
  CHECK(fault(INFINITY) == "task.weights.upright: must be a finite number");
  CHECK(fault(1001.0f) == "task.weights.upright: must be from -1000 to 1000, is 1001");
  const auto json_fault = [](const std::string& weights) {
    const auto document = DecodeJson(R"({"figure": {"rods": [{}]}, "task": {"weights": {)" + weights + "}}}");
    return document ? std::string("valid") : document.error().Sentence();
  };
  CHECK(json_fault(R"("effort": -0.5, "head_height": 2)") == "valid");
  CHECK(json_fault(R"("efort": 1)") == "task.weights.efort: there is no such field");
  CHECK(json_fault(R"("smoothness": -2000)") ==
        "task.weights.smoothness: must be from -1000 to 1000, is -2000");
  CHECK(json_fault(R"("upright": "much")").starts_with("task.weights.upright: must be a number"));
}

TEST_CASE("style: a search asked for more of a term finds more of it, for less finds less",
          "[search][style]") {
  const auto found = [](std::uint32_t seed, std::size_t term, float weight) {
    Document d = StarManTravel(SenseKind::kTimer);
    d.task.duration_steps = 200;
    // The figure lands turning, so that staying upright takes effort.
    d.start = {.drop_height_m = 1.0f, .spin_radps = 5.0f};
    d.search.seed = seed;
    d.search.evaluations = 400;
    d.task.weights[term] = weight;
    const Evaluator evaluator(ProblemOf(d));
    const auto search = MakeSearch(d.search, SpaceOf(d));
    while (!search->Done()) {
      std::vector<float> fitness;
      for (const Evaluation& one : evaluator.Evaluate(search->Ask(40))) fitness.push_back(one.fitness);
      search->Tell(fitness);
    }
    const Motion motion =
        MotionOf(d.figure, {}, d.start, {},
                 std::vector{Controller{"", ControllerKind::kRules, d.senses, 10, search->BestGenome()}},
                 std::vector<Clip>{{0, 0}}, 200);
    CHECK(Fitness(d.task, Last(motion)) == search->BestFitness());
    return Style(Last(motion), term);
  };
  constexpr std::array<float, kFurther> kWeights = {1.0f, 50.0f, 1.0f, 50.0f};
  for (std::uint32_t seed = 1; seed <= 3; ++seed) {
    for (std::size_t i = 0; i < kFurther; ++i) {
      const std::size_t term = kPaperTerms + i;
      const float none = found(seed, term, 0.0f);
      CAPTURE(seed, kStyleTermNames[term], none);
      CHECK(found(seed, term, kWeights[i]) > none);
      CHECK(found(seed, term, -kWeights[i]) < none);
    }
  }
}

TEST_CASE("style weights: by the figure's name up to a comma and its senses, and something for every figure",
          "[style]") {
  Document document;
  document.figure.name = "Mr. Star-Man, limber";
  document.senses.kind = SenseKind::kPhysical;
  const auto slip = static_cast<std::size_t>(StyleTerm::kSlipSum);
  REQUIRE(UsualWeights(document)[slip] == 0.6f);
  REQUIRE(GentleWeights(document)[slip] == 0.22f);
  document.senses.kind = SenseKind::kTimer;
  REQUIRE(UsualWeights(document)[slip] == 0.45f);
  REQUIRE(GentleWeights(document)[slip] == 0.37f);
  for (const char* name : {"", ",", "Mr. Star", "Mr. Star-Man", "Beryl Biped", "Five-Rod Fred"}) {
    for (const SenseKind senses : {SenseKind::kPhysical, SenseKind::kTimer}) {
      document.figure.name = name;
      document.senses.kind = senses;
      const StyleWeights usual = UsualWeights(document), gentle = GentleWeights(document);
      CAPTURE(name);
      for (std::size_t term = 0; term < usual.size(); ++term) {
        CAPTURE(kStyleTermNames[term]);
        REQUIRE(gentle[term] > 0.0f);
        REQUIRE(gentle[term] <= usual[term]);
        REQUIRE(gentle[term] > 0.05f * usual[term]);  // the Style panel's slider can reach it
      }
    }
  }
}

}  // namespace gaitsmith::test
