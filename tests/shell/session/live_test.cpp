// SPDX-License-Identifier: MIT
// Live: what a person sees while changing something, and what the document becomes.
#include "shell/session/live.h"

#include <catch_amalgamated.hpp>

#include "core/document/goals.h"
#include "core/document/parts.h"
#include "core/document/standing.h"
#include "tests/shell/session/quiet_host.h"

namespace gaitsmith::shell::test {
namespace {

constexpr double kFrameS = 0.016;

void Wait(Session& session, double seconds) {
  for (double past = 0.0; past < seconds; past += kFrameS) session.Advance(kFrameS);
}

void Weigh(Session& session, float weight) {
  session.Set([&](Document& d) { d.task.weights[0] = weight; });
}

Genome GenesOf(const Session& session) { return session.Doc().controllers.front().genes; }

// Every gene of the shown controller, moved a little.
Genome Moved(const Session& session, Gene by) {
  Genome genes = GenesOf(session);
  for (Gene& gene : genes) gene = static_cast<Gene>(gene ^ by);
  return genes;
}

void Report(Session& session, SearchState state, const Genome& best) {
  session.OnSearchProgress({.state = state,
                            .evaluations = 50,
                            .budget = 50,
                            .best_fitness = 1.0f,
                            .curve = {},
                            .best_genome = best});
}

struct Drag {
  QuietHost host;
  Session session{host};

