// SPDX-License-Identifier: MIT
// Teaching by example: ways and poses become part of the task, with a weight, and stay with their figure.
#include "shell/session/teacher.h"

#include <catch_amalgamated.hpp>

#include "core/document/goals.h"
#include "core/document/link.h"
#include "shell/session/session.h"
#include "tests/shell/session/quiet_host.h"

namespace gaitsmith::shell::test {
namespace {

float WeightOf(const Session& session, StyleTerm term) {
  return session.Doc().task.weights[static_cast<std::size_t>(term)];
}

// An arch from 0 to 8 m.
std::vector<WayPoint> Arch() {
  std::vector<WayPoint> drawn;
  for (int i = 0; i <= 40; ++i) {
    const float x = 0.2f * static_cast<float>(i);
    drawn.push_back({0, x, 1.0f + 0.1f * x * (8.0f - x)});
  }
  return drawn;
}

}  // namespace

TEST_CASE("teacher: a drawn way has an even pace, a weight, and is one step of Undo", "[shell][shown]") {
  QuietHost host;
  Session session(host);
  Teacher& teacher = session.Teaching();
  const int duration = session.Doc().task.duration_steps;
  session.BeginGesture();
  teacher.ShowWay(Arch());
  const std::vector<WayPoint> way = teacher.Shown().way;
  REQUIRE(way.size() == Teacher::kDrawnPoints);
  CHECK(way.front() == WayPoint{0, 0.0f, 1.0f});
  CHECK(way.back().step == duration);
  CHECK(way.back().x_m == Catch::Approx(8.0f).margin(1e-4));
  const auto piece = [&](std::size_t i) {
    return std::hypot(way[i].x_m - way[i - 1].x_m, way[i].y_m - way[i - 1].y_m);
  };
  for (std::size_t i = 1; i < way.size(); ++i) {
    CHECK(piece(i) == Catch::Approx(piece(1)).epsilon(0.03));
    CHECK(std::abs(way[i].step - way[i - 1].step - duration / 11) <= 1);
  }
  CHECK(WeightOf(session, StyleTerm::kOnWay) == 10.0f);
  CHECK(session.Player().Shown().TermsAt(duration).on_way_m < 0.0f);  // of the motion that is shown already
  session.BeginGesture();
  teacher.ForgetWay();
  CHECK(WeightOf(session, StyleTerm::kOnWay) == 0.0f);
  CHECK(session.Player().Shown().TermsAt(duration).on_way_m == 0.0f);
  session.Undo();
  CHECK(teacher.Shown().way == way);
  session.Undo();
  CHECK(teacher.Shown().way.empty());
}

TEST_CASE("teacher: points move between their neighbours, and the centre's place can be added",
          "[shell][shown]") {
  QuietHost host;
  Session session(host);
  Teacher& teacher = session.Teaching();
  teacher.ShowWay(Arch());
  const WayPoint next = teacher.Shown().way[4];
  teacher.MovePoint(3, {9999, 5.0f, -3.0f});
  CHECK(teacher.Shown().way[3] == WayPoint{next.step - 1, 5.0f, 0.0f});
  session.Set([](Document& d) { d.task.weights[static_cast<std::size_t>(StyleTerm::kOnWay)] = 0.0f; });
  teacher.RemovePoint(3);
  CHECK(WeightOf(session, StyleTerm::kOnWay) == 0.0f);  // a person's own weight stays
  CHECK(teacher.Shown().way.size() == Teacher::kDrawnPoints - 1);
  session.Player().SeekFrame(1.0);
  teacher.AddPlaceNow();
  teacher.AddPlaceNow();  // the same point
  REQUIRE(teacher.Shown().way.size() == Teacher::kDrawnPoints);
  const auto at = std::ranges::find(teacher.Shown().way, 100, &WayPoint::step);
  REQUIRE(at != teacher.Shown().way.end());
  CHECK(at->y_m == session.Player().Shown().At(100).y_m);
  for (int second = 0; second < 40; ++second) {
    session.Player().SeekFrame(0.07 * (second + 1));
    teacher.AddPlaceNow();
  }
  CHECK(teacher.Shown().way.size() == kMaxWayPoints);
  CHECK(session.Notice() == "A way has at most 32 points.");
}

TEST_CASE("teacher: the pose begins as the present one, and another figure forgets all", "[shell][shown]") {
  QuietHost host;
  Session session(host);
  Teacher& teacher = session.Teaching();
  session.Player().SeekFrame(2.5);
  teacher.Take(Teacher::Tool::kPose);
  CHECK(teacher.InHand() == Teacher::Tool::kPose);
  CHECK_FALSE(session.Player().Playing());
  const Demonstration shown = teacher.Shown();
  CHECK(shown.pose_step == 250);
  CHECK(session.Player().Shown().TermsAt(250).in_pose_rad == Catch::Approx(0.0f).margin(1e-4));
  teacher.TurnJoint(0, 0.5f);
  teacher.TurnWhole(7.0f);
  CHECK(teacher.Shown().pose_rad[0] == 0.5f);
  CHECK(teacher.Shown().pose_turn_rad == Catch::Approx(7.0 - 2.0 * 3.14159265).margin(1e-5));
  CHECK(DecodeLink(EncodeLink(session.Doc()))->task.shown == teacher.Shown());
  Document far = session.Doc();
  SetGoal(Goal::kFar, far);
  CHECK(GoalOf(far) == Goal::kFar);
  CHECK(far.task.shown == teacher.Shown());
  CHECK(far.task.weights[static_cast<std::size_t>(StyleTerm::kInPose)] == 20.0f);

  Figure figure = session.Doc().figure;
  figure.rods.pop_back();
  REQUIRE(session.ReplaceFigure(figure));
  CHECK(teacher.Shown() == Demonstration{});
  CHECK(WeightOf(session, StyleTerm::kInPose) == 0.0f);
  CHECK(teacher.InHand() == Teacher::Tool::kNone);
}

}  // namespace gaitsmith::shell::test
