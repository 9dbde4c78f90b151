// SPDX-License-Identifier: MIT
// A first visit: a figure that cannot move yet, its first search, attempts beside the best, and further
// tries.
#include <catch_amalgamated.hpp>
#include <cmath>
#include <set>

#include "core/document/goals.h"
#include "core/document/json.h"
#include "core/document/standing.h"
#include "core/document/style_weights.h"
#include "shell/words/figure_words.h"
#include "tests/shell/session/quiet_host.h"

namespace gaitsmith::shell::test {
namespace {

Genome GenomeOf(const Document& document, Gene gene) {
  return Genome(static_cast<std::size_t>(ProblemOf(document).Shape().Genes()), gene);
}

}  // namespace

TEST_CASE("first visit: a standing figure, plain metres, nothing to undo", "[shell][session]") {
  QuietHost host;
  Session session(host);
  REQUIRE(session.Begin(""));
  CHECK(session.Simple());
  CHECK(session.Doc().figure.name == "Ostrich");
  CHECK(session.Doc().timeline.empty());
  CHECK(session.Doc().task.kind == TaskKind::kTravelRight);
  for (const float weight : session.Doc().task.weights) CHECK(weight == 0.0f);
  CHECK_FALSE(session.CanUndo());
  CHECK_FALSE(session.Player().Playing());
  CHECK(host.status.empty());
  CHECK_FALSE(session.Begin("no-such-example"));
  REQUIRE(session.Begin("star-man-shuffle"));
  CHECK_FALSE(session.Simple());
  CHECK_FALSE(session.Doc().timeline.empty());
}

TEST_CASE("first visit: the first motion plays from its start, and the choices stay", "[shell][session]") {
  QuietHost host;
  Session session(host);
  REQUIRE(session.Begin(""));
  session.Synthesize();
  REQUIRE(host.started.size() == 1);
  End(session, host, 20000);
  CHECK(session.Simple());
  CHECK(session.Player().Playing());
  CHECK(session.Player().TimeS() == 0.0);
  // Also when the motion before was paused somewhere.
  session.Player().Play(false);
  session.Player().Seek(3.0);
  session.Synthesize();
  REQUIRE(host.started.size() == 2);
  CHECK(host.started[1].search.seed != host.started[0].search.seed);
  End(session, host, 30000);
  CHECK(session.Player().Playing());
  CHECK(session.Player().TimeS() == 0.0);
}

TEST_CASE("first visit: with reduced motion a still moment is shown", "[shell][session]") {
  QuietHost host;
  Session session(host);
  session.Player().SetCalm(true);
  REQUIRE(session.Begin(""));
  session.Synthesize();
  session.OnSearchProgress({.state = SearchState::kRunning,
                            .evaluations = 0,
                            .budget = 50,
                            .attempt = GenomeOf(session.Doc(), 9000)});
  CHECK(session.Tried().Shown().empty());
  End(session, host, 20000);
  CHECK_FALSE(session.Player().Playing());
  CHECK(session.Player().TimeS() > 0.0);
}

TEST_CASE("viewer: shows what links bring, until a person makes something", "[shell][session]") {
  QuietHost host;
  Session session(host);
  const std::string text = EncodeJson(session.Doc());
  const auto enter = [&] {
    REQUIRE(session.Open(text));
    session.EnterViewer();
    REQUIRE(session.Viewing());
  };
  enter();
  session.World().Shove();
  REQUIRE(session.Open(text));
  CHECK(session.Viewing());
  const int changes = host.changes;
  session.LeaveViewer();
  CHECK_FALSE(session.Viewing());
  CHECK(host.changes == changes + 1);  // the page follows
  session.LeaveViewer();
  CHECK(host.changes == changes + 1);
  enter();
  session.Synthesize();
  CHECK_FALSE(session.Viewing());
  enter();
  session.ChooseFigure(0);
  CHECK_FALSE(session.Viewing());
  // A figure that cannot move yet has nothing to watch.
  session.EnterViewer();
  CHECK_FALSE(session.Viewing());
}

TEST_CASE("attempts: the newest six play in time with the best, and go three seconds after the end",
          "[shell][session]") {
  QuietHost host;
  Session session(host);
  REQUIRE(session.Begin(""));
  session.Synthesize();
  for (int report = 0; report < 9; ++report) {
    session.OnSearchProgress({.state = SearchState::kRunning,
                              .evaluations = report,
                              .budget = 50,
                              .best_genome = GenomeOf(session.Doc(), 20000),
                              .attempt = GenomeOf(session.Doc(), static_cast<Gene>(3000 + 5000 * report))});
    for (int frame = 0; frame < 10; ++frame) session.Advance(0.02);
  }
  CHECK(session.Tried().Shown().size() <= Attempts::kMost);
  CHECK(session.Tried().Shown().size() >= 2);
  for (const Playback& one : session.Tried().Shown()) CHECK(one.TimeS() == session.Player().TimeS());
  End(session, host, 20000);
  for (int frame = 0; frame < 100; ++frame) session.Advance(0.02);
  CHECK_FALSE(session.Tried().Shown().empty());
  for (int frame = 0; frame < 60; ++frame) session.Advance(0.02);
  CHECK(session.Tried().Shown().empty());
}

TEST_CASE("attempts: Undo in the middle of a search takes them away", "[shell][session]") {
  QuietHost host;
  Session session(host);
  REQUIRE(session.Begin(""));
  session.Synthesize();
  session.OnSearchProgress({.state = SearchState::kRunning,
                            .evaluations = 0,
                            .budget = 50,
                            .best_genome = GenomeOf(session.Doc(), 20000),
                            .attempt = GenomeOf(session.Doc(), 30000)});
  session.Advance(0.02);
  REQUIRE_FALSE(session.Doc().timeline.empty());
  REQUIRE_FALSE(session.Tried().Shown().empty());
  session.BeginGesture();
  session.Undo();
  CHECK(session.Doc().timeline.empty());
  CHECK(session.Tried().Shown().empty());
}

TEST_CASE("first visit: once all panels are shown they stay, and what is opened moves", "[shell][session]") {
  QuietHost host;
  Session session(host);
  REQUIRE(session.Begin(""));
  session.Synthesize();
  End(session, host, 20000);
  session.ShowAll();
  session.New();
  CHECK(session.Doc().timeline.empty());
  CHECK_FALSE(session.Simple());
  CHECK_FALSE(session.Player().Playing());
  session.BeginGesture();
  session.Undo();
  CHECK_FALSE(session.Doc().timeline.empty());
  CHECK(session.Player().Playing());
}

TEST_CASE("attempts: one that does not fit the search is left out", "[shell][session]") {
  Attempts attempts;
  const Document searched = Standing(ShippedDocuments().Figures()[0]);
  attempts.Begin(searched);
  attempts.Add({}, 1.0);
  attempts.Add(Genome(3, 0), 2.0);
  CHECK(attempts.Shown().empty());
  attempts.Add(GenomeOf(searched, 20000), 3.0);
  attempts.Add(GenomeOf(searched, 30000), 3.05);  // too soon to be told apart
  CHECK(attempts.Shown().size() == 1);
}

TEST_CASE(
    "tries: calmer, quicker and higher change one weight so that it is seen, and search on from the motion",
    "[shell][session]") {
  QuietHost host;
  Session session(host);
  REQUIRE(session.Begin(""));
  session.Synthesize();
  End(session, host, 20000);
  const auto effort = static_cast<std::size_t>(StyleTerm::kEffort);
  const auto height = static_cast<std::size_t>(StyleTerm::kMaxCmHeight);
  const StyleWeights usual = UsualWeights(session.Doc());
  session.BeginGesture();
  session.TryManner(Manner::kCalmer);
  REQUIRE(host.started.size() == 2);
  CHECK(host.started[1].task.weights[effort] == -3.0f * usual[effort]);
  CHECK(host.started[1].search.algorithm == Algorithm::kPoseCycle);
  CHECK(host.started[1].search.start >= 0);
  End(session, host, 21000);
  session.BeginGesture();
  session.TryManner(Manner::kQuicker);
  CHECK(host.started.back().task.weights[effort] == 0.0f);
  End(session, host, 22000);
  session.BeginGesture();
  session.TryManner(Manner::kHigher);
  CHECK(host.started.back().task.weights[height] == usual[height]);
  CHECK(session.Comparison().Other().Source() == Ghost::Kind::kEarlier);
}

TEST_CASE("tries: one step of Undo takes back another try, or a calmer one, with its seed or weight",
          "[shell][session]") {
  QuietHost host;
  Session session(host);
  REQUIRE(session.Begin(""));
  session.Synthesize();
  End(session, host, 20000);
  for (const bool calmer : {false, true}) {
    CAPTURE(calmer);
    const std::string before = State(session);
    calmer ? session.TryManner(Manner::kCalmer) : session.Synthesize();
    End(session, host, calmer ? 21000 : 22000);
    CHECK(State(session) != before);
    session.Undo();
    CHECK(State(session) == before);
    session.Redo();
    session.Undo();
    CHECK(State(session) == before);
  }
  session.Undo();
  CHECK(session.Doc().timeline.empty());
}

TEST_CASE("results: one that is shown has its own goal, or keeps that of the open document",
          "[shell][session]") {
  QuietHost host;
  Session session(host);
  REQUIRE(session.Begin(""));
  session.Synthesize();
  End(session, host, 20000);
  const std::string id = session.Results().Motions().Sorted(FoundMotions::Order::kNewest).front()->id;
  const std::uint64_t motion = session.Player().Shown().Hash();
  session.BeginGesture();
  session.Set([](Document& d) { SetGoal(Goal::kCalm, d); });
  session.BeginGesture();
  REQUIRE(session.ShowFound(id, NextGoal::kOfOpen));
  CHECK(GoalOf(session.Doc()) == Goal::kCalm);
  CHECK(session.Player().Shown().Hash() == motion);
  session.Set([](Document& d) { d.task.weights[0] = 0.7f; });
  REQUIRE(session.ShowFound(id, NextGoal::kOfOpen));
  CHECK(session.Doc().task.weights[0] == 0.7f);  // a person's own mix
  REQUIRE(session.ShowFound(id));
  CHECK(GoalOf(session.Doc()) == Goal::kFar);
  CHECK_FALSE(session.ShowFound("no-such-result", NextGoal::kOfOpen));
}

TEST_CASE("tries: five more are five other seeds, and begin at once", "[shell][session]") {
  QuietHost host;
  Session session(host);
  REQUIRE(session.Begin(""));
  session.Synthesize();
  End(session, host, 20000);
  session.TryMore();
  REQUIRE(host.started.size() == 2);
  CHECK(session.Queue().List().Waiting().size() == 4);
  std::set<std::uint32_t> seeds = {host.started[0].search.seed, host.started[1].search.seed};
  for (const SearchQueue::Entry& entry : session.Queue().List().Waiting())
    seeds.insert(entry.document.search.seed);
  CHECK(seeds.size() == 6);
}

TEST_CASE("world: a shove is against the movement, late ones come earlier", "[shell][session]") {
  QuietHost host;
  Session session(host);
  Playback& player = session.Player();
  player.Play(false);
  player.Seek(2.0);
  const double moves = player.CentreAt(2.0).x_m - player.CentreAt(1.5).x_m;
  session.World().Shove();
  REQUIRE(session.Doc().pushes.size() == 1);
  const Push& push = session.Doc().pushes[0];
  CHECK(push.endpoint == kCentreOfMass);
  CHECK(static_cast<double>(push.impulse_x_ns) * moves < 0.0);
  CHECK(push.step == 200);
  CHECK(player.Playing());
  player.Seek(player.DurationS());
  session.BeginGesture();
  session.World().Shove();
  REQUIRE(session.Doc().pushes.size() == 2);
  CHECK(session.Doc().pushes[1].step * static_cast<double>(kStep) < 0.5 * player.DurationS());
}

TEST_CASE("figure words: every shipped figure has a sentence and a button", "[shell]") {
  const ShippedDocuments shipped;
  for (const Figure& figure : shipped.Figures()) {
    CAPTURE(figure.name);
    CHECK(CannotMoveWords(figure.name).ends_with(" can’t move yet."));
    Document standing = Standing(figure);
    CHECK(std::string_view(TeachWords(standing)).starts_with("Teach it to "));
    SetGoal(Goal::kHighJump, standing);
    CHECK(std::string_view(TeachWords(standing)) == "Teach it to jump");
  }
  CHECK(CannotMoveWords("Ostrich, mirrored") == "This ostrich can’t move yet.");
  CHECK(CannotMoveWords("My figure") == "My figure can’t move yet.");
}

}  // namespace gaitsmith::shell::test
