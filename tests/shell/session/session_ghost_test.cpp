// SPDX-License-Identifier: MIT
// The motion that the shown one is compared with: whose it is, and that the same is done to both.
#include <catch_amalgamated.hpp>

#include "tests/shell/session/quiet_host.h"

namespace gaitsmith::shell::test {
namespace {

std::uint64_t GhostHash(const Session& session) { return session.Compared().Player()->Shown().Hash(); }

}  // namespace

TEST_CASE("session: a timer is searched for the shown senses, and stands beside them",
          "[shell][session][ghost]") {
  QuietHost host;
  Session session(host);
  const std::string before = State(session);
  session.KeepGhostInTime();  // there is none yet
  CHECK(session.Compared().Player() == nullptr);
  session.CompareDeciders();
  REQUIRE(host.started.size() == 1);
  CHECK(host.started[0].senses.kind == SenseKind::kTimer);
  CHECK(host.started[0].figure.name == session.Doc().figure.name);
  CHECK(session.AwaitsRival());
  CHECK_FALSE(session.Compared().Beside());
  session.CompareDeciders();
  CHECK(host.started.size() == 1);
  CHECK(session.queue.Waiting().empty());

  End(session, host, 30000);
  CHECK_FALSE(session.AwaitsRival());
  REQUIRE(session.Compared().Beside());
  CHECK(session.GhostWords().find("timer") != std::string::npos);
  CHECK(State(session) == before);
  CHECK(GhostHash(session) != session.player.Shown().Hash());

  // The same push to both; without it both are as they were.
  const std::uint64_t calm = session.player.Shown().Hash();
  const std::uint64_t ghost_calm = GhostHash(session);
  session.player.Seek(0.5);
  REQUIRE(session.Kick(kCentreOfMass, 6.0f, 3.0f));
  CHECK(session.player.Shown().Hash() != calm);
  const std::uint64_t ghost_pushed = GhostHash(session);
  CHECK(ghost_pushed != ghost_calm);
  Document expected = session.found.Sorted(FoundMotions::Order::kNewest)[0]->motion.document;
  expected.pushes = session.Doc().pushes;
  expected.duration_steps = session.Doc().duration_steps;
  CHECK(ghost_pushed == Simulate(expected).Hash());
  session.Undo();
  CHECK(GhostHash(session) == ghost_calm);

  session.player.Seek(1.25);
  session.KeepGhostInTime();
  CHECK(session.Compared().Player()->TimeS() == 1.25);
}

TEST_CASE("session: what was found before is compared at once, and nothing with another figure",
          "[shell][session][ghost]") {
  QuietHost host;
  Session session(host);
  session.CompareDeciders();
  End(session, host, 20000);
  session.StopComparing();
  CHECK(session.Compared().Player() == nullptr);
  session.CompareDeciders();
  CHECK(host.started.size() == 1);
  REQUIRE(session.Compared().Beside());
  // The results may lose it, the stage does not.
  session.found.Remove(session.Compared().FoundId());
  CHECK(session.Change([](Document& d) { d.environment.friction = 0.4f; }));
  CHECK(session.Compared().Beside());
  CHECK(session.GhostWords().find("timer") != std::string::npos);

  int other = 0;
  for (const Figure& figure : session.Figures()) {
    if (!SameTree(figure, session.Doc().figure)) break;
    ++other;
  }
  session.ChooseFigure(other);
  CHECK(session.Compared().Player() == nullptr);
  CHECK_FALSE(session.Compared().Beside());
  CHECK_FALSE(session.ChooseFoundGhost("0123456789abcdef"));
}

TEST_CASE("session: a comparison waits behind a search that runs, and is given up with it",
          "[shell][session][ghost]") {
  QuietHost host;
  Session session(host);
  session.Synthesize();
  session.CompareDeciders();
  REQUIRE(host.started.size() == 1);
  CHECK(session.queue.Waiting().size() == 1);
  CHECK(session.AwaitsRival());
  session.queue.Clear();
  CHECK_FALSE(session.AwaitsRival());

  session.New();
  session.notice.clear();
  session.CompareDeciders();
  CHECK_FALSE(session.notice.empty());
  CHECK(host.started.size() == 1);
}

TEST_CASE(
    "session: beside the shown motion stand the one before the search, the calm one, and each controller "
    "alone",
    "[shell][session][ghost]") {
  QuietHost host;
  Session session(host);
  const std::uint64_t first = session.player.Shown().Hash();
  CHECK(session.GhostWords().empty());
  session.Synthesize();
  End(session, host, 12345);
  const std::uint64_t second = session.player.Shown().Hash();
  REQUIRE(second != first);
  session.ChooseGhost(Ghost::Kind::kEarlier);
  CHECK(GhostHash(session) == first);
  CHECK(session.GhostWords() == "before the last search");

  session.ChooseGhost(Ghost::Kind::kCalm);
  session.player.Seek(0.5);
  REQUIRE(session.Kick(kCentreOfMass, 6.0f, 3.0f));
  CHECK(session.player.Shown().Hash() != second);
  CHECK(GhostHash(session) == second);
  session.ResetWorld();

  // A controller stays what is compared with, wherever an edit puts it in the list.
  session.AddClip();
  session.MirrorClip();
  REQUIRE(session.Doc().controllers.size() == 2);
  session.ChooseGhost(Ghost::Kind::kController, 1);
  const Document alone = [&] {
    Document document = session.Doc();
    document.timeline = {{.controller = 1, .start_step = 0}};
    return document;
  }();
  CHECK(GhostHash(session) == Simulate(alone).Hash());
  session.SelectClip(0);
  session.RemoveClip();
  REQUIRE(session.Doc().controllers.size() == 1);
  CHECK(session.Compared().ControllerIndex() == 0);
  CHECK(GhostHash(session) == session.player.Shown().Hash());
  session.ChooseGhost(Ghost::Kind::kController, 1);  // there is none
  CHECK(session.Compared().StandsFor() == Ghost::Kind::kNone);
}

}  // namespace gaitsmith::shell::test