  Drag() {
    session.BeginGesture();
    session.Following().Hold(true);
  }
};

}  // namespace

TEST_CASE_METHOD(Drag, "Live searches on while a slider is held, and shows what it finds", "[live]") {
  const Genome own = GenesOf(session);
  const auto played = session.Player().Shown().Hash();
  Weigh(session, 0.5f);
  Wait(session, 0.1);
  REQUIRE(host.previews.size() == 1);
  CHECK(host.previews[0].task.weights[0] == 0.5f);
  CHECK(host.started.empty());

  const Genome better = Moved(session, 1);
  Report(session, SearchState::kRunning, better);
  Wait(session, 0.3);
  CHECK(session.Following().Previewing());
  CHECK(session.Player().Shown().Hash() != played);
  CHECK(GenesOf(session) == own);  // the document is not a preview
  CHECK(*session.WithHash().hash == Simulate(session.Doc()).Hash());

  Weigh(session, 0.7f);
  Wait(session, 0.2);
  REQUIRE(host.previews.size() == 2);
  const Document& second = host.previews[1];
  CHECK(second.task.weights[0] == 0.7f);
  CHECK(second.controllers[static_cast<std::size_t>(second.search.start)].genes == better);
}

TEST_CASE_METHOD(Drag, "The end of a drag does not depend on the previews", "[live]") {
  Weigh(session, 0.5f);
  Wait(session, 0.1);
  Report(session, SearchState::kRunning, Moved(session, 1));
  Wait(session, 0.3);
  session.Following().Hold(false);
  Wait(session, 0.05);

  QuietHost slow_host;
  Session slow(slow_host);
  slow.BeginGesture();
  Weigh(slow, 0.5f);
  Wait(slow, 0.3);
  REQUIRE(slow_host.previews.size() == 1);  // by keys: nothing is held
  CHECK(SameParts(host.previews.back(), slow_host.previews.back(), AllParts()));
  CHECK(host.previews.back().search.evaluations == Live::kEvaluations);
}

TEST_CASE_METHOD(Drag, "A drag and the motion found at its end are one step of Undo", "[live]") {
  const std::string before = State(session);
  Weigh(session, 0.3f);
  Wait(session, 0.1);
  Weigh(session, 0.5f);
  Wait(session, 0.3);
  Report(session, SearchState::kRunning, Moved(session, 1));  // too late to be shown
  session.Following().Hold(false);
  Wait(session, 0.05);
  const Genome found = Moved(session, 3);
  Report(session, SearchState::kDone, found);
  Wait(session, 1.0);
  CHECK(GenesOf(session) == found);
  CHECK(session.Doc().task.weights[0] == 0.5f);
  CHECK_FALSE(session.Following().Previewing());
  CHECK(session.Results().Motions().Sorted(FoundMotions::Order::kNewest).size() == 1);
  session.Undo();
  CHECK(State(session) == before);
  CHECK_FALSE(session.CanUndo());
}

TEST_CASE_METHOD(Drag, "Undo during a preview takes back the drag and shows the document", "[live]") {
  const std::string before = State(session);
  const auto played = session.Player().Shown().Hash();
  Weigh(session, 0.5f);
  Wait(session, 0.1);
  Report(session, SearchState::kRunning, Moved(session, 1));
  Wait(session, 0.3);
  session.Undo();
  CHECK(State(session) == before);
  CHECK(session.Player().Shown().Hash() == played);
  session.Following().Hold(false);
  Wait(session, 1.0);
  CHECK(State(session) == before);
  CHECK(host.previews.size() == 1);
}

TEST_CASE_METHOD(Drag, "Gravity and limbs are followed, a push is not", "[live]") {
  session.Change([](Document& d) { d.environment.gravity_mps2 = 3.0f; });
  Wait(session, 0.1);
  CHECK(host.previews.size() == 1);
  Figure longer = session.Doc().figure;
  longer.rods.back().length_m *= 1.2f;
  session.ReplaceFigure(longer);
  Wait(session, 0.2);
  REQUIRE(host.previews.size() == 2);
  CHECK(host.previews[1].figure.rods.back().length_m == longer.rods.back().length_m);

  QuietHost other_host;
  Session other(other_host);
  other.BeginGesture();
  other.World().Shove();
  Wait(other, 1.0);
  CHECK(other_host.previews.empty());
}

TEST_CASE("A new goal is searched for from nothing, with the same budget everywhere", "[live]") {
  QuietHost host;
  Session session(host);
  session.BeginGesture();
  session.ChangeGoal([](Document& d) { SetGoal(Goal::kHighJump, d); });
  REQUIRE(host.previews.size() == 1);
  CHECK(host.previews[0].search.start == -1);
  CHECK(host.previews[0].search.evaluations == kQuickEvaluations);
  const std::string goal = State(session);
  session.ChangeGoal([](Document& d) { SetGoal(Goal::kHighJump, d); });
  Wait(session, 1.0);
  CHECK(host.previews.size() == 1);  // the same goal again changes nothing
  CHECK(State(session) == goal);
}

TEST_CASE("Live keeps out of the way", "[live]") {
  QuietHost host;
  Session session(host);
  const auto edit = [&] {
    session.BeginGesture();
    Weigh(session, session.Doc().task.weights[0] + 0.1f);
    Wait(session, 1.0);
    return host.previews.size();
  };
  SECTION("of a person who switched it off") {
    session.Following().Switch(false);
    CHECK(edit() == 0);
    session.Following().Switch(true);
    CHECK(edit() == 1);
  }
  SECTION("of a lesson, which shows a part of the page") {
    session.Layout().shown[0] = false;
    CHECK(edit() == 0);
    session.Following().Switch(true);
    CHECK(edit() == 1);
  }
  SECTION("of a search that a person started") {
    session.Synthesize();
    CHECK(edit() == 0);
    CHECK(session.Search().Running());
  }
  SECTION("of a figure that cannot move yet") {
    REQUIRE(session.Begin(""));
    CHECK(edit() == 0);
  }
  SECTION("of a machine that does not keep up, three times in a row") {
    for (int i = 0; i < 3; ++i) {
      CHECK(session.Following().On());
      session.Following().Hold(true);
      session.BeginGesture();
      Weigh(session, session.Doc().task.weights[0] + 0.1f);
      Wait(session, 0.7);
      Report(session, SearchState::kDone, GenesOf(session));
      session.Following().Hold(false);
      Wait(session, 0.1);
      Report(session, SearchState::kDone, GenesOf(session));
    }
    CHECK_FALSE(session.Following().On());
  }
}

TEST_CASE_METHOD(Drag, "What another search or document makes is never replaced by a late preview",
                 "[live]") {
  Weigh(session, 0.5f);
  Wait(session, 0.1);
  Report(session, SearchState::kRunning, Moved(session, 1));
  Wait(session, 0.3);
  SECTION("another document") {
    session.New();
    const std::string opened = State(session);
    Report(session, SearchState::kDone, Genome(3, 1));
    Wait(session, 1.0);
    CHECK(State(session) == opened);
  }
  SECTION("a search") {
    session.Following().Hold(false);
    session.Synthesize();
    Wait(session, 0.1);
    CHECK_FALSE(session.Following().Previewing());
    const Genome found = Moved(session, 7);
    Report(session, SearchState::kDone, found);
    CHECK(GenesOf(session) == found);
  }
}

}  // namespace gaitsmith::shell::test
