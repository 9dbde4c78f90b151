// SPDX-License-Identifier: MIT
// A session's queue and results: the order of searches, the shown motion, and the steps of Undo.
#include <algorithm>
#include <catch_amalgamated.hpp>

#include "core/document/binary.h"
#include "core/document/json.h"
#include "core/document/trial_worlds.h"
#include "shell/session/commands.h"
#include "tests/scene.h"
#include "tests/shell/session/quiet_host.h"

namespace gaitsmith::shell::test {

namespace {

// Reports a genome that the last search could have found.
void Report(Session& session, const QuietHost& host, Gene gene, SearchState state) {
  const Document& problem = host.started.back();
  SearchProgress progress{.state = state, .evaluations = 50, .budget = 100, .curve = {}, .best_genome = {}};
  progress.best_genome.assign(ProblemOf(problem).Shape().Genes(), gene);
  progress.best_fitness = 1.0f;
  session.OnSearchProgress(std::move(progress));
}

// Opens "Mr. Star-Man" and queues three searches with other figures and seeds.
void QueueThree(Session& session) {
  for (const int problem : {1, 2, 3}) {
    Document document = session.Shipped().Problems()[static_cast<std::size_t>(problem)];
    document.search.seed = static_cast<std::uint32_t>(problem);
    REQUIRE(session.Queue().Add(document));
  }
}

std::vector<const FoundMotions::Entry*> Newest(const Session& session) {
  return session.Results().Motions().Sorted(FoundMotions::Order::kNewest);
}

}  // namespace

TEST_CASE("session: the queue runs its searches in order and does not change the stage",
          "[shell][session][queue]") {
  QuietHost host;
  Session session(host);
  const std::string before = State(session);
  QueueThree(session);
  CHECK(host.started.empty());  // the queue does not start by itself
  REQUIRE(session.Queue().Run());
  for (const std::uint32_t seed : {1u, 2u, 3u}) {
    CAPTURE(seed);
    REQUIRE(host.started.size() == seed);
    CHECK(host.started.back().search.seed == seed);
    CHECK(session.Search().RunsQueued());
    Report(session, host, 20000, SearchState::kRunning);
    CHECK_FALSE(session.Search().ShowImprovement(10.0));
    Report(session, host, 30000, SearchState::kDone);
  }
  CHECK_FALSE(session.Search().Running());
  CHECK(host.started.size() == 3);
  CHECK(State(session) == before);
  CHECK_FALSE(session.CanUndo());
  const auto found = Newest(session);
  REQUIRE(found.size() == 3);
  CHECK(host.stored.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(SameSearch(found[i]->motion.document, host.started[2 - i]));
    CHECK(found[i]->motion.origin == Origin::kDone);
    CHECK(found[i]->motion.document.controllers.back().genes.front() == 30000);
  }
}

TEST_CASE("session: a result is shown as it was found, in one step", "[shell][session][found]") {
  QuietHost host;
  Session session(host);
  QueueThree(session);
  REQUIRE(session.Queue().Run());
  for (int i = 0; i < 3; ++i) Report(session, host, 30000, SearchState::kDone);
  session.SetView([](View& view) { view.panel = 3; });
  const std::string before = State(session);
  const FoundMotions::Entry entry = *Newest(session)[1];
  session.BeginGesture();
  REQUIRE(session.ShowFound(entry.id));
  Document shown = session.Doc();
  CHECK(shown.view.panel == 3);
  shown.view = {};
  CHECK(EncodeBinary(shown) == EncodeBinary(entry.motion.document));
  CHECK(session.Player().Shown().Hash() == *entry.motion.document.hash);
  CHECK(session.Results().IsShown(entry));
  CHECK_FALSE(session.Results().IsShown(*Newest(session)[0]));
  CHECK_FALSE(session.DiffersFromMaker());
  session.Undo();
  CHECK(State(session) == before);
  CHECK_FALSE(session.CanUndo());
  CHECK_FALSE(session.ShowFound("nothing of the kind"));
}

TEST_CASE("session: the same search again takes the next seed, another search keeps its own",
          "[shell][session]") {
  QuietHost host;
  Session session(host);
  const std::uint32_t seed = session.Doc().search.seed;
  CHECK_FALSE(session.Search().WouldRepeat());
  const std::string before = State(session);
  session.BeginGesture();
  session.Synthesize();
  CHECK(host.started.back().search.seed == seed);
  End(session, host, 30000);
  CHECK(session.Search().WouldRepeat());
  // A result with the next seed is there already.
  Document other = host.started.back();
  other.search.seed = seed + 1;
  REQUIRE(session.Queue().Add(other));
  REQUIRE(session.Queue().Run());
  End(session, host, 31000);
  session.BeginGesture();
  session.Synthesize();
  CHECK(session.Doc().search.seed == seed + 2);
  CHECK(host.started.back().search.seed == seed + 2);
  End(session, host, 32000);
  for (int step = 0; step < 3; ++step) session.Undo();  // two searches, and the seed between them
  CHECK(State(session) == before);
  CHECK_FALSE(session.CanUndo());
  for (int step = 0; step < 3; ++step) session.Redo();
  session.BeginGesture();
  session.Set([](Document& d) { d.search.evaluations += 1; });
  CHECK_FALSE(session.Search().WouldRepeat());
  session.BeginGesture();
  session.Synthesize();
  CHECK(host.started.back().search.seed == seed + 2);
  End(session, host, 33000);
  session.Layout().locked[static_cast<std::size_t>(LockedPart::kSearch)] = true;
  session.BeginGesture();
  session.Synthesize();
  CHECK(host.started.back().search.seed == seed + 2);
}

TEST_CASE("session: a failed search does not stop the queue, and is listed in the results",
          "[shell][session][queue]") {
  QuietHost host;
  Session session(host);
  QueueThree(session);
  REQUIRE(session.Queue().Run());
  session.OnSearchProgress({.state = SearchState::kFailed, .curve = {}, .best_genome = {}});
  REQUIRE(host.started.size() == 2);
  CHECK(session.Notice().find("failed") != std::string::npos);
  Report(session, host, 20000, SearchState::kRunning);
  session.OnSearchProgress({.state = SearchState::kFailed, .curve = {}, .best_genome = {}});
  REQUIRE(host.started.size() == 3);
  Report(session, host, 20000, SearchState::kDone);
  const auto found = Newest(session);
  REQUIRE(found.size() == 3);
  CHECK(found[0]->motion.origin == Origin::kDone);
  CHECK(found[1]->motion.origin == Origin::kFailed);
  CHECK(found[1]->motion.Moves());  // its result is kept
  CHECK(found[2]->motion.origin == Origin::kFailed);
  CHECK_FALSE(found[2]->motion.Moves());
  REQUIRE(session.ShowFound(found[2]->id));
  CHECK(SameSearch(session.Doc(), host.started[0]));
}

TEST_CASE("session: after Stop the others wait until Run", "[shell][session][queue]") {
  QuietHost host;
  Session session(host);
  QueueThree(session);
  REQUIRE(session.Queue().Run());
  Report(session, host, 20000, SearchState::kRunning);
  session.Stop();
  REQUIRE(Newest(session).size() == 1);
  Report(session, host, 25000, SearchState::kStopped);  // the workers' final report is a little further
  session.Queue().Resume();
  CHECK(host.started.size() == 1);
  CHECK_FALSE(session.Search().Running());
  REQUIRE(Newest(session).size() == 1);
  CHECK(Newest(session)[0]->motion.origin == Origin::kStopped);
  CHECK(Newest(session)[0]->motion.document.controllers[0].genes[0] == 25000);
  CHECK(Newest(session)[0]->motion.evaluations == 50);
  CHECK(session.Queue().List().Waiting().size() == 2);
  CHECK(session.Notice().find("2 searches wait until") != std::string::npos);
  REQUIRE(session.Queue().Run());
  CHECK(session.Notice().empty());
  CHECK(host.started.size() == 2);
  CHECK_FALSE(session.Queue().Run());
  CHECK(host.started.size() == 2);
  // A search that the host stopped also leaves the others waiting.
  Report(session, host, 20000, SearchState::kStopped);
  CHECK_FALSE(session.Search().Running());
  CHECK(host.started.size() == 2);
}

TEST_CASE("session: actions on the open document do not affect a search of the queue",
          "[shell][session][queue]") {
  QuietHost host;
  Session session(host);
  QueueThree(session);
  REQUIRE(session.Queue().Run());
  Report(session, host, 20000, SearchState::kRunning);
  session.BeginGesture();
  session.New();
  session.Undo();
  session.Redo();
  session.BeginGesture();
  session.ChooseFigure(1);
  REQUIRE(session.Open(EncodeJson(session.Shipped().Problems()[4])));
  CHECK(host.stops == 0);
  CHECK(session.Search().RunsQueued());
  CHECK(session.Search().Progress().evaluations == 50);
  const std::string before = State(session);
  Report(session, host, 30000, SearchState::kDone);
  CHECK(host.started.size() == 2);
  CHECK(State(session) == before);
  CHECK(Newest(session).size() == 1);
}

TEST_CASE("session: a search of the queue that equals the open document's search is shown as it improves",
          "[shell][session][queue]") {
  QuietHost host;
  Session session(host);
  session.ChooseProblem(0);
  session.BeginGesture();
  const std::string before = State(session);
  REQUIRE(session.Queue().Add(session.Doc()));
  REQUIRE(session.Queue().Run());
  Report(session, host, 20000, SearchState::kRunning);
  REQUIRE(session.Search().ShowImprovement(10.0));
  CHECK(session.Timeline().ShownController() != nullptr);
  SECTION("and its end is one step") {
    Report(session, host, 30000, SearchState::kDone);
    CHECK(session.Results().IsShown(*Newest(session)[0]));
    session.Undo();
    CHECK(State(session) == before);
  }
  SECTION("until what it has found is taken back") {
    session.Undo();
    Report(session, host, 30000, SearchState::kDone);
    CHECK(State(session) == before);
    CHECK(Newest(session).size() == 1);
  }
  SECTION("until the document asks for something else") {
    session.BeginGesture();
    session.Set([](Document& d) { d.task.kind = TaskKind::kJump; });
    const std::string changed = State(session);
    Report(session, host, 30000, SearchState::kDone);
    CHECK(State(session) == changed);
    CHECK(Newest(session)[0]->motion.document.task.kind == TaskKind::kTravel);
  }
  SECTION("until it is changed by hand") {
    session.BeginGesture();
    REQUIRE(session.Timeline().ChangeController([](Controller& c) { c.genes[0] = 7; }));
    const std::string changed = State(session);
    Report(session, host, 30000, SearchState::kDone);
    CHECK(State(session) == changed);
  }
}

TEST_CASE("session: the queue continues after the document's own search, ended or interrupted",
          "[shell][session][queue]") {
  QuietHost host;
  Session session(host);
  session.ChooseProblem(0);
  session.Search().Synthesize();
  QueueThree(session);
  Report(session, host, 20000, SearchState::kDone);
  REQUIRE(host.started.size() == 2);
  CHECK(session.Search().RunsQueued());
  session.Search().Synthesize();  // stops the queue's search
  CHECK_FALSE(session.Search().RunsQueued());
  CHECK(host.started.size() == 3);
  session.BeginGesture();
  session.New();
  CHECK_FALSE(session.Search().Running());
  session.Queue().Resume();
  CHECK(session.Search().RunsQueued());
  CHECK(host.started.size() == 4);
}

TEST_CASE("session: queueing five seeds twice adds ten different seeds", "[shell][session][queue]") {
  QuietHost host;
  Session session(host);
  session.ChooseProblem(0);
  session.Set([](Document& d) { d.search.seed = 3; });
  session.Search().Synthesize();  // with seed 3
  CHECK(session.Queue().AddSeeds(kQueuedSeeds) == 5);
  CHECK(session.Queue().AddSeeds(kQueuedSeeds) == 5);
  std::uint32_t seed = 3;
  for (const SearchQueue::Entry& entry : session.Queue().List().Waiting())
    CHECK(entry.document.search.seed == ++seed);
  CHECK(session.Doc().search.seed == 3);
  while (session.Queue().AddSeeds(kQueuedSeeds) == kQueuedSeeds) {
  }
  CHECK(session.Queue().List().Waiting().size() == SearchQueue::kMax);
  CHECK(session.Notice().find("50") != std::string::npos);
}

TEST_CASE("session: the lab and the queue wait for each other", "[shell][session][queue]") {
  QuietHost host;
  Session session(host);
  REQUIRE(session.Lab().Start(session.Lab().Trials().settings));
  QueueThree(session);
  CHECK_FALSE(session.Queue().Run());
  session.Lab().Stop();
  REQUIRE(session.Queue().Run());
  CHECK_FALSE(session.Lab().Start(session.Lab().Trials().settings));
}

TEST_CASE("session: every search with a result is in the results, and Keep marks it",
          "[shell][session][found]") {
  QuietHost host;
  Session session(host);
  session.ChooseProblem(0);
  CHECK_FALSE(session.Results().KeepShown());
  session.Search().Synthesize();
  session.Stop();
  CHECK(session.Results().Motions().Empty());  // nothing was found
  session.Search().Synthesize();
  Report(session, host, 30000, SearchState::kDone);
  REQUIRE(session.Results().Motions().Count() == 1);
  const std::string id = Newest(session)[0]->id;
  CHECK(session.Results().IsShown(*Newest(session)[0]));
  CHECK_FALSE(Newest(session)[0]->motion.kept);
  REQUIRE(session.Results().KeepShown());
  REQUIRE(session.Results().Motions().Count() == 1);
  CHECK(Newest(session)[0]->motion.kept);
  CHECK(Newest(session)[0]->motion.origin == Origin::kDone);
  // An edit by hand makes another motion.
  session.BeginGesture();
  REQUIRE(session.Timeline().ChangeController([](Controller& c) { c.genes[0] = 7; }));
  REQUIRE(session.Results().KeepShown());
  REQUIRE(session.Results().Motions().Count() == 2);
  CHECK(Newest(session)[0]->motion.origin == Origin::kByHand);
  CHECK(host.stored[id].find("\"kept\":true") != std::string::npos);
  session.Results().Motions().Remove(id);
  CHECK(host.stored[id].empty());
}

TEST_CASE("commands: those of queue and results are unavailable with a reason, or work",
          "[shell][commands]") {
  QuietHost host;
  Session session(host);
  const auto command = [&](std::string_view id) {
    const auto list = CommandsOf(session, false);
    const auto found = std::ranges::find(list, id, &Command::id);
    REQUIRE(found != list.end());
    return *found;
  };
  CHECK_FALSE(command("queue/run").why_not.empty());
  CHECK_FALSE(command("queue/clear").why_not.empty());
  CHECK_FALSE(command("found/best").why_not.empty());
  CHECK_FALSE(command("found/bring-back").why_not.empty());
  command("queue/add").run();
  command("queue/seeds").run();
  CHECK(session.Queue().List().Waiting().size() == 6);
  command("queue/run").run();
  CHECK(session.Search().RunsQueued());
  CHECK_FALSE(command("queue/run").why_not.empty());
  CHECK_FALSE(command("document/undo").why_not.empty());  // the queue's search did not change the document
  command("queue/clear").run();
  Report(session, host, 30000, SearchState::kDone);
  CHECK_FALSE(session.Search().Running());
  session.New();
  command("found/best").run();
  CHECK(session.Results().IsShown(*Newest(session)[0]));
  command("found/keep").run();
  CHECK(Newest(session)[0]->motion.kept);
}

TEST_CASE("commands: robust limits the joints, tries several worlds and searches; a lock forbids it",
          "[shell][commands]") {
  QuietHost host;
  Session session(host);
  const auto robust = [&] {
    const auto list = CommandsOf(session, false);
    return *std::ranges::find(list, "search/robust", &Command::id);
  };
  REQUIRE(session.Doc().model == 1);
  REQUIRE(robust().why_not.empty());
  robust().run();
  REQUIRE(host.started.size() == 1);
  CHECK(host.started.back().model > 1);
  CHECK(host.started.back().search.worlds == kRobustWorlds);
  CHECK(ProblemOf(host.started.back()).worlds.size() == kRobustWorlds - 1);
  CHECK_FALSE(robust().why_not.empty());  // it runs
  Report(session, host, 30000, SearchState::kDone);
  CHECK(session.Doc().search.worlds == kRobustWorlds);
  while (session.CanUndo()) session.Undo();
  CHECK(session.Doc().search.worlds == 1);
  CHECK(session.Doc().model == 1);
  for (const LockedPart part : {LockedPart::kSearch, LockedPart::kWorld}) {
    session.Layout().locked = {};
    session.Layout().locked[static_cast<std::size_t>(part)] = true;
    CHECK_FALSE(robust().why_not.empty());
  }
}

}  // namespace gaitsmith::shell::test
