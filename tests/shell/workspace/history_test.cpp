// SPDX-License-Identifier: MIT
// Undo and Redo: the extent of a step, what is never lost, and the bounds.
#include "shell/workspace/history.h"

#include <algorithm>
#include <catch_amalgamated.hpp>

#include "core/document/binary.h"
#include "core/document/json.h"
#include "shell/session/commands.h"
#include "shell/workspace/panels.h"
#include "tests/scene.h"
#include "tests/shell/session/quiet_host.h"

namespace gaitsmith::shell::test {

namespace {

Document StarManOn(float friction) {
  Document document;
  document.title = "History";
  document.figure = gaitsmith::test::ShippedFigure("mr-star-man");
  document.environment.friction = friction;
  return document;
}

void SetFriction(Session& session, float friction) {
  REQUIRE(session.Change([friction](Document& d) { d.environment.friction = friction; }));
}

// A genome that the document's search could have found.
SearchProgress Found(const Session& session, std::uint16_t gene, SearchState state) {
  SearchProgress progress{.state = state, .budget = 100, .curve = {}, .best_genome = {}};
  progress.best_genome.assign(static_cast<std::size_t>(SpaceOf(session.Doc()).shape.Genes()), gene);
  return progress;
}

}  // namespace

TEST_CASE("history: undoes and redoes every step in order, up to both ends", "[shell][history]") {
  History history;
  Document present = StarManOn(0.3f);
  for (int i = 1; i <= 3; ++i) {
    history.Keep(present, i);
    present.environment.friction += 0.125f;
  }
  const float last = present.environment.friction;
  for (int i = 2; i >= 0; --i) {
    CAPTURE(i);
    REQUIRE(history.CanUndo(present));
    present = *history.Back(present);
    CHECK(present.environment.friction == 0.3f + 0.125f * static_cast<float>(i));
  }
  CHECK_FALSE(history.CanUndo(present));
  CHECK_FALSE(history.Back(present));
  for (int i = 1; i <= 3; ++i) present = *history.Forward(present);
  CHECK(present.environment.friction == last);
  CHECK_FALSE(history.CanRedo());
}

TEST_CASE("history: changes on one occasion are one step", "[shell][history]") {
  History history;
  Document present = StarManOn(0.3f);
  for (int i = 0; i < 10; ++i) {
    history.Keep(present, 7);
    present.environment.friction += 0.03f;
  }
  CHECK(history.Back(present)->environment.friction == 0.3f);
  CHECK_FALSE(history.CanUndo(StarManOn(0.3f)));
}

TEST_CASE("history: a drag that ends where it began is no step", "[shell][history]") {
  History history;
  history.Keep(StarManOn(0.3f), 1);  // to 0.4
  history.Keep(StarManOn(0.4f), 2);  // away and back
  CHECK(history.Back(StarManOn(0.4f))->environment.friction == 0.3f);
}

TEST_CASE("history: the stored steps are the nearest ones that fit", "[shell][history]") {
  History history;
  Document present = StarManOn(0.3f);
  for (int i = 1; i <= 4; ++i) {
    history.Keep(present, i);
    present.environment.friction += 0.125f;
  }
  present = *history.Back(present);
  const History::Stored all = history.Store(1'000'000);
  REQUIRE(all.past.size() == 3);
  REQUIRE(all.future.size() == 1);

  History restored;
  REQUIRE(restored.Restore(all));
  CHECK(restored.Forward(present)->environment.friction == 0.8f);
  History shorter;
  REQUIRE(shorter.Restore(history.Store(2 * all.past.back().size() + 1)));
  CHECK_FALSE(shorter.CanRedo());
  CHECK(shorter.Back(present)->environment.friction == 0.55f);
  CHECK(shorter.Back(StarManOn(0.55f))->environment.friction == 0.425f);
  CHECK_FALSE(shorter.Back(StarManOn(0.425f)));
}

TEST_CASE("history: damaged steps change nothing", "[shell][history]") {
  History history;
  history.Keep(StarManOn(0.3f), 1);
  History::Stored damaged = history.Store(1'000'000);
  damaged.future.push_back(damaged.past.front());
  damaged.future.front().pop_back();
  history.Keep(StarManOn(0.4f), 2);
  CHECK_FALSE(history.Restore(damaged));
  CHECK_FALSE(history.CanRedo());
  CHECK(history.Back(StarManOn(0.5f))->environment.friction == 0.4f);
}

TEST_CASE("history: Undo does not change the view", "[shell][history]") {
  History history;
  Document present = StarManOn(0.3f);
  history.Keep(present, 1);
  present.environment.friction = 0.7f;
  present.view.panel = 3;
  present.view.trail = false;
  const Document before = *history.Back(present);
  CHECK(before.view.panel == 3);
  CHECK_FALSE(before.view.trail);
  Document viewed = StarManOn(0.3f);
  viewed.view.speed = 2.0f;
  CHECK_FALSE(history.CanUndo(viewed));
}

TEST_CASE("history: bounded in steps and in bytes, removing the oldest first", "[shell][history]") {
  const std::size_t bytes = EncodeBinary(StarManOn(0.3f)).size();
  const bool by_steps = GENERATE(true, false);
  CAPTURE(by_steps);
  History history(by_steps ? History::Limits{.steps = 5, .bytes = 1000 * bytes}
                           : History::Limits{.steps = 1000, .bytes = 5 * bytes + bytes / 2});
  for (int i = 0; i < 20; ++i) history.Keep(StarManOn(0.25f + 0.03125f * static_cast<float>(i)), i + 1);
  Document present = StarManOn(0.25f + 0.03125f * 20.0f);
  int steps = 0;
  for (; history.CanUndo(present); ++steps) present = *history.Back(present);
  CHECK(steps == 5);
  CHECK(present.environment.friction == 0.25f + 0.03125f * 15.0f);
}

TEST_CASE("history: a document larger than the limit can still be restored", "[shell][history]") {
  History history({.steps = 5, .bytes = 1});
  history.Keep(StarManOn(0.3f), 1);
  history.Keep(StarManOn(0.4f), 2);
  CHECK(history.Back(StarManOn(0.5f))->environment.friction == 0.4f);
}

TEST_CASE("session: undoing and redoing three edits yields the same documents, bit for bit",
          "[shell][session]") {
  QuietHost host;
  Session session(host);
  std::vector<std::string> states = {State(session)};
  std::vector<std::uint64_t> hashes = {session.Player().Shown().Hash()};
  const auto edit = [&](auto&& body) {
    session.BeginGesture();
    body();
    states.push_back(State(session));
    hashes.push_back(session.Player().Shown().Hash());
    REQUIRE(states.back() != states[states.size() - 2]);
  };
  edit([&] { SetFriction(session, 0.3f); });
  edit([&] { REQUIRE(session.Set([](Document& d) { d.task.weights[1] = -0.5f; })); });
  edit([&] { session.ChooseProblem(1); });
  edit([&] { session.New(); });
  for (std::size_t i = states.size() - 1; i-- > 0;) {
    CAPTURE(i, host.status);
    session.Undo();
    CHECK(State(session) == states[i]);
    CHECK(session.Player().Shown().Hash() == hashes[i]);
  }
  CHECK_FALSE(session.CanUndo());
  for (std::size_t i = 1; i < states.size(); ++i) {
    CAPTURE(i, host.status);
    session.Redo();
    CHECK(State(session) == states[i]);
    CHECK(session.Player().Shown().Hash() == hashes[i]);
  }
  CHECK_FALSE(session.CanRedo());
}

TEST_CASE("session: a drag is one step, a change of the view is none, and a new edit clears Redo",
          "[shell][session]") {
  QuietHost host;
  Session session(host);
  const auto before = State(session);
  session.BeginGesture();
  for (const float friction : {0.7f, 0.6f, 0.5f}) SetFriction(session, friction);
  session.SetView([](View& view) { view.panel = 3; });
  session.Undo();
  CHECK(session.Doc().view.panel == 3);
  CHECK(State(session) == before);
  CHECK_FALSE(session.CanUndo());
  CHECK(session.CanRedo());
  session.BeginGesture();
  SetFriction(session, 0.2f);
  CHECK_FALSE(session.CanRedo());
}

TEST_CASE("session: the result of a search is one step, separate from edits during the search",
          "[shell][session]") {
  QuietHost host;
  Session session(host);
  const auto before = State(session);
  session.BeginGesture();
  session.Search().Synthesize();
  CHECK_FALSE(session.CanUndo());  // the document has not changed yet
  session.OnSearchProgress(Found(session, 20000, SearchState::kRunning));
  REQUIRE(session.Search().ShowImprovement(10.0));
  session.OnSearchProgress(Found(session, 30000, SearchState::kRunning));
  REQUIRE(session.Search().ShowImprovement(10.0));
  const auto found = State(session);
  session.BeginGesture();
  SetFriction(session, 0.3f);
  session.OnSearchProgress(Found(session, 40000, SearchState::kDone));
  CHECK(session.Doc().environment.friction == 0.3f);
  session.Undo();  // the end of the search
  session.Undo();  // friction
  CHECK(State(session) == found);
  session.Undo();
  CHECK(State(session) == before);
  CHECK_FALSE(session.CanUndo());
}

TEST_CASE("session: Undo while a search has found nothing only stops the search", "[shell][session]") {
  QuietHost host;
  Session session(host);
  SetFriction(session, 0.3f);
  const auto before = State(session);
  session.Search().Synthesize();
  session.SetView([](View& view) { view.trail = !view.trail; });
  session.Undo();
  CHECK(State(session) == before);
  CHECK(host.stops == 1);
  CHECK_FALSE(session.Search().Running());
  CHECK(session.CanUndo());
}

TEST_CASE("session: opening is a step, and an invalid document changes nothing", "[shell][session]") {
  QuietHost host;
  Session session(host);
  const auto before = State(session);
  CHECK_FALSE(session.Open("{\"title\": 7}"));
  CHECK(State(session) == before);
  CHECK_FALSE(session.CanUndo());
  REQUIRE(session.Open(EncodeJson(StarManOn(0.3f))));
  session.Undo();
  CHECK(session.Doc().title != "History");
  session.Redo();
  CHECK(session.Doc().title == "History");
  session.ForgetPast();
  CHECK_FALSE(session.CanUndo());
}

TEST_CASE("session: New opens the Search panel, and Undo restores the previous document",
          "[shell][session]") {
  QuietHost host;
  Session session(host);
  session.SetView([](View& view) {
    view.panel = static_cast<int>(Panel::kLab);
    view.trail = false;
  });
  const auto before = State(session);
  session.BeginGesture();
  session.New();
  CHECK(session.Doc().controllers.empty());
  CHECK(session.Doc().view.panel == static_cast<int>(Panel::kSearch));
  CHECK_FALSE(session.Doc().view.trail);
  CHECK(host.status.find("Undo restores") != std::string::npos);
  session.Undo();
  CHECK(State(session) == before);
}

TEST_CASE("commands: keys and names are unique, and every available command runs without harm",
          "[shell][commands]") {
  QuietHost host;
  Session session(host);
  std::vector<std::string> ids;
  std::vector<std::string> keys;
  std::vector<Command> all = CommandsOf(session, true);
  for (Command& command : ShelfOf(session)) all.push_back(std::move(command));
  for (const Command& command : all) {
    CAPTURE(command.id);
    CHECK_FALSE(command.title.empty());
    CHECK(std::ranges::find(ids, command.id) == ids.end());
    ids.push_back(command.id);
    for (const std::string& key : command.keys) {
      CAPTURE(key);
      CHECK(std::ranges::find(keys, key) == keys.end());
      keys.push_back(key);
    }
    if (command.why_not.empty()) command.run();
    CHECK(Validate(session.Doc()));
  }
  CHECK(std::ranges::find(ids, "example/star-man-shuffle") != ids.end());
  REQUIRE_FALSE(LockParts("figure,style,timeline", session.Layout()));
  std::vector<Command> locked = CommandsOf(session, true);
  for (Command& command : ShelfOf(session)) locked.push_back(std::move(command));
  for (const Command& command : locked) {
    CAPTURE(command.id);
    const bool changes = command.id.starts_with("timeline/") || command.id.starts_with("task/") ||
                         command.id.starts_with("figure/");
    CHECK((command.why_not == Tr("Locked here: read only.")) == changes);
  }
  CHECK(CommandsOf(session, false).size() + 1 == CommandsOf(session, true).size());  // the timeline's panel
}

}  // namespace gaitsmith::shell::test
