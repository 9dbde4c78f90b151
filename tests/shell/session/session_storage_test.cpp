// SPDX-License-Identifier: MIT
// What a session stores for a reload of its tab, and what it makes of damaged data.
#include <catch_amalgamated.hpp>

#include "tests/shell/session/quiet_host.h"

namespace gaitsmith::shell::test {

namespace {

void DragFriction(Session& session, float friction) {
  session.BeginGesture();
  REQUIRE(session.Change([friction](Document& d) { d.environment.friction = friction; }));
}

std::vector<std::uint32_t> Seeds(Session& session) {
  std::vector<std::uint32_t> seeds;
  for (const SearchQueue::Entry& entry : session.Queue().List().Waiting())
    seeds.push_back(entry.document.search.seed);
  return seeds;
}

void Queue(Session& session, std::uint32_t seed) {
  Document document = session.Doc();
  document.search.seed = seed;
  REQUIRE(session.Queue().Add(document));
}

}  // namespace

TEST_CASE("session: a reload keeps Undo, Redo and the queue", "[shell][session][storage]") {
  QuietHost host;
  Session session(host);
  DragFriction(session, 0.3f);
  DragFriction(session, 0.4f);
  DragFriction(session, 0.5f);
  session.Undo();
  for (const std::uint32_t seed : {5u, 6u}) Queue(session, seed);
  REQUIRE(session.Queue().Run());

  QuietHost next_host;
  Session next(next_host);
  REQUIRE(next.Open(EncodeJson(session.WithHash())));
  next.ForgetPast();
  REQUIRE(next.RestoreVisit(session.StoreVisit()));
  CHECK(Seeds(next) == std::vector<std::uint32_t>{5, 6});  // the search that ran waits again
  CHECK(next_host.started.empty());
  CHECK(next_host.status == "2 searches wait until you press Run queue.");
  next.Redo();
  CHECK(next.Doc().environment.friction == 0.5f);
  next.Undo();
  next.Undo();
  CHECK(next.Doc().environment.friction == 0.3f);
  next.Undo();
  CHECK_FALSE(next.CanUndo());
}

TEST_CASE("session: a reload keeps a full queue and the search of it that runs",
          "[shell][session][storage]") {
  QuietHost host;
  Session session(host);
  Queue(session, 100);
  REQUIRE(session.Queue().Run());
  for (std::uint32_t seed = 101; !session.Queue().List().Full(); ++seed) Queue(session, seed);
  const std::string stored = session.StoreVisit();

  QuietHost next_host;
  Session next(next_host);
  REQUIRE(next.RestoreVisit(stored));
  const std::vector<std::uint32_t> seeds = Seeds(next);
  REQUIRE(seeds.size() == SearchQueue::kMax + 1);
  CHECK(seeds.front() == 100);
  CHECK(seeds.back() == 150);
  CHECK(next.StoreVisit() == stored);  // also at the next reload
  CHECK_FALSE(next.Queue().Add(next.Doc()));
}

TEST_CASE("session: a reload keeps the choices of a first visit, or all panels",
          "[shell][session][storage]") {
  QuietHost host;
  Session session(host);
  REQUIRE(session.Begin(""));
  for (const bool simple : {true, false}) {
    session.ShowAll(!simple);
    Session next(host);
    REQUIRE(next.Open(EncodeJson(session.WithHash())));
    CHECK_FALSE(next.Simple());
    REQUIRE(next.RestoreVisit(session.StoreVisit()));
    CHECK(next.Simple() == simple);
  }
}

TEST_CASE("session: damaged data of a visit is ignored as a whole", "[shell][session][storage]") {
  QuietHost host;
  Session session(host);
  DragFriction(session, 0.3f);
  Queue(session, 5);
  const std::string good = session.StoreVisit();
  QuietHost next_host;
  Session next(next_host);
  for (std::size_t i = 0; i < good.size(); i += 7) {
    std::string damaged = good;
    damaged[i] = damaged[i] == '!' ? '?' : '!';
    CAPTURE(damaged);
    CHECK_FALSE(next.RestoreVisit(damaged));
    CHECK_FALSE(next.RestoreVisit(std::string_view(good).substr(0, i)));
  }
  CHECK_FALSE(next.CanUndo());
  CHECK(next.Queue().List().Waiting().empty());
}

TEST_CASE("session: a change of the queue is reported for storage", "[shell][session][storage]") {
  QuietHost host;
  Session session(host);
  const int before = host.changes;
  Queue(session, 5);
  CHECK(host.changes == before + 1);
  session.Queue().List().Clear();
  CHECK(host.changes == before + 2);
}

}  // namespace gaitsmith::shell::test
