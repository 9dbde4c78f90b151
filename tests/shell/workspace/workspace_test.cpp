// SPDX-License-Identifier: MIT
// The interface between the parts of a session: callbacks after changes of the document, and the parts' own
// state.
#include "shell/workspace/workspace.h"

#include <catch_amalgamated.hpp>
#include <string>
#include <vector>

#include "shell/session/world_editor.h"
#include "shell/workspace/shipped_documents.h"
#include "tests/shell/session/quiet_host.h"

namespace gaitsmith::shell::test {
namespace {

// Records the calls of followers and host in one list.
class RecordingHost final : public Host {
 public:
  [[nodiscard]] int MaxWorkers() const override { return 1; }
  void StartSearch(const Document&, int) override {}
  void StartTrial(const Document&, int, const TrialWords&) override {}
  void PauseSearch() override {}
  void ResumeSearch() override {}
  void StopSearch() override {}
  void StartTransitionMap(const Document&, int) override {}
  void StartPlan(const Document&, int) override {}
  void StopPlan() override {}
  void StopTransitionMap() override {}
  void Status(const std::string&) override { calls.emplace_back("status"); }
  void SaveText(const std::string&, const std::string&) override {}
  void DocumentChanged(const std::string&) override { calls.emplace_back("host"); }

  [[nodiscard]] std::vector<std::string> Take() { return std::exchange(calls, {}); }
  std::vector<std::string> calls;
};

using Calls = std::vector<std::string>;

Workspace::Followers Noting(RecordingHost& host) {
  return {.motion = [&host](bool opened) { host.calls.emplace_back(opened ? "opened" : "motion"); },
          .settings = [&host] { host.calls.emplace_back("settings"); },
          .edited = [&host](Parts) { host.calls.emplace_back("edited"); }};
}

}  // namespace

TEST_CASE("workspace: followers are called before the host, and only for relevant changes",
          "[shell][session]") {
  RecordingHost host;
  Workspace workspace(host);
  workspace.SetFollowers(Noting(host));
  workspace.Show(*ShippedDocuments().Motion("star-man-shuffle"), true);
  CHECK(host.Take() == Calls{"opened", "host"});
  REQUIRE(workspace.Change([](Document& d) { d.environment.friction = 0.25f; }));
  CHECK(host.Take() == Calls{"status", "motion", "host", "edited"});  // the status line is cleared first
  REQUIRE(workspace.Change([](Document& d) { d.environment.friction = 0.25f; }));  // no change
  CHECK(host.Take().empty());
  REQUIRE(workspace.Set([](Document& d) { ++d.search.seed; }));
  CHECK(host.Take() == Calls{"status", "settings", "host", "edited"});
  workspace.SetView([](View& view) { view.trail = !view.trail; });
  CHECK(host.Take() == Calls{"host"});
  workspace.SelectClip(1000);
  CHECK(host.Take() == Calls{"settings"});
  CHECK(workspace.SelectedClip() == static_cast<int>(workspace.Doc().timeline.size()) - 1);

  // An invalid or locked edit is refused with a sentence and changes nothing.
  const float friction = workspace.Doc().environment.friction;
  CHECK_FALSE(workspace.Change([](Document& d) { d.environment.friction = -1.0f; }));
  CHECK(host.Take() == Calls{"status"});
  workspace.Layout().locked[static_cast<std::size_t>(LockedPart::kWorld)] = true;
  CHECK_FALSE(workspace.Change([](Document& d) { d.environment.friction = 0.5f; }));
  CHECK(host.Take() == Calls{"status"});
  CHECK_FALSE(workspace.Notice().empty());
  CHECK(workspace.Doc().environment.friction == friction);
}

TEST_CASE("workspace: changes on one occasion are one step", "[shell][session]") {
  RecordingHost host;
  Workspace workspace(host);
  workspace.SetFollowers(Noting(host));
  workspace.Show(*ShippedDocuments().Motion("star-man-shuffle"), true);
  const float before = workspace.Doc().environment.friction;
  for (const float friction : {0.1f, 0.2f, 0.3f})
    REQUIRE(workspace.Change([&](Document& d) { d.environment.friction = friction; }));
  const auto back = workspace.TakeBack();
  REQUIRE(back);
  CHECK(back->environment.friction == before);
  CHECK_FALSE(workspace.TakeBack());
}

TEST_CASE("world: a reset restores the world of the document opened last", "[shell][session]") {
  QuietHost host;
  Session session(host);
  const Environment opened = session.Doc().environment;
  CHECK_FALSE(session.World().Changed());
  REQUIRE(session.World().Push(kCentreOfMass, 3.0f, 1.0f));
  REQUIRE(session.Change([](Document& d) { d.environment.gravity_mps2 = 1.5f; }));
  CHECK(session.World().Changed());
  session.World().Reset();
  CHECK(session.Doc().environment == opened);
  CHECK(session.Doc().pushes.empty());
  CHECK_FALSE(session.World().Changed());

  Document other = session.Doc();
  other.environment.gravity_mps2 = 2.5f;
  session.ChooseExample(other);
  CHECK_FALSE(session.World().Changed());
  CHECK(session.World().AsOpened().environment.gravity_mps2 == 2.5f);
}

TEST_CASE("session: after a search loses its document, the queue resumes once", "[shell][session]") {
  QuietHost host;
  Session session(host);
  session.Search().Synthesize();
  REQUIRE(session.Queue().Add(session.Doc()));
  session.New();
  CHECK_FALSE(session.Search().Running());
  CHECK(session.Search().WasInterrupted());
  CHECK(host.started.size() == 1);
  session.Queue().Resume();
  CHECK(host.started.size() == 2);
  CHECK(session.Search().RunsQueued());
  CHECK_FALSE(session.Search().WasInterrupted());

  // A search that a person stops does not start the next one.
  REQUIRE(session.Queue().Add(session.Doc()));
  session.Stop();
  session.Queue().Resume();
  CHECK(host.started.size() == 2);
}

TEST_CASE("session: what begins without a motion begins with the quick search", "[shell][session]") {
  QuietHost host;
  Session session(host);
  const auto quick = [&] {
    const SearchSettings& search = session.Doc().search;
    return search.algorithm == Algorithm::kPoseCycle && search.evaluations == 4000;
  };
  CHECK(quick());
  CHECK_FALSE(session.DiffersFromMaker());
  session.ChooseProblem(0);
  CHECK(session.Doc().search.algorithm == Algorithm::kSphc);  // the paper's problems keep the paper's search
  session.New();
  CHECK(quick());
  session.ChooseProblem(0);
  Figure own = session.Doc().figure;
  own.name = "Nobody's";
  session.ReplaceFigure(own);
  CHECK(session.Doc().search.algorithm == Algorithm::kSphc);
}

}  // namespace gaitsmith::shell::test
