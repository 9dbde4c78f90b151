// SPDX-License-Identifier: MIT
// The motion that the shown one is compared with: its source, and its world and pushes.
#include <catch_amalgamated.hpp>

#include "tests/shell/session/quiet_host.h"

namespace gaitsmith::shell::test {
namespace {

std::uint64_t GhostHash(const Session& session) {
  return session.Comparison().Other().Player()->Shown().Hash();
}

}  // namespace

TEST_CASE("session: for physical senses, a timer is searched for and shown beside them",
          "[shell][session][ghost]") {
  QuietHost host;
  Session session(host);
  const std::string before = State(session);
  session.Comparison().KeepInTime();  // no other motion yet
  CHECK(session.Comparison().Other().Player() == nullptr);
  session.Comparison().CompareControlModes();
  REQUIRE(host.started.size() == 1);
  CHECK(host.started[0].senses.kind == SenseKind::kTimer);
  CHECK(host.started[0].figure.name == session.Doc().figure.name);
  CHECK(session.Comparison().Awaits());
  CHECK_FALSE(session.Comparison().Other().Beside());
  session.Comparison().CompareControlModes();
  CHECK(host.started.size() == 1);
  CHECK(session.Queue().List().Waiting().empty());

  End(session, host, 30000);
  CHECK_FALSE(session.Comparison().Awaits());
  REQUIRE(session.Comparison().Other().Beside());
  CHECK(session.Comparison().Words().find("timer") != std::string::npos);
  CHECK(State(session) == before);
  CHECK(GhostHash(session) != session.Player().Shown().Hash());

  // A push acts on both motions, and removing it restores both.
  const std::uint64_t calm = session.Player().Shown().Hash();
  const std::uint64_t ghost_calm = GhostHash(session);
  session.Player().Seek(0.5);
  REQUIRE(session.World().Push(kCentreOfMass, 6.0f, 3.0f));
  CHECK(session.Player().Shown().Hash() != calm);
  const std::uint64_t ghost_pushed = GhostHash(session);
  CHECK(ghost_pushed != ghost_calm);
  Document expected = session.Results().Motions().Sorted(FoundMotions::Order::kNewest)[0]->motion.document;
  expected.pushes = session.Doc().pushes;
  expected.duration_steps = session.Doc().duration_steps;
  CHECK(ghost_pushed == Simulate(expected).Hash());
  session.Undo();
  CHECK(GhostHash(session) == ghost_calm);

  session.Player().Seek(1.25);
  session.Comparison().KeepInTime();
  CHECK(session.Comparison().Other().Player()->TimeS() == 1.25);
}

namespace {

/// A session that once compared its motion with a timer's, and has that result.
struct ComparedBefore {
  QuietHost host;
  Session session{host};

  ComparedBefore() {
    session.Comparison().CompareControlModes();
    End(session, host, 20000);
    session.Comparison().Stop();
  }
};

}  // namespace

TEST_CASE("session: an earlier result is compared immediately, unless its figure differs",
          "[shell][session][ghost]") {
  ComparedBefore before;
  auto& [host, session] = before;
  CHECK(session.Comparison().Other().Player() == nullptr);
  session.Comparison().CompareControlModes();
  CHECK(host.started.size() == 1);
  REQUIRE(session.Comparison().Other().Beside());
  // Removing the motion from the results does not remove the ghost.
  session.Results().Motions().Remove(session.Comparison().Other().FoundId());
  CHECK(session.Change([](Document& d) { d.environment.friction = 0.4f; }));
  CHECK(session.Comparison().Other().Beside());
  CHECK(session.Comparison().Words().find("timer") != std::string::npos);

  int other = 0;
  for (const Figure& figure : session.Shipped().Figures()) {
    if (!SameTree(figure, session.Doc().figure)) break;
    ++other;
  }
  session.ChooseFigure(other);
  CHECK(session.Comparison().Other().Player() == nullptr);
  CHECK_FALSE(session.Comparison().Other().Beside());
  CHECK_FALSE(session.Comparison().ChooseFound("0123456789abcdef"));
}

TEST_CASE("session: with other joints an earlier result is not compared, but searched for again",
          "[shell][session][ghost]") {
  ComparedBefore before;
  auto& [host, session] = before;
  session.World().LimitJoints(true);
  session.Comparison().CompareControlModes();
  REQUIRE(host.started.size() == 2);
  CHECK(host.started.back().model == 2);
  End(session, host, 30000);
  CHECK(session.Comparison().Other().Beside());
  session.Comparison().Stop();
  session.World().LimitJoints(false);
  session.World().SetJointStrength(7.0f);  // which strong joints do not use
  session.Comparison().CompareControlModes();
  CHECK(host.started.size() == 2);
  CHECK(session.Comparison().Other().Beside());
}

TEST_CASE("session: a comparison waits for the running search, and is dropped with it",
          "[shell][session][ghost]") {
  QuietHost host;
  Session session(host);
  session.Search().Synthesize();
  session.Comparison().CompareControlModes();
  REQUIRE(host.started.size() == 1);
  CHECK(session.Queue().List().Waiting().size() == 1);
  CHECK(session.Comparison().Awaits());
  session.Queue().List().Clear();
  CHECK_FALSE(session.Comparison().Awaits());

  session.New();
  session.Notice().clear();
  session.Comparison().CompareControlModes();
  CHECK_FALSE(session.Notice().empty());
  CHECK(host.started.size() == 1);
}

TEST_CASE("session: the ghost can be the motion before the search, as opened, or of one controller",
          "[shell][session][ghost]") {
  QuietHost host;
  Session session(host);
  const std::uint64_t first = session.Player().Shown().Hash();
  CHECK(session.Comparison().Words().empty());
  session.Search().Synthesize();
  End(session, host, 12345);
  const std::uint64_t second = session.Player().Shown().Hash();
  REQUIRE(second != first);
  session.Comparison().Choose(Ghost::Kind::kEarlier);
  CHECK(GhostHash(session) == first);
  CHECK(session.Comparison().Words() == "before the last search");

  session.Comparison().Choose(Ghost::Kind::kAsOpened);
  session.Player().Seek(0.5);
  REQUIRE(session.World().Push(kCentreOfMass, 6.0f, 3.0f));
  CHECK(session.Player().Shown().Hash() != second);
  CHECK(GhostHash(session) == second);
  session.World().Reset();

  // The ghost follows its controller when an edit moves it in the list.
  session.Timeline().AddClip();
  session.Timeline().MirrorClip();
  REQUIRE(session.Doc().controllers.size() == 2);
  session.Comparison().Choose(Ghost::Kind::kController, 1);
  const Document alone = [&] {
    Document document = session.Doc();
    document.timeline = {{.controller = 1, .start_step = 0}};
    return document;
  }();
  CHECK(GhostHash(session) == Simulate(alone).Hash());
  session.Timeline().Select(0);
  session.Timeline().RemoveClip();
  REQUIRE(session.Doc().controllers.size() == 1);
  CHECK(session.Comparison().Other().ControllerIndex() == 0);
  CHECK(GhostHash(session) == session.Player().Shown().Hash());
  session.Comparison().Choose(Ghost::Kind::kController, 1);  // there is no such controller
  CHECK(session.Comparison().Other().Source() == Ghost::Kind::kNone);
}

}  // namespace gaitsmith::shell::test
