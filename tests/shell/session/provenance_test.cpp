// SPDX-License-Identifier: MIT
// Where the shown controller comes from: opened, found or bred here, or between. lesson_goals_test.cpp has
// whole visits with real searches.
#include "shell/session/provenance.h"

#include <catch_amalgamated.hpp>
#include <string>

#include "core/document/link.h"
#include "tests/scene.h"
#include "tests/shell/session/quiet_host.h"

namespace gaitsmith::shell::test {

using gaitsmith::test::ReadFile;

namespace {

std::string Origin(const Session& session) { return std::string(session.Origins().Of(session.Doc())); }

std::string Frog() { return ReadFile("examples/lessons/8-hop.json"); }

}  // namespace

TEST_CASE("provenance: what is opened, and what a script finds, is opened", "[shell][session]") {
  QuietHost host;
  Session session(host);
  CHECK(Origin(session) == "opened");
  REQUIRE(session.Open(Frog()));
  CHECK(Origin(session) == "opened");
  session.Search().SynthesizeForScript();
  End(session, host, 100);
  CHECK(Origin(session) == "opened");
  REQUIRE(session.Begin(""));
  CHECK(Origin(session).empty());
}

TEST_CASE("provenance: a person's search is new, through Undo and Redo too, and keeps its seed",
          "[shell][session]") {
  QuietHost host;
  Session session(host);
  REQUIRE(session.Open(Frog()));
  session.Set([](Document& d) { d.search.seed = 7; });
  session.Synthesize();
  End(session, host, 100);
  CHECK(Origin(session) == "new");
  session.Set([](Document& d) { d.search.seed = 8; });
  CHECK(session.Origins().SeedOf(session.Doc()) == 7);
  session.Undo();
  session.Undo();
  CHECK(Origin(session) == "opened");
  CHECK(session.Origins().SeedOf(session.Doc()) == 7);  // of its settings
  session.Redo();
  CHECK(Origin(session) == "new");

  // Also if something opened, or found by a script, is the same.
  const std::string link = EncodeLink(session.Doc());
  REQUIRE(session.Open(link));
  CHECK(Origin(session) == "new");
}

TEST_CASE("provenance: a climb from a motion is as new as its start", "[shell][session]") {
  QuietHost host;
  Session session(host);
  REQUIRE(session.Open(Frog()));
  session.TryStyle();
  End(session, host, 100);
  CHECK(Origin(session) == "changed");
  session.TryStyle();
  End(session, host, 200);
  CHECK(Origin(session) == "changed");
  session.Synthesize();
  End(session, host, 300);
  session.TryStyle();
  End(session, host, 400);
  CHECK(Origin(session) == "new");
}

TEST_CASE("provenance: a rule may go, but not change, and the clock is part of it", "[shell][session]") {
  QuietHost host;
  Session session(host);
  REQUIRE(session.Open(Frog()));
  session.Change([](Document& d) {
    const auto per_rule = static_cast<std::ptrdiff_t>(d.controllers[0].genes.size() / 4);
    d.controllers[0].genes.erase(d.controllers[0].genes.begin(), d.controllers[0].genes.begin() + per_rule);
    d.controllers[0].rules = 3;
  });
  CHECK(Origin(session) == "opened");
  session.Change([](Document& d) { ++d.controllers[0].senses.period_steps; });
  CHECK(Origin(session) == "changed");
  session.Undo();
  session.Undo();
  session.Change([](Document& d) { d.controllers[0].genes.back() ^= 1; });
  CHECK(Origin(session) == "changed");
}

TEST_CASE("provenance: where a controller looks is part of it", "[shell][session]") {
  QuietHost host;
  Session session(host);
  session.Set([](Document& d) { d.senses.kind = SenseKind::kSight; });
  session.Search().SynthesizeForScript();
  End(session, host, 100);
  REQUIRE(Origin(session) == "opened");
  session.Change([](Document& d) { d.controllers[0].senses.sight_rods = 3.0f; });
  CHECK(Origin(session) == "changed");
  session.Undo();
  REQUIRE(Origin(session) == "opened");
  session.Change([](Document& d) { d.controllers[0].senses.facing = Facing::kLeft; });
  CHECK(Origin(session) == "changed");
}

TEST_CASE("provenance: after a reload everything counts as opened", "[shell][session]") {
  QuietHost host, later;
  Session session(host), reloaded(later);
  REQUIRE(session.Open(Frog()));
  session.Synthesize();
  End(session, host, 100);
  CHECK(Origin(session) == "new");
  const std::string found = host.stored.begin()->second;
  REQUIRE(session.Open(ReadFile("examples/lessons/8-picked.json")));
  const std::string visit = session.StoreVisit();
  REQUIRE(reloaded.Open(EncodeLink(session.Doc())));
  reloaded.ForgetPast();
  REQUIRE(reloaded.RestoreVisit(visit));
  reloaded.Undo();
  CHECK(Origin(reloaded) == "opened");
  Session other(later);
  const std::string id = other.RestoreFound(found);
  REQUIRE(other.ShowFound(id));
  CHECK(Origin(other) == "opened");
  CHECK(other.RestoreFound("nothing").empty());
}

TEST_CASE("provenance: only generations that were bred here count", "[shell][session]") {
  QuietHost host;
  Session session(host);
  REQUIRE(session.Open(ReadFile("examples/lessons/8-picked.json")));
  const auto generations = [&] { return session.Origins().GenerationsOf(session.Doc()); };
  CHECK(generations() == 0);
  Document bred = session.Doc();
  const auto add = [&](int parent) {
    BreedRound round;
    round.parent = parent;
    round.task = bred.task;
    bred.lineage.rounds.push_back(round);
    bred.lineage.shown = static_cast<int>(bred.lineage.rounds.size()) - 1;
    REQUIRE(session.Open(EncodeLink(bred), OpenedFrom::kBreeding));
  };
  const int opened = bred.lineage.shown;
  add(opened);
  CHECK(generations() == 1);
  add(bred.lineage.shown);
  CHECK(generations() == 2);
  add(opened);  // another branch of the family
  CHECK(generations() == 1);
  REQUIRE(session.Open(EncodeLink(bred)));
  CHECK(generations() == 0);
}

}  // namespace gaitsmith::shell::test
