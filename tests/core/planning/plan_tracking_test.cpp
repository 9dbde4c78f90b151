// SPDX-License-Identifier: MIT
// Rules that imitate a planned motion.
#include "core/planning/plan_tracking.h"

#include <catch_amalgamated.hpp>
#include <cmath>

#include "core/document/json.h"
#include "core/planning/plan_recorder.h"
#include "core/rollout/evaluation.h"
#include "tests/scene.h"

namespace gaitsmith::test {
namespace {

Document Planned(const std::string& name, SenseKind senses) {
  auto document = DecodeJson(ReadFile("examples/planned/" + name + ".json"));
  REQUIRE(document);
  document->senses.kind = senses;
  return *std::move(document);
}

/// Root mean square of the joints' differences over the plan [rad].
double GapOf(const Motion& planned, const Motion& tracked, int steps) {
  double squares = 0.0;
  const int joints = planned.Bones().joints;
  for (int frame = 0; frame <= steps; ++frame) {
    for (int joint = 0; joint < joints; ++joint) {
      const auto gap = static_cast<double>(planned.AngleRad(frame, joint) - tracked.AngleRad(frame, joint));
      squares += gap * gap;
    }
  }
  return std::sqrt(squares / (joints * (steps + 1.0)));
}

}  // namespace

TEST_CASE("tracking: rules of a timer bend the joints as planned", "[planning]") {
  const char* name = GENERATE("acrobat-somersault", "biped-step", "lamp-jump");
  CAPTURE(name);
  const Document document = Planned(name, SenseKind::kTimer);
  const auto tracked = TrackPlan(document);
  REQUIRE(tracked);
  CHECK(Validate(*tracked));
  REQUIRE(tracked->controllers.size() == 1);
  CHECK(FitsSearch(*tracked, tracked->controllers[0]));
  CHECK(StartOf(*tracked) == tracked->controllers[0].genes);
  const auto planned = RecordPlanned(document);
  REQUIRE(planned);
  const double gap = GapOf(*planned, Simulate(*tracked), document.plan.steps);
  CAPTURE(gap);
  CHECK(gap < 0.2);
}

TEST_CASE("tracking: rules with senses act in turn, and are scored against the planned way", "[planning]") {
  const Document document = Planned("lamp-jump", SenseKind::kPhysical);
  const auto tracked = TrackPlan(document);
  REQUIRE(tracked);
  CHECK(Validate(*tracked));
  const Motion motion = Simulate(*tracked);
  std::vector<bool> acted(static_cast<std::size_t>(tracked->rules), false);
  for (int frame = 1; frame <= document.plan.steps; ++frame)
    acted[static_cast<std::size_t>(motion.At(frame).rule)] = true;
  const auto count = std::ranges::count(acted, true);
  CAPTURE(count);
  CHECK(count >= tracked->rules / 2);
  const auto& way = tracked->task.shown.way;
  REQUIRE(way.size() > 2);
  CHECK(way.front().step == 0);
  CHECK(way.back().step == document.plan.steps);
  CHECK(std::abs(way.back().x_m - document.plan.keyframes.back().marks[0].x_m) < 0.01f);
  CHECK(tracked->task.weights[static_cast<std::size_t>(StyleTerm::kOnWay)] > 0.0f);
  CHECK(tracked->task.weights[static_cast<std::size_t>(StyleTerm::kInPose)] > 0.0f);
}

TEST_CASE("tracking: without a planned motion there is nothing to track", "[planning]") {
  Document document = Planned("lamp-jump", SenseKind::kTimer);
  document.plan.solved = {};
  const auto tracked = TrackPlan(document);
  REQUIRE_FALSE(tracked);
  CHECK(tracked.error().where == "plan");
}

}  // namespace gaitsmith::test
