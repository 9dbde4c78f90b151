// SPDX-License-Identifier: MIT
// Suites of searches, and actions on their results.
#include <catch_amalgamated.hpp>
#include <set>

#include "core/document/binary.h"
#include "core/document/style_weights.h"
#include "shell/results/suite_plan.h"
#include "tests/shell/session/quiet_host.h"

namespace gaitsmith::shell::test {
namespace {

constexpr SuiteChoice kAll = {{true, true}, {true, true, true}, {true, true, true, true, true}};

const FoundMotions::Entry& NewestOf(const Session& session) {
  return *session.Results().Motions().Sorted(FoundMotions::Order::kNewest).front();
}

}  // namespace

TEST_CASE("suite: one search for each combination, all different and valid", "[shell][suite]") {
  QuietHost host;
  Session session(host);
  CHECK(kAll.Searches() == 30);
  const std::vector<Document> suite = SuiteOf(session.Doc(), kAll);
  REQUIRE(suite.size() == 30);
  std::set<std::vector<std::uint8_t>> different;
  for (const Document& one : suite) {
    CHECK(Validate(one));
    CHECK(one.search.seed == session.Doc().search.seed);
    CHECK(one.search.evaluations == session.Doc().search.evaluations);
    different.insert(EncodeBinary(one));
  }
  CHECK(different.size() == 30);
  // Sorted by senses, then goal, then style.
  CHECK(suite[2].task.weights[2] == UsualWeights(suite[2])[2]);
  CHECK(suite[5].task.kind == TaskKind::kTravelLeft);
  CHECK(suite[15].senses.kind == SenseKind::kTimer);
  Document network = session.Doc();
  network.kind = ControllerKind::kNetwork;
  for (const Document& one : SuiteOf(network, kAll)) {
    CHECK(Validate(one));
    CHECK((one.kind == ControllerKind::kNetwork) == (one.senses.kind == SenseKind::kPhysical));
  }
}

TEST_CASE("suite: starts the queue, and reports how many searches do not fit", "[shell][suite]") {
  QuietHost host;
  Session session(host);
  const std::string before = State(session);
  session.Queue().AddSuite(kAll);
  CHECK(host.started.size() == 1);
  CHECK(session.Queue().List().Waiting().size() == 29);
  session.Queue().AddSuite(kAll);
  CHECK(session.Queue().List().Waiting().size() == SearchQueue::kMax);
  CHECK(host.status == "The queue had room for 21 of the suite's 30 searches.");
  CHECK(State(session) == before);
}

TEST_CASE("results: names are stored and validated, and repeating a search finds the same motion",
          "[shell][suite]") {
  QuietHost host;
  Session session(host);
  session.Search().Synthesize();
  End(session, host, 20000);
  const std::string id = NewestOf(session).id;
  CHECK(session.Results().Motions().Rename(id, "Wheel").empty());
  CHECK(session.Results().Motions().Rename(id, std::string(81, 'x')) == "at most 80 bytes, has 81");
  CHECK_FALSE(session.Results().Motions().Rename(id, "a\nb").empty());
  CHECK_FALSE(session.Results().Motions().Rename("0", "Wheel").empty());
  CHECK(NewestOf(session).motion.name == "Wheel");
  CHECK(host.stored[id].contains(R"("name":"Wheel")"));

  // The name survives storing. Invalid names are refused.
  const auto read = DecodeFound(host.stored[id]);
  REQUIRE(read);
  CHECK(read->name == "Wheel");
  std::string bad = host.stored[id];
  bad.replace(bad.find("\"Wheel\""), 7, "17");
  CHECK_FALSE(DecodeFound(bad));

  REQUIRE(session.ShowFound(id));
  CHECK(session.Doc().title == "Wheel");
  CHECK(session.Doc().controllers[0].name == "Wheel");
  CHECK(session.Results().IsShown(NewestOf(session)));
  REQUIRE(session.Timeline().InsertFound(id, 100));
  CHECK(session.Doc().timeline[1].start_step == 100);

  REQUIRE(session.Queue().Repeat(id));
  CHECK(host.started.size() == 2);
  CHECK(EncodeBinary(SearchOf(host.started[0])) == EncodeBinary(SearchOf(host.started[1])));
  End(session, host, 20000);
  CHECK(session.Results().Motions().Count() == 1);
  CHECK(NewestOf(session).motion.name == "Wheel");
}

}  // namespace gaitsmith::shell::test
