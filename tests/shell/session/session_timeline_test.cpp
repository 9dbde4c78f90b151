// SPDX-License-Identifier: MIT
// Chaining clips by hand: edits, Undo, and searches during edits.
#include <catch_amalgamated.hpp>

#include "core/document/joints.h"
#include "shell/words/motion_name.h"
#include "shell/words/wording.h"
#include "tests/scene.h"
#include "tests/shell/session/quiet_host.h"

namespace gaitsmith::shell::test {
namespace {

std::vector<int> Starts(const Session& session) {
  std::vector<int> starts;
  starts.reserve(session.Doc().timeline.size());
  for (const Clip& clip : session.Doc().timeline) starts.push_back(clip.start_step);
  return starts;
}

}  // namespace

TEST_CASE("session: clips can be chained, and every edit undone", "[shell][session][timeline]") {
  QuietHost host;
  Session session(host);
  REQUIRE(session.Doc().timeline.size() == 1);
  const int length = session.Doc().duration_steps;
  std::vector<std::string> states = {State(session)};
  const auto step = [&](auto act) {
    session.BeginGesture();
    act();
    CHECK(State(session) != states.back());
    states.push_back(State(session));
  };
  step([&] { session.Timeline().AddClip(); });
  CHECK(session.Timeline().Selected() == 1);
  CHECK(session.Doc().duration_steps == length + session.Doc().task.duration_steps);
  step([&] { session.Timeline().MirrorClip(); });
  CHECK(session.Doc().controllers.size() == 2);
  step([&] { session.Timeline().MoveClip(1, 333); });
  CHECK(Starts(session) == std::vector{0, 333});
  session.Player().Seek(1.5);
  step([&] { session.Timeline().SplitClip(); });
  CHECK(Starts(session) == std::vector{0, 150, 333});
  CHECK(session.Timeline().Selected() == 1);
  step([&] { session.Timeline().ReorderClip(2); });
  CHECK(session.Timeline().Selected() == 2);
  step([&] { session.Timeline().DuplicateClip(); });
  step([&] { session.Timeline().SetClipLength(0, 40); });
  CHECK(Starts(session)[1] == 40);
  step([&] { session.Timeline().RemoveClip(); });
  step([&] { session.Timeline().Repeat(); });
  CHECK(session.Doc().timeline.size() == 6);
  CHECK(Validate(session.Doc()));
  for (std::size_t i = states.size() - 1; i > 0; --i) {
    session.Undo();
    CHECK(State(session) == states[i - 1]);
  }
  session.Redo();
  CHECK(State(session) == states[1]);
}

TEST_CASE("session: an edit that does not fit the timeline changes nothing and reports why",
          "[shell][session][timeline]") {
  QuietHost host;
  Session session(host);
  for (int i = 0; i < 8; ++i) session.Timeline().Repeat();
  CHECK(session.Doc().duration_steps <= kMaxSteps);
  CHECK(session.Notice().starts_with("Not possible: at most 120 s"));
  const std::string before = State(session);
  session.Player().Seek(0.05);
  session.Timeline().SplitClip();
  CHECK(session.Notice() ==
        "Not possible: both parts of a clip must last at least 0.2 s, and this is too close to its end.");
  session.Timeline().ReorderClip(-1);
  session.Timeline().ReorderClip(10000);
  CHECK_FALSE(session.Timeline().InsertFound("nothing"));
  CHECK(State(session) == before);
}

TEST_CASE("session: an edit ends the search of a clip and keeps its result", "[shell][session][timeline]") {
  QuietHost host;
  Session session(host);
  session.Search().Synthesize();
  SearchProgress progress{
      .state = SearchState::kRunning, .evaluations = 10, .budget = 50, .curve = {}, .best_genome = {}};
  progress.best_genome.assign(ProblemOf(host.started.back()).Shape().Genes(), 777);
  progress.best_fitness = 1.0;
  session.OnSearchProgress(progress);
  session.Timeline().DuplicateClip();
  CHECK_FALSE(session.Search().Running());
  REQUIRE(session.Doc().timeline.size() == 2);
  CHECK(session.Timeline().ShownController()->genes.front() == 777);
  session.Undo();
  CHECK(session.Doc().timeline.size() == 1);
  CHECK(session.Timeline().ShownController()->genes.front() == 777);
}

TEST_CASE("session: a result is inserted at the shown moment", "[shell][session][timeline]") {
  QuietHost host;
  Session session(host);
  session.Search().Synthesize();
  End(session, host, 20000);
  const std::string id = session.Results().Motions().Sorted(FoundMotions::Order::kNewest).front()->id;
  session.Undo();  // the result stays in the list
  const int steps = session.Doc().duration_steps;
  session.Player().Seek(2.0);
  REQUIRE(session.Timeline().InsertFound(id));
  CHECK(Starts(session) == std::vector{0, 200, 200 + session.Doc().task.duration_steps});
  CHECK(session.Timeline().Selected() == 1);
  CHECK(session.Timeline().ShownController()->genes.front() == 20000);
  session.Undo();
  session.Player().Seek(session.Player().DurationS());
  REQUIRE(session.Timeline().InsertFound(id));
  CHECK(Starts(session) == std::vector{0, steps});

  const Figure other = session.Shipped().Figures()[0].rods.size() == session.Doc().figure.rods.size()
                           ? session.Shipped().Figures()[1]
                           : session.Shipped().Figures()[0];
  REQUIRE_FALSE(SameTree(other, session.Doc().figure));
  session.ReplaceFigure(other);
  const std::string before = State(session);
  CHECK_FALSE(session.Timeline().InsertFound(id));
  CHECK(session.Notice().find("another figure") != std::string::npos);
  CHECK(State(session) == before);
}

TEST_CASE("session: a result with other joints moves as the open document does, and the session says so",
          "[shell][session][timeline]") {
  QuietHost host;
  Session session(host);
  session.World().LimitJoints(true);
  session.World().SetJointStrength(5.0f);
  session.Search().Synthesize();
  CHECK(host.started.back().model == 2);
  End(session, host, 20000);
  const std::string limited = session.Results().Motions().Sorted(FoundMotions::Order::kNewest).front()->id;
  REQUIRE(session.Timeline().InsertFound(limited));
  CHECK(session.Notice().empty());
  CHECK(Simulate(session.Doc()).Hash() == session.Player().Shown().Hash());
  session.Undo();

  session.BeginGesture();
  session.World().LimitJoints(false);
  const std::string before = State(session);
  session.BeginGesture();
  REQUIRE(session.Timeline().InsertFound(limited));
  CHECK(session.Notice() ==
        "This motion was found with joints of another strength. It may move differently here.");
  CHECK(session.Doc().model == 1);
  CHECK(Validate(session.Doc()));
  CHECK(Simulate(session.Doc()).Hash() == session.Player().Shown().Hash());
  session.Undo();
  CHECK(State(session) == before);
  session.Undo();
  CHECK(session.Doc().model == 2);
  CHECK(JointStrength(session.Doc()) == 5.0f);
}

TEST_CASE("session: clips of searches are named for what they do, and typed names stay",
          "[shell][session][timeline]") {
  QuietHost host;
  Session session(host);
  session.Search().Synthesize();
  End(session, host, 20000);
  const auto name = [&] { return session.Timeline().ShownController()->name; };
  CHECK_FALSE(name().empty());
  CHECK(name() == MotionName(session.Doc(), 0));
  CHECK(session.Doc().title.find(", seed ") != std::string::npos);
  const FoundMotions& results = session.Results().Motions();
  const std::string id = results.Sorted(FoundMotions::Order::kNewest).front()->id;
  CHECK(results.Find(id)->motion.document.controllers.back().name == name());

  // The image of a named motion is named anew, unless a person named the motion.
  session.Undo();
  session.Change([](Document& d) { d.controllers[0].name = MotionName(d, 0); });
  const std::string right = name();
  CHECK(right == "Move right");
  session.Timeline().AddClip();
  session.Timeline().MirrorClip();
  CHECK(name() == "Move left");
  session.Timeline().MirrorClip();
  CHECK(name() == right);
  session.Change([](Document& d) { d.controllers.back().name = "My own"; });
  session.Timeline().MirrorClip();
  CHECK(name() == "My own, mirrored");

  CHECK(session.Results().Motions().Rename(id, "Sprint").empty());
  REQUIRE(session.Timeline().InsertFound(id));
  CHECK(name() == "Sprint");
}

TEST_CASE("session: a repair searches from the state at the takeover", "[shell][session][timeline]") {
  QuietHost host;
  Session session(host);
  session.Timeline().RepairClip();
  CHECK(host.started.empty());
  CHECK(session.Notice() == "Only a clip that takes over from another one can be repaired.");
  session.Timeline().AddClip();
  session.Timeline().MoveClip(1, 321);
  const std::size_t results = session.Results().Motions().Sorted(FoundMotions::Order::kNewest).size();
  session.Timeline().RepairClip();
  REQUIRE(host.started.size() == 1);
  const Document& wanted = host.started[0];
  REQUIRE(Validate(wanted));
  CHECK(wanted.search.in_place_of == 1);
  CHECK(wanted.search.start >= 0);
  const auto problem = ProblemOf(wanted);
  REQUIRE(problem.beginnings.size() == 1);
  CHECK(problem.beginnings[0].steps == 321);
  End(session, host, 12345);
  CHECK(session.Doc().timeline[1].controller != session.Doc().timeline[0].controller);
  CHECK(session.Timeline().ShownController()->genes.front() == 12345);
  CHECK(session.Doc().search.in_place_of == -1);
  CHECK(session.Results().Motions().Sorted(FoundMotions::Order::kNewest).size() == results);
}

TEST_CASE("session: a clip snaps to the nearest good moment of its transition map",
          "[shell][session][timeline]") {
  QuietHost host;
  Session session(host);
  CHECK_FALSE(session.Timeline().Transitions().Scores().Any());
  session.Timeline().SnapToBest();
  CHECK(session.Notice() == "The first clip takes over from no other clip.");
  session.BeginGesture();
  session.Timeline().AddClip();
  REQUIRE(session.Timeline().Transitions().Scores().Any());
  session.Timeline().Transitions().Advance(0.1);
  CHECK(host.mapped.empty());  // more changes may follow
  session.Timeline().Transitions().Advance(0.2);
  REQUIRE(host.mapped.size() == 1);
  CHECK(Validate(host.mapped[0]));
  session.Timeline().Transitions().Advance(10.0);
  CHECK(host.mapped.size() == 1);

  const std::vector<int>& steps = session.Timeline().Transitions().Scores().Steps();
  const auto count = static_cast<int>(steps.size());
  const std::vector<int> order = CoarseFirst(count);
  std::vector<float> scores(steps.size(), 1.0f);
  scores[3] = 4.0f;
  const int best = steps[static_cast<std::size_t>(order[3])];
  const auto part = [&](int generation, int first, int size) {
    return TransitionPart{.generation = generation,
                          .first = first,
                          .usual = 5.0f,
                          .scores = {scores.begin() + first, scores.begin() + first + size}};
  };
  const int generation = host.generations[0];
  session.Timeline().Transitions().OnScores(part(generation - 1, 0, count));
  session.Timeline().Transitions().OnScores(
      {.generation = generation, .first = -1, .usual = 1.0f, .scores = {1.0f}});
  session.Timeline().Transitions().OnScores(
      {.generation = generation, .first = count, .usual = 1.0f, .scores = {1.0f}});
  CHECK(session.Timeline().Transitions().Scores().Known() == 0);
  session.Timeline().Transitions().OnScores(part(generation, 0, 10));
  session.Timeline().Transitions().OnScores(part(generation, 0, 10));  // reported twice
  CHECK(session.Timeline().Transitions().Scores().Known() == 10);
  CHECK(session.Timeline().Transitions().Scores().Share(order[3]) == 0.8f);
  CHECK_FALSE(session.Timeline().Transitions().Scores().Share(order[10]));
  const std::string before = State(session);
  session.Timeline().SnapToBest();
  CHECK(session.Notice() == "The transition map is not complete yet.");
  CHECK(State(session) == before);
  session.Timeline().Transitions().OnScores(part(generation, 10, count - 10));

  session.BeginGesture();
  CHECK(session.Timeline().MapComplete());
  session.Timeline().SnapToBest();
  CHECK(Starts(session) == std::vector{0, best});
  CHECK(host.status ==
        "Switch moved to " + Fixed(static_cast<float>(best) * kStep, 2) + " s, the nearest good moment.");
  session.Timeline().Transitions().Advance(10.0);
  CHECK(host.mapped.size() == 1);  // its inputs have not changed
  CHECK(session.Timeline().Transitions().Scores().Known() == count);
  CHECK(std::string(session.Timeline().WhyNoSnap()) == "The switch is at a good moment already.");
  session.Undo();
  CHECK(State(session) == before);
  CHECK(session.Timeline().Transitions().Scores().Known() == count);
}

TEST_CASE("session: of good moments the nearest is taken, and none if there is none",
          "[shell][session][timeline]") {
  QuietHost host;
  Session session(host);
  session.Timeline().AddClip();
  const auto map = [&](float everywhere, int at, float there) {
    session.Change([](Document& d) { d.environment.gravity_mps2 += 0.1f; });
    session.Timeline().Transitions().Advance(1.0);
    const std::vector<int> order =
        CoarseFirst(static_cast<int>(session.Timeline().Transitions().Scores().Steps().size()));
    std::vector<float> scores;
    scores.reserve(order.size());
    for (const int index : order)
      scores.push_back(index == at ? there : index == 0 ? everywhere + 5.0f : everywhere);
    session.Timeline().Transitions().OnScores(
        {.generation = host.generations.back(), .first = 0, .usual = 10.0f, .scores = scores});
  };
  const TransitionScores& scores = session.Timeline().Transitions().Scores();
  const int start = session.Doc().timeline[1].start_step;
  map(7.9f, 40, 8.0f);  // the first moment is better, and farther away
  CHECK(scores.Best() == 0);
  CHECK(scores.NearestGood(start) == 40);
  CHECK(session.Timeline().Transitions().ShareAtStart() == scores.Share(scores.Nearest(start)));
  session.Timeline().SnapToBest();
  CHECK(session.Doc().timeline[1].start_step == scores.Steps()[40]);

  map(2.0f, 40, 3.0f);
  const std::string before = State(session);
  CHECK(session.Timeline().MapComplete());
  session.Timeline().SnapToBest();
  CHECK(session.Notice() == "There is no good moment for this switch.");
  CHECK(State(session) == before);
}

TEST_CASE("transition scores: one verdict on a share", "[shell][session][timeline]") {
  CHECK(VerdictOn(1.2f) == Takeover::kGood);
  CHECK(VerdictOn(0.8f) == Takeover::kGood);
  CHECK(VerdictOn(0.79f) == Takeover::kFair);
  CHECK(VerdictOn(0.49f) == Takeover::kPoor);
  CHECK(VerdictOn(kVoidScore) == Takeover::kPoor);
}

TEST_CASE("transition scores: lesson 7's nearest good moment reaches its goal",
          "[shell][session][timeline]") {
  Document d = *DecodeJson(gaitsmith::test::ReadFile("examples/lessons/7-takeover.json"));
  const Document request = TransitionRequest(d, 1);
  const TransitionMap map = TransitionMapOf(request);
  TransitionScores scores;
  scores.Begin(d, 1);
  const int generation = scores.Start();
  REQUIRE(scores.Take({.generation = generation,
                       .first = 0,
                       .usual = map.UsualScore(),
                       .scores = map.Scores(0, map.Count())}));
  const int start = d.timeline[1].start_step;
  CHECK(VerdictOn(*scores.Share(scores.Nearest(start))) == Takeover::kPoor);
  const int good = scores.NearestGood(start);
  REQUIRE(good >= 0);
  d.timeline[1].start_step = scores.Steps()[static_cast<std::size_t>(good)];
  const Motion motion = Simulate(d);
  CHECK(motion.TermsAt(motion.Frames() - 1).travel_m >= 25.0f);
}

TEST_CASE("session: a transition map restarts when its inputs change", "[shell][session][timeline]") {
  QuietHost host;
  Session session(host);
  session.Timeline().AddClip();
  session.Timeline().Transitions().Advance(1.0);
  REQUIRE(host.mapped.size() == 1);
  session.Set([](Document& d) { d.search.seed = 99; });
  session.SetView([](View& view) { view.trail = !view.trail; });
  CHECK(host.map_stops == 0);
  session.Change([](Document& d) { d.environment.gravity_mps2 = 5.0f; });
  CHECK(host.map_stops == 1);
  session.Timeline().Transitions().OnScores(
      {.generation = host.generations[0], .first = 0, .usual = 1.0f, .scores = {1.0f}});
  CHECK(session.Timeline().Transitions().Scores().Known() == 0);
  session.Timeline().Transitions().Advance(1.0);
  REQUIRE(host.mapped.size() == 2);
  CHECK(host.generations[1] != host.generations[0]);
  session.Timeline().Transitions().OnFailed(host.generations[0]);
  CHECK(session.Notice().empty());
  session.Timeline().Transitions().OnFailed(host.generations[1]);
  CHECK(session.Notice().starts_with("The transition map could not"));
  session.Timeline().Transitions().Advance(1.0);
  CHECK(host.mapped.size() == 2);
  session.Timeline().Select(0);
  CHECK_FALSE(session.Timeline().Transitions().Scores().Any());
  // A search of the shown motion keeps changing it.
  session.Search().Synthesize();
  session.Timeline().Select(1);
  session.Timeline().Transitions().Advance(1.0);
  CHECK(host.mapped.size() == 2);
  session.Stop();
  session.Timeline().Transitions().Advance(1.0);
  CHECK(host.mapped.size() == 3);
}

TEST_CASE("timeline: inserting a result ends a search that adds to the results",
          "[shell][session][timeline]") {
  QuietHost host;
  Session session(host);
  session.Search().Synthesize();
  End(session, host, 20000);
  const std::string id = session.Results().Motions().Sorted(FoundMotions::Order::kNewest).front()->id;
  session.Set([](Document& d) { d.search.seed += 1; });
  session.Search().Synthesize();
  SearchProgress found{
      .state = SearchState::kRunning, .evaluations = 9, .budget = 50, .curve = {}, .best_genome = {}};
  found.best_genome.assign(ProblemOf(host.started.back()).Shape().Genes(), 30000);
  found.best_fitness = 2.0f;
  session.OnSearchProgress(found);
  REQUIRE(session.Timeline().InsertFound(id, 100));
  CHECK_FALSE(session.Search().Running());
  CHECK(session.Results().Motions().Count() == 2);
  CHECK(Validate(session.Doc()));
}

}  // namespace gaitsmith::shell::test
