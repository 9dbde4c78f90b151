// SPDX-License-Identifier: MIT
// What a figure is shown: compared with closed forms, equal in the evaluator and in the recorded motion,
// refused when it does not fit, and met by a search.
#include <catch_amalgamated.hpp>
#include <cmath>

#include "core/document/binary.h"
#include "core/document/json.h"
#include "core/document/link.h"
#include "core/document/standing.h"
#include "core/rollout/evaluator.h"
#include "core/search/operators.h"
#include "tests/scene.h"
#include "tests/search_run.h"

namespace gaitsmith::test {

namespace {

Demonstration WayOf(std::vector<WayPoint> way) {
  Demonstration shown;
  shown.way = std::move(way);
  return shown;
}

Document Taught() {
  Document d = Standing(ShippedFigure("mr-star-man"));
  d.task.duration_steps = d.duration_steps = 200;
  d.task.shown.way = {{0, 0.0f, 1.0f}, {100, 2.0f, 1.5f}, {200, 3.0f, 1.0f}};
  d.task.weights[static_cast<std::size_t>(StyleTerm::kOnWay)] = 10.0f;
  d.task.weights[static_cast<std::size_t>(StyleTerm::kInPose)] = 20.0f;
  d.task.shown.pose_step = 120;
  d.task.shown.pose_turn_rad = 2.0f;
  d.task.shown.pose_rad.assign(static_cast<std::size_t>(d.figure.Joints()), 0.25f);
  return d;
}

}  // namespace

TEST_CASE("demonstration: a way is straight between its points", "[task][shown]") {
  const Demonstration shown = WayOf({{10, 1.0f, 2.0f}, {20, 3.0f, 1.0f}, {40, 3.0f, 5.0f}});
  using Place = std::array<double, 2>;
  CHECK(shown.WayAt(10) == Place{1.0, 2.0});
  CHECK(shown.WayAt(15) == Place{2.0, 1.5});
  CHECK(shown.WayAt(20) == Place{3.0, 1.0});
  CHECK(shown.WayAt(30) == Place{3.0, 3.0});
  CHECK(shown.WayAt(40) == Place{3.0, 5.0});
  CHECK(WayOf({{7, 1.0f, 2.0f}}).WayAt(7) == Place{1.0, 2.0});
}

TEST_CASE(
    "demonstration: a thrown figure is on the parabola of its centre, and as far beside it as it is moved",
    "[task][shown]") {
  StartState start;
  start.drop_height_m = 60.0f;
  start.velocity_x_mps = 2.0f;
  start.spin_radps = 3.0f;
  Motion motion = MotionOf(ShippedFigure("mr-star-man"), Environment{}, start, {}, {}, {}, 150);
  for (const float beside : {0.0f, 0.75f}) {
    Demonstration shown;
    shown.way.reserve(31);
    for (int step = 0; step <= 150; step += 5) {
      const Motion::Frame& frame = motion.At(step);
      shown.way.push_back({step, static_cast<float>(frame.x_m) + beside, frame.y_m});
    }
    motion.MeasureAgainst(shown);
    // Straight pieces of 0.05 s miss the parabola by at most g t^2 / 8.
    CHECK(AtEnd(motion).on_way_m == Catch::Approx(-beside).margin(9.8f * 0.05f * 0.05f / 8.0f));
    CHECK(AtEnd(motion).in_pose_rad == 0.0f);
  }
}

TEST_CASE("demonstration: the pose is measured at its moment alone, without whole turns", "[task][shown]") {
  StartState start;
  start.drop_height_m = 60.0f;
  start.spin_radps = 9.0f;
  Motion motion = MotionOf(ShippedFigure("mr-star-man"), Environment{}, start, {}, {}, {}, 150);
  const auto joints = static_cast<std::size_t>(motion.Bones().joints);
  Demonstration shown;
  shown.pose_step = 130;
  shown.pose_rad.reserve(joints);
  for (std::size_t j = 0; j < joints; ++j)
    shown.pose_rad.push_back(motion.AngleRad(130, static_cast<int>(j)));
  for (const double turns : {0.0, 1.0, -3.0}) {
    shown.pose_turn_rad = static_cast<float>(motion.At(130).turn_rad + turns * 2.0 * 3.14159265358979);
    motion.MeasureAgainst(shown);
    CHECK(motion.TermsAt(129).in_pose_rad == 0.0f);
    CHECK(motion.TermsAt(130).in_pose_rad == Catch::Approx(0.0f).margin(1e-4));
  }
  shown.pose_rad[0] += 0.5f;
  shown.pose_turn_rad += 3.0f;
  motion.MeasureAgainst(shown);
  CHECK(AtEnd(motion).in_pose_rad == Catch::Approx(-3.5f / static_cast<float>(joints + 1)).margin(1e-3));
}

TEST_CASE("demonstration: the evaluator measures what the recorded motion does, in all lanes",
          "[task][shown][lanes]") {
  Document d = Taught();
  d.model = GENERATE(1, 2);
  const Problem problem = ProblemOf(d);
  const Evaluator evaluator(problem);
  RandomStream random(7, 0, 0);
  std::vector<Genome> genomes;
  genomes.reserve(9);
  for (int i = 0; i < 9; ++i)
    genomes.push_back(RandomGenome(problem.Shape(), d.senses, d.search.variation, random));
  const std::vector<Evaluation> all = evaluator.Evaluate(genomes);
  for (std::size_t i = 0; i < genomes.size(); ++i) {
    Document one = d;
    one.controllers = {{"", d.kind, d.senses, d.rules, genomes[i]}};
    one.timeline = {{0, 0}};
    const Terms terms = AtEnd(Simulate(one));
    CAPTURE(i);
    CHECK(all[i].terms.on_way_m == terms.on_way_m);
    CHECK(all[i].terms.in_pose_rad == terms.in_pose_rad);
    CHECK(all[i].fitness == Fitness(d.task, terms));
    CHECK(terms.on_way_m < 0.0f);
    CHECK(terms.in_pose_rad < 0.0f);
  }
}

TEST_CASE("demonstration: files and links keep it, and documents without one are written as before",
          "[document][shown]") {
  const Document d = Taught();
  const auto from_json = DecodeJson(EncodeJson(d));
  REQUIRE(from_json);
  CHECK(from_json->task.shown == d.task.shown);
  const auto from_link = DecodeLink(EncodeLink(d));
  REQUIRE(from_link);
  CHECK(from_link->task.shown == d.task.shown);
  CHECK(EncodeBinary(d)[0] == 6);
  Document plain = d;
  ForgetShown(plain.task);
  CHECK(EncodeBinary(plain)[0] < 6);
  CHECK(EncodeJson(plain).find("shown") == std::string::npos);
}

TEST_CASE("demonstration: what does not fit is refused with its place", "[document][shown]") {
  const auto where = [](const auto& edit) {
    Document d = Taught();
    edit(d.task.shown);
    const auto valid = Validate(d);
    REQUIRE(!valid);
    return valid.error().where;
  };
  CHECK(where([](Demonstration& s) { s.way[2].step = 100; }) == "task.shown.way[2].step");
  CHECK(where([](Demonstration& s) { s.way[1].x_m = NAN; }) == "task.shown.way[1].x_m");
  CHECK(where([](Demonstration& s) { s.way.resize(kMaxWayPoints + 1); }) == "task.shown.way");
  CHECK(where([](Demonstration& s) { s.pose_rad.pop_back(); }) == "task.shown.pose");
  CHECK(where([](Demonstration& s) { s.pose_step = 0; }) == "task.shown.pose_step");
}

TEST_CASE("demonstration: a search comes closer to a way and to a pose than one that was shown nothing",
          "[search][shown]") {
  Document d = Taught();
  d.search.algorithm = Algorithm::kSphc;
  d.search.evaluations = 600;
  d.task.shown.way = {{0, 0.0f, 1.2f}, {200, -1.5f, 1.2f}};
  const auto found = [&](StyleTerm taught, std::uint32_t seed) {
    Document one = d;
    one.search.seed = seed;
    for (const StyleTerm term : {StyleTerm::kOnWay, StyleTerm::kInPose}) {
      if (term != taught) one.task.weights[static_cast<std::size_t>(term)] = 0.0f;
    }
    one.controllers = {{"", d.kind, d.senses, d.rules, RunSearchOf(one).best}};
    one.timeline = {{0, 0}};
    return AtEnd(Simulate(one));
  };
  for (std::uint32_t seed = 1; seed <= 3; ++seed) {
    const Terms free = found(StyleTerm::kEffort, seed);
    const Terms led = found(StyleTerm::kOnWay, seed), posed = found(StyleTerm::kInPose, seed);
    CAPTURE(seed, free.on_way_m, free.in_pose_rad);
    CHECK(led.on_way_m > 0.75f * free.on_way_m);
    CHECK(posed.in_pose_rad > 0.75f * free.in_pose_rad);
  }
}

}  // namespace gaitsmith::test
