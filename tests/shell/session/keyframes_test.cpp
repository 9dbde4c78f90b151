// SPDX-License-Identifier: MIT
// Keyframes in a session: edits of the plan, when it is carried out, and what becomes of the reports.
#include <algorithm>
#include <catch_amalgamated.hpp>

#include "core/planning/planning.h"
#include "shell/session/session.h"
#include "tests/shell/session/quiet_host.h"

namespace gaitsmith::shell::test {

namespace {

using Stage = PlanRun::State;

/// Mr. Star-Man with a planned jump that waits to be carried out.
void BeginJump(Session& session) {
  session.BeginGesture();
  session.OpenKeyframes();
}

/// Carries out the last plan as a host would.
void CarryOut(Session& session, const QuietHost& host) {
  CarryOutPlan(host.planned.back(), {}, [&](const PlanReport& report) {
    session.Planning().OnReport(host.plan_generation, report);
    return true;
  });
}

/// Begins that jump, and carries it out.
void MakeJump(Session& session, const QuietHost& host) {
  BeginJump(session);
  session.Advance(1.0);
  CarryOut(session, host);
}

}  // namespace

TEST_CASE("keyframes: the first plan of a figure is a jump that can be made", "[keyframes]") {
  QuietHost host;
  Session session(host);
  BeginJump(session);
  CHECK(session.Keyframes().Open());
  CHECK(session.Doc().view.panel == static_cast<int>(Panel::kKeyframes));
  CHECK(session.Keyframes().Shown().stances.size() == 4);  // two feet, twice
  CHECK(host.planned.empty());
  session.Advance(1.0);
  REQUIRE(host.planned.size() == 1);
  CHECK(session.Planning().Now() == Stage::kWorks);
  CarryOut(session, host);
  CHECK(session.Planning().Now() == Stage::kDone);
  CHECK(session.Doc().controllers.back().kind == ControllerKind::kTrajectory);
  CHECK_FALSE(session.Doc().plan.solved.unknowns.empty());
  CHECK(session.Comparison().Other().Source() == Ghost::Kind::kPlanned);
  // Nothing has changed since.
  session.Advance(1.0);
  CHECK(host.planned.size() == 1);
}

TEST_CASE("keyframes: plan and motion are one step of Undo, and what comes back is not planned again",
          "[keyframes]") {
  QuietHost host;
  Session session(host);
  const std::string before = shell::test::State(session);
  MakeJump(session, host);
  const std::string after = shell::test::State(session);
  session.Undo();
  CHECK(shell::test::State(session) == before);
  session.Redo();
  CHECK(shell::test::State(session) == after);
  session.Advance(1.0);
  CHECK(host.planned.size() == 1);
}

TEST_CASE("keyframes: each edit plans anew, from the motion before", "[keyframes]") {
  QuietHost host;
  Session session(host);
  MakeJump(session, host);
  session.BeginGesture();
  session.Keyframes().Change([](Plan& plan) { plan.keyframes.back().marks[0].x_m += 0.1f; });
  CHECK(session.Doc().plan.solved.unknowns.empty());
  session.Advance(1.0);
  REQUIRE(host.planned.size() == 2);
  CHECK_FALSE(host.planned.back().plan.solved.unknowns.empty());
  // While it works, another edit stops it.
  session.Keyframes().SetLength(220);
  CHECK(host.plan_stops == 1);
  session.Planning().OnReport(host.plan_generation,
                              {.stage = PlanReport::Stage::kRefused, .document = session.Doc()});
  CHECK(session.Planning().Now() == Stage::kWaits);  // a report that comes too late
}

TEST_CASE(
    "keyframes: what Undo brings back while a plan is made, or after the world changed, is not planned again",
    "[keyframes]") {
  QuietHost host;
  Session session(host);
  MakeJump(session, host);
  const std::string solved = shell::test::State(session);
  const auto edits = {+[](Document& d) {
                        d.plan.keyframes.back().marks[0].x_m += 0.1f;
                        d.plan.solved = {};
                      },
                      +[](Document& d) { d.environment.friction = 0.5f; }};
  for (const auto edit : edits) {
    session.BeginGesture();
    session.Change(edit);
    session.Advance(1.0);
    CHECK(session.Planning().Now() == Stage::kWorks);
    const std::size_t made = host.planned.size();
    session.Undo();
    CHECK(shell::test::State(session) == solved);
    session.Advance(1.0);
    CHECK(host.planned.size() == made);
    CHECK(session.CanRedo());
  }
}

TEST_CASE("keyframes: a locked timeline is not planned, and nothing planned outlives its plan",
          "[keyframes]") {
  QuietHost host;
  Session session(host);
  MakeJump(session, host);
  CHECK(session.Comparison().Other().Source() == Ghost::Kind::kPlanned);
  session.Keyframes().Clear();
  CHECK(session.Comparison().Other().Source() == Ghost::Kind::kNone);
  BeginJump(session);
  REQUIRE_FALSE(LockParts("timeline", session.Layout()));
  const std::size_t made = host.planned.size();
  session.Advance(1.0);
  CHECK(host.planned.size() == made);
  CHECK(session.Planning().Now() == Stage::kNone);
}

TEST_CASE("keyframes: a plan that cannot be met names what is in the way", "[keyframes]") {
  QuietHost host;
  Session session(host);
  BeginJump(session);
  session.Keyframes().Change([](Plan& plan) {
    plan.keyframes.push_back({.step = 40, .marks = {{.axes = MarkAxes::kUp, .y_m = 5.0f}}});
  });
  session.Advance(1.0);
  CarryOut(session, host);
  CHECK(session.Planning().Now() == Stage::kRefused);
  REQUIRE(session.Planning().Culprit() != nullptr);
  CHECK(session.Planning().Culprit()->part == PlanPart{PlanPart::Kind::kMarkY, 0, 0});
  CHECK(session.Notice().starts_with("The centre of mass cannot be so high at 0.40 s:"));
  session.Planning().OnFailed(host.plan_generation);  // too late
  CHECK(session.Planning().Now() == Stage::kRefused);
}

TEST_CASE("keyframes: ground that plans do not know is said to be in the way", "[keyframes]") {
  QuietHost host;
  Session session(host);
  BeginJump(session);
  session.Change([](Document& d) { d.environment.sway_rad = 0.1f; });
  session.Advance(1.0);
  CHECK(host.planned.empty());
  CHECK(session.Planning().Now() == Stage::kImpossible);
  CHECK_FALSE(session.Notice().empty());
}

TEST_CASE("keyframes: bars keep apart, and what stands at the end stays there", "[keyframes]") {
  QuietHost host;
  Session session(host);
  BeginJump(session);
  PlanEditor& keyframes = session.Keyframes();
  const int endpoint = keyframes.Shown().stances[0].endpoint;
  keyframes.MoveStance(0, true, 190);
  CHECK(keyframes.Shown().stances[0].last_step == keyframes.Shown().stances[1].first_step - 1);
  keyframes.MoveStance(0, false, 500);
  CHECK(keyframes.Shown().stances[0].first_step == keyframes.Shown().stances[0].last_step - 2);
  keyframes.SetLength(150);
  CHECK(keyframes.Shown().keyframes.back().step == 150);
  CHECK(std::ranges::all_of(keyframes.Shown().stances,
                            [](const Stance& stance) { return stance.last_step <= 150; }));
  keyframes.RemoveStance(0);
  CHECK(std::ranges::count(keyframes.Shown().stances, endpoint, &Stance::endpoint) == 1);
  session.Player().Seek(0.0);
  keyframes.AddStance(endpoint);
  CHECK(std::ranges::count(keyframes.Shown().stances, endpoint, &Stance::endpoint) == 2);
  keyframes.AddStance(endpoint);
  CHECK_FALSE(session.Notice().empty());
  keyframes.Clear();
  CHECK_FALSE(keyframes.Open());
  CHECK(session.Planning().Now() == Stage::kNone);
}

TEST_CASE("keyframes: stances can be taken from a motion, and a keyframe from its pose", "[keyframes]") {
  QuietHost host;
  Session session(host);
  BeginJump(session);
  session.Player().Seek(1.0);
  REQUIRE(session.Keyframes().AddKeyframe());
  REQUIRE(session.Keyframes().Chosen() == 0);
  const Keyframe& keyframe = session.Keyframes().Shown().keyframes[0];
  CHECK(keyframe.step == 100);
  CHECK(std::abs(keyframe.pose_rad[1] - session.Player().Shown().AngleRad(100, 1)) < 1e-6f);
  CHECK_FALSE(session.Keyframes().AddKeyframe());
  CHECK(session.Keyframes().Shown().keyframes.size() == 2);
  session.Keyframes().TakeStances();
  CHECK_FALSE(session.Keyframes().Shown().stances.empty());
  CHECK(Validate(session.Doc()));
}

TEST_CASE("keyframes: a keyframe is taken from the plan, which meets it, and marks are dragged",
          "[keyframes]") {
  QuietHost host;
  Session session(host);
  MakeJump(session, host);
  const Motion& planned = session.Comparison().PlannedOrShown().Shown();
  const float angle = planned.AngleRad(100, 1);
  REQUIRE(angle != session.Player().Shown().AngleRad(100, 1));
  session.Player().Seek(1.0);
  REQUIRE(session.Keyframes().AddKeyframe());
  CHECK(std::abs(session.Keyframes().Shown().keyframes[0].pose_rad[1] - angle) < 1e-5f);
  session.Keyframes().MoveMark(1, 0, 0.7f, 5.0f);
  CHECK(session.Keyframes().Shown().keyframes[1].marks[0].x_m == 0.7f);
  CHECK(session.Keyframes().Shown().keyframes[1].marks[0].y_m == 0.0f);  // only its place along counts
}

TEST_CASE("keyframes: the planned motion is tracked by rules, as one step of Undo", "[keyframes]") {
  QuietHost host;
  Session session(host);
  MakeJump(session, host);
  const std::uint64_t played = session.Player().Shown().Hash();
  session.TrackKeyframes();
  CHECK(session.Search().Running());
  REQUIRE(session.Doc().controllers.size() == 1);
  CHECK(session.Doc().controllers[0].kind == ControllerKind::kRules);
  CHECK(session.Doc().search.start == 0);
  CHECK(session.Comparison().Other().Source() == Ghost::Kind::kPlanned);
  session.Stop();
  session.Undo();
  CHECK(session.Player().Shown().Hash() == played);
  CHECK(session.Doc().controllers[0].kind == ControllerKind::kTrajectory);
}

TEST_CASE("keyframes: another figure has no keyframes of this one", "[keyframes]") {
  QuietHost host;
  Session session(host);
  BeginJump(session);
  Figure fewer = session.Doc().figure;
  fewer.rods.pop_back();
  REQUIRE(session.ReplaceFigure(fewer));
  CHECK_FALSE(session.Keyframes().Open());
}

}  // namespace gaitsmith::shell::test
