// SPDX-License-Identifier: MIT
#include "core/gait/closed_loop.h"

#include <algorithm>
#include <catch_amalgamated.hpp>
#include <cmath>

#include "core/document/json.h"
#include "core/gait/document_loop.h"
#include "tests/core/gait/walker.h"

namespace gaitsmith::test {

namespace {

double Farthest(const std::vector<WorldPoint>& one, const std::vector<WorldPoint>& other) {
  double most = 0.0;
  for (std::size_t k = 0; k < one.size(); ++k)
    most = std::max(most, std::hypot(one[k].x_m - other[k].x_m, one[k].y_m - other[k].y_m));
  return most;
}

/// Muscles are as long as their nodes are apart.
void CheckLengths(const Figure& figure, const Motion& loop) {
  int muscle = 0;
  for (const Spring& spring : figure.springs) {
    if (!spring.IsMuscle()) continue;
    const auto drawn_m = static_cast<double>(DrawnLength(figure, spring));
    for (int frame = 0; frame < loop.Frames(); ++frame) {
      const Motion::Point a = loop.Endpoint(frame, spring.from), b = loop.Endpoint(frame, spring.to);
      const auto length_m = static_cast<double>(std::hypot(b.x - a.x, b.y - a.y));
      CHECK(std::abs(length_m / drawn_m - static_cast<double>(loop.AngleRad(frame, muscle))) < 1e-5);
    }
    ++muscle;
  }
}

/// The greatest way of an endpoint in one step [m]; the last step leads back to the first frame.
double GreatestStep(const Skeleton& bones, const ClosedLoop& loop) {
  double most = 0.0;
  for (std::size_t i = 1; i < loop.frames.size(); ++i)
    most = std::max(most, Farthest(EndpointsOf(bones, loop.frames[i - 1].posture),
                                   EndpointsOf(bones, loop.frames[i].posture)));
  return most;
}

}  // namespace

TEST_CASE("loop: it ends as it begins, moved on by its way and its turns", "[gait]") {
  for (const Walker& walker :
       {Walker{.period_frames = 61.5}, Walker{.growth = 0.0005}, Walker{.turns_per_cycle = -1.0}}) {
    const Motion walk = Walk(walker, 700);
    const auto cycle = FindCycle(walk, 1, 699, false);
    REQUIRE(cycle);
    const ClosedLoop loop = CloseLoop(walk, *cycle);
    CHECK(loop.Steps() == std::lround(cycle->frames));
    CHECK(loop.seam_rods < 1e-12);
    CHECK(loop.turns == std::lround(walker.turns_per_cycle));
    // Feet of this walker slide, so that its way is the feet's only nearly.
    CHECK(std::abs(loop.distance_m - walker.speed_mps * walker.period_frames * 0.01) < 0.02);
    // Played again and again it nowhere moves much faster than it was recorded.
    double recorded = 0.0;
    for (int i = cycle->first; i < cycle->first + loop.Steps(); ++i) {
      recorded = std::max(recorded, Farthest(EndpointsOf(walk.Bones(), PostureAt(walk, i)),
                                             EndpointsOf(walk.Bones(), PostureAt(walk, i + 1))));
    }
    CHECK(GreatestStep(walk.Bones(), loop) < 1.1 * recorded);
  }
}

TEST_CASE("loop: the other half is the first with limbs exchanged", "[gait]") {
  const Motion walk = Walk({.limp = 0.1}, 500);
  const auto half = FindCycle(walk, 1, 499, true);
  REQUIRE(half);
  const ClosedLoop loop = CloseLoop(walk, *half);
  const LimbPairs pairs = LimbPairsOf(walk.Bones());
  REQUIRE(loop.Steps() % 2 == 0);
  const auto middle = static_cast<std::size_t>(loop.Steps()) / 2;
  for (std::size_t i = 0; i < middle; ++i) {
    const KinematicFrame &one = loop.frames[i], &other = loop.frames[i + middle];
    std::vector<WorldPoint> first = EndpointsOf(walk.Bones(), one.posture),
                            second = EndpointsOf(walk.Bones(), other.posture);
    double most = 0.0;
    for (std::size_t k = 0; k < first.size(); ++k) {
      const auto partner = static_cast<std::size_t>(pairs.endpoint[k]);
      most = std::max(most, std::hypot(second[k].x_m - first[partner].x_m - 0.5 * loop.distance_m,
                                       second[k].y_m - first[partner].y_m));
      CHECK(other.forces[k].y == one.forces[partner].y);
    }
    CHECK(most < 1e-9);
  }
  CHECK(loop.seam_rods < 1e-12);
}

TEST_CASE("loop: of shipped motions, as a motion that any exporter takes", "[gait]") {
  int loops = 0, of_springs = 0;
  for (const std::string& path : ShippedDocuments()) {
    INFO(path);
    const auto document = DecodeJson(ReadFile(path));
    REQUIRE(document);
    const Motion motion = Simulate(*document);
    const auto found = LoopOf(*document, motion, false);
    if (!found) {
      CHECK_FALSE(found.error().what.empty());
      continue;
    }
    ++loops;
    CHECK(found->loop.seam_rods < 1e-9);
    CHECK(found->loop.slide_rods <= kMostSeam);
    CHECK(found->loop.cycle.likeness >= kLeastLikeness);
    const Motion once = RecordLoop(*document, found->loop, false),
                 stays = RecordLoop(*document, found->loop, true);
    REQUIRE(once.Frames() == found->loop.Steps() + 1);
    CHECK(once.At(0).x_m == 0.0);
    CHECK(std::abs(once.At(once.Frames() - 1).x_m - found->loop.distance_m) < 1e-9);
    CHECK(std::abs(stays.At(stays.Frames() - 1).x_m) < 1e-9);
    const int last = once.Frames() - 1;
    for (int k = 0; k < once.Connections().contacts; ++k) {
      CHECK(std::abs(once.Endpoint(0, k).x - once.Endpoint(last, k).x) < 1e-5f);
      CHECK(std::abs(once.Endpoint(0, k).y - once.Endpoint(last, k).y) < 1e-5f);
    }
    for (int j = 0; j < once.Connections().Actuators(); ++j)
      CHECK(std::abs(once.AngleRad(0, j) - once.AngleRad(last, j)) < 1e-5f);
    if (!document->figure.HasSprings()) continue;
    ++of_springs;
    CheckLengths(document->figure, once);
  }
  CHECK(loops >= 10);
  CHECK(of_springs >= 3);
}

TEST_CASE("loop: none without a controller, or along drawn ground", "[gait]") {
  Document d = *DecodeJson(ReadFile("examples/star-man-shuffle.json"));
  d.model = 2;
  REQUIRE(LoopOf(d, Simulate(d), false));
  // Far away from where it walks, but what is drawn need not repeat.
  d.environment.ground = {{150.0f, 0.0f}, {160.0f, 1.0f}};
  CHECK(LoopOf(d, Simulate(d), false).error().what ==
        "the ground is drawn, so what is under the figure does not repeat");
  d.timeline.clear();
  d.controllers.clear();
  CHECK(LoopOf(d, Simulate(d), false).error().what == "the document has no controller");
}

TEST_CASE("loop: within a motion whose later clips begin after its end", "[gait]") {
  Document d = *DecodeJson(ReadFile("examples/star-man-shuffle.json"));
  d.timeline.push_back({0, d.duration_steps});
  d.duration_steps = 600;
  const Motion motion = Simulate(d);
  const auto found = ShownLoopOf(d, motion, false);
  REQUIRE(found);
  CHECK(found->loop.cycle.first + found->loop.cycle.frames <= motion.Frames() - 1);
  d.duration_steps = 20;  // and where it is too short
  CHECK(LoopOf(d, Simulate(d), false));
  CHECK(ShownLoopOf(d, Simulate(d), false).error().what.contains("too short to repeat"));
}

}  // namespace gaitsmith::test
