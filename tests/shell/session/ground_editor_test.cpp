// SPDX-License-Identifier: MIT
// Choosing and drawing the ground: valid corners, limited joints, one step of Undo each.
#include "shell/session/ground_editor.h"

#include <algorithm>
#include <catch_amalgamated.hpp>
#include <cmath>

#include "core/document/joints.h"
#include "core/document/link.h"
#include "core/numeric/random.h"
#include "core/world/terrain.h"
#include "shell/session/commands.h"
#include "shell/session/ground_stroke.h"
#include "tests/shell/session/quiet_host.h"

namespace gaitsmith::shell::test {
namespace {

using Line = std::vector<Corner>;

constexpr float kDetail = 0.03f;

// Points every 2 cm along a line through corners, as a hand would draw it.
Line Drawn(const Line& through) {
  Line points;
  for (std::size_t i = 0; i + 1 < through.size(); ++i) {
    const Corner &a = through[i], &b = through[i + 1];
    const auto count = static_cast<int>(std::hypot(b.x_m - a.x_m, b.y_m - a.y_m) / 0.02f) + 1;
    for (int k = 0; k < count; ++k) {
      const float share = static_cast<float>(k) / static_cast<float>(count);
      points.push_back({a.x_m + share * (b.x_m - a.x_m), a.y_m + share * (b.y_m - a.y_m)});
    }
  }
  points.push_back(through.back());
  return points;
}

}  // namespace

TEST_CASE("ground stroke: a drawn step has a vertical face and goes on level", "[shell][ground]") {
  const auto ground = WithStroke({}, Drawn({{3.0f, 0.0f}, {3.05f, 0.4f}, {5.0f, 0.4f}}), kDetail);
  REQUIRE(ground);
  CHECK(*ground == Line{{3.0f, 0.0f}, {3.0f, 0.4f}});
  // From right to left it is the same.
  CHECK(WithStroke({}, Drawn({{5.0f, 0.4f}, {3.05f, 0.4f}, {3.0f, 0.0f}}), kDetail) == ground);
  // What begins above the ground gets a face there.
  CHECK(WithStroke({}, Drawn({{3.0f, 0.4f}, {5.0f, 0.4f}}), kDetail) == ground);
  // What ends close to the ground joins it, and what is level all along is no ground of its own.
  const auto ramp = WithStroke({}, Drawn({{3.0f, 0.05f}, {4.0f, 1.0f}, {5.0f, 0.06f}}), kDetail);
  REQUIRE(ramp);
  CHECK(*ramp == Line{{3.0f, 0.0f}, {4.0f, 1.0f}, {5.0f, 0.0f}});
  CHECK(WithStroke(*ramp, Drawn({{2.5f, 0.0f}, {5.5f, 0.02f}}), kDetail) == Line{});
}

TEST_CASE("ground stroke: a line replaces the part below it and joins the rest", "[shell][ground]") {
  const Line hill = {{2.0f, 0.0f}, {4.0f, 2.0f}, {6.0f, 0.0f}};
  const auto cut = WithStroke(hill, Drawn({{3.0f, 1.0f}, {5.0f, 1.0f}}), kDetail);
  REQUIRE(cut);
  CHECK(*cut == Line{{2.0f, 0.0f}, {3.0f, 1.0f}, {5.0f, 1.0f}, {6.0f, 0.0f}});
  const auto pit = WithStroke(hill, Drawn({{3.0f, -1.0f}, {5.0f, -1.0f}}), kDetail);
  REQUIRE(pit);
  CHECK(*pit == Line{{2.0f, 0.0f}, {3.0f, 1.0f}, {3.0f, -1.0f}, {5.0f, -1.0f}, {5.0f, 1.0f}, {6.0f, 0.0f}});
  CHECK_FALSE(WithStroke(hill, Drawn({{3.0f, 0.0f}, {3.01f, 2.0f}}), kDetail));
  CHECK_FALSE(WithStroke(hill, Line{{3.0f, 0.0f}}, kDetail));
}

TEST_CASE("ground stroke: whatever is scribbled over whatever ground, the result is valid",
          "[shell][ground]") {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    RandomStream random(seed, 0, 0);
    Line ground = GroundOf(static_cast<GroundPreset>(random.Below(kGroundPresets)), 1 + random.Below(9));
    CAPTURE(seed);
    for (int stroke = 0; stroke < 8; ++stroke) {
      Line drawn = {{static_cast<float>(random.Uniform() * 500.0 - 250.0), 0.0f}};
      const auto points = static_cast<int>(random.Below(200));
      const bool wild = random.Chance(0.3);
      for (int i = 0; i < points; ++i) {
        const Corner& last = drawn.back();
        drawn.push_back({last.x_m + static_cast<float>(random.Uniform() - 0.2) * (wild ? 3.0f : 0.3f),
                         last.y_m + static_cast<float>(random.Normal()) * (wild ? 5.0f : 0.05f)});
      }
      const auto next = WithStroke(ground, drawn, kDetail);
      if (!next) continue;
      REQUIRE(Validate(*next));
      ground = *next;
    }
  }
}

TEST_CASE("ground editor: a choice limits the joints, says so, and is one step of Undo", "[shell][ground]") {
  QuietHost host;
  Session session(host);
  REQUIRE_FALSE(HasLimitedJoints(session.Doc()));
  const std::string before = State(session);
  session.BeginGesture();
  session.Ground().Choose(GroundPreset::kStairs, 1);
  CHECK(session.Doc().environment.ground == GroundOf(GroundPreset::kStairs));
  CHECK(HasLimitedJoints(session.Doc()));
  CHECK(host.status == "Drawn ground needs joints of limited strength, so they are limited now.");
  CHECK(session.World().Changed());
  CHECK(session.Ground().Preset() == KnownGround{GroundPreset::kStairs});
  const auto linked = DecodeLink(EncodeLink(session.Doc()));
  REQUIRE(linked);
  CHECK(linked->environment.ground == session.Doc().environment.ground);
  session.BeginGesture();
  session.Ground().ChooseOtherRubble();
  session.BeginGesture();
  session.Ground().ChooseOtherRubble();
  CHECK(session.Ground().Preset() == KnownGround{GroundPreset::kRubble, 2});
  session.Undo();
  CHECK(session.Ground().Preset() == KnownGround{GroundPreset::kRubble, 1});
  session.Undo();
  session.Undo();
  CHECK(State(session) == before);
  // Level ground leaves the joints as they are; the world as opened had others.
  session.BeginGesture();
  session.Ground().Choose(GroundPreset::kStepUp, 1);
  session.Ground().Choose(GroundPreset::kLevel, 1);
  CHECK(HasLimitedJoints(session.Doc()));
  session.World().Reset();
  CHECK_FALSE(HasLimitedJoints(session.Doc()));
}

TEST_CASE("ground editor: another figure stands on the same ground, with limited joints", "[shell][ground]") {
  QuietHost host;
  Session session(host);
  session.Ground().Choose(GroundPreset::kGap, 1);
  session.ChooseFigure(2);
  CHECK(session.Doc().environment.ground == GroundOf(GroundPreset::kGap));
  CHECK(HasLimitedJoints(session.Doc()));
  CHECK(Validate(session.Doc()));
}

TEST_CASE("ground editor: what is compared moves with the joints of its own world", "[shell][ground]") {
  QuietHost host;
  Session session(host);
  const std::uint64_t opened = session.Player().Shown().Hash();
  session.Ground().Choose(GroundPreset::kStepUp, 1);
  session.Comparison().Choose(Ghost::Kind::kAsOpened);
  REQUIRE(session.Comparison().Other().Player() != nullptr);
  CHECK(session.Comparison().Other().Player()->Shown().Hash() == opened);
  CHECK(session.Comparison().Other().Player()->Ground().Level());
}

TEST_CASE("ground editor: corners move between their neighbours, snap above them, go and come",
          "[shell][ground]") {
  QuietHost host;
  Session session(host);
  GroundEditor& ground = session.Ground();
  ground.DrawLine(Drawn({{2.0f, 0.0f}, {3.0f, 1.0f}, {4.0f, 0.0f}}), kDetail);
  REQUIRE(ground.Corners().size() == 3);
  CHECK_FALSE(ground.Preset());
  session.BeginGesture();
  ground.MoveCorner(1, {3.256f, 0.5f}, 0.05f);
  CHECK(ground.Corners()[1] == Corner{3.26f, 0.5f});
  ground.MoveCorner(1, {3.98f, 0.5f}, 0.05f);
  CHECK(ground.Corners()[1] == Corner{4.0f, 0.5f});
  ground.MoveCorner(1, {9.0f, 30.0f}, 0.05f);
  CHECK(ground.Corners()[1] == Corner{4.0f, 20.0f});
  ground.MoveCorner(1, {-9.0f, 0.5f}, 0.05f);
  CHECK(ground.Corners()[1] == Corner{2.0f, 0.5f});
  // Not on top of its neighbour: the ground stays.
  ground.MoveCorner(1, {2.0f, 0.0f}, 0.05f);
  CHECK(ground.Corners()[1] == Corner{2.0f, 0.5f});
  session.Undo();
  CHECK(ground.Corners()[1] == Corner{3.0f, 1.0f});
  ground.ChooseCorner(0);
  ground.AddCorner();
  CHECK(ground.Chosen() == 1);
  CHECK(ground.Corners()[1] == Corner{2.5f, 0.5f});
  ground.RemoveCorner(1);
  CHECK(ground.Corners().size() == 3);
  CHECK_FALSE(ground.Chosen());
  ground.RemoveCorner(1);
  CHECK(ground.Level());
  for (int i = 0; i < 70; ++i) ground.AddCorner();
  CHECK(ground.Corners().size() <= kMaxCorners);
  CHECK(Validate(ground.Corners()));
}

TEST_CASE("ground editor: drawing rests the motion at its start, and ends with a tool or another document",
          "[shell][ground]") {
  QuietHost host;
  Session session(host);
  session.Player().Play(true);
  session.Player().Seek(2.0);
  session.Ground().Draw(true);
  CHECK_FALSE(session.Player().Playing());
  CHECK(session.Player().TimeS() == 0.0);
  session.Teaching().Take(Teacher::Tool::kWay);
  CHECK_FALSE(session.Ground().Drawing());
  session.Ground().Draw(true);
  session.New();
  CHECK_FALSE(session.Ground().Drawing());
}

TEST_CASE("ground editor: commands choose, draw and remove; a locked world refuses", "[shell][ground]") {
  QuietHost host;
  Session session(host);
  const auto command = [&](const std::string& id) {
    const std::vector<Command> list = CommandsOf(session, false);
    const auto found = std::ranges::find(list, id, &Command::id);
    REQUIRE(found != list.end());
    return *found;
  };
  command("world/ground/hurdles").run();
  CHECK(session.Ground().Preset() == KnownGround{GroundPreset::kHurdles});
  // Keys that delete are for the drawing alone.
  const auto ids = CommandsOf(session, false);
  CHECK(std::ranges::find(ids, "world/ground/remove", &Command::id) == ids.end());
  command("world/ground/draw").run();
  CHECK(session.Ground().Drawing());
  CHECK(command("world/ground/remove").why_not == "No corner is chosen.");
  session.Ground().ChooseCorner(3);
  CHECK(command("world/ground/remove").why_not.empty());
  command("world/ground/remove").run();
  CHECK(session.Ground().Corners().size() == 55);
  session.Layout().locked[static_cast<std::size_t>(LockedPart::kWorld)] = true;
  CHECK_FALSE(command("world/ground/level").why_not.empty());
  session.Ground().Choose(GroundPreset::kLevel, 1);
  CHECK(session.Ground().Corners().size() == 55);
}

}  // namespace gaitsmith::shell::test
